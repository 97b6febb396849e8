/** Upper bounds of the errors of a frame's pixels, which the resolve writes (Shaders/ErrorBound.glsl). */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_ERROR_BOUNDS_H
#define VITRINE_TRANSPARENCY_ABUFFER_ERROR_BOUNDS_H

#include "gl/GLObjects.h"
#include "gl/ScopedState.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkShaderProgram;

namespace vitrine
{

struct RenderTarget;
struct VitrineErrorBounds;

class ErrorBounds
{
public:
  /**
   * Set what frames do: the bound of a pixel that they tolerate, and whether the bounds of all pixels are kept. Above
   * 0, `fixedBound` bounds what is stored in all pixels alike, and no pixel computes it.
   */
  void Ask(double tolerated, bool keepsPixels, double fixedBound)
  {
    this->Tolerated = tolerated;
    this->KeepsPixels = keepsPixels;
    this->FixedBound = fixedBound;
  }
  bool HasFixedBound() const { return this->FixedBound > 0.0; }

  /** Begin a frame whose resolve writes bounds. Returns an error message, empty on success. */
  std::string Begin(const RenderTarget& target);

  void SetUniforms(vtkShaderProgram* program) const;

  /** Read the largest bound of the frame that is not tolerated, or 0. Waits for the device. */
  double ReadLargest() const;

  /** Read how many fragments a frame that was not cut has behind the depths that hide them. Waits for the device. */
  std::int64_t ReadHidden() const;

  /** Read the bounds of all pixels by rows from the bottom. There are none if they were not kept. */
  std::vector<float> ReadPixels() const;

  ///@{
  /** GL names. They are 0 for what is not kept. */
  GLuint LargestBuffer() const { return this->Largest.Handle(); }
  GLuint PixelsTexture() const { return this->Pixels.Texture(); }
  ///@}

  std::int64_t Bytes() const { return this->Pixels.Bytes() + this->Largest.Bytes(); }

  void Release();

private:
  VitrineErrorBounds Read() const;

  double Tolerated = 1.0;
  bool KeepsPixels = false;
  double FixedBound = 0.0;
  int Row = 0;    // Pixels of a row, or 0 if the bounds of the last frame's pixels are not kept.
  Buffer Largest; // VitrineErrorBounds
  Buffer Pixels;
};

/** Binds the buffers that the resolve writes while the object lives. */
class ScopedErrorBounds
{
public:
  explicit ScopedErrorBounds(const ErrorBounds& bounds);

private:
  ScopedStorageBuffer Largest;
  ScopedImage Pixels;
};

}
#endif
