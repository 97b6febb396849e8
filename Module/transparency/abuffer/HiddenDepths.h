/**
 * Depths behind which pixels hide all but a little light (Shaders/HiddenDepth.glsl). A frame finds them, and the next
 * frame stores nothing behind them.
 *
 * If the view has not moved, they hold for the pixels themselves. Else each block of pixels has the farthest depth of
 * its pixels and of the eight blocks around it, so that the picture may move by a block.
 */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_HIDDEN_DEPTHS_H
#define VITRINE_TRANSPARENCY_ABUFFER_HIDDEN_DEPTHS_H

#include "gl/ComputeProgram.h"
#include "gl/GLObjects.h"
#include "gl/ProgramCache.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"

#include <array>
#include <cstdint>
#include <string>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace vitrine
{

class HiddenDepths
{
public:
  HiddenDepths();

  /** Set the light below which a pixel counts as hiding what is behind. */
  void SetLight(double light) { this->Light = light; }

  /**
   * Begin a frame whose resolve finds depths. With `cuts`, the depths of the last frame of the same target, if there
   * are any, cut this frame: `fill` becomes the target with a depth of its own, which holds them. Changes the
   * framebuffer binding and the state of draws. Returns an error message, empty on success.
   */
  std::string Begin(vtkOpenGLRenderWindow* window, const RenderTarget& target, bool cuts,
    bool moved, RenderTarget& fill);

  /** Returns true if the frame that was begun last is cut. */
  bool Cuts() const { return this->Block > 0; }

  /** End a frame that was resolved. Its depths may cut the next one. */
  void EndFrame() { this->HasLast = true; }

  /** Forget the depths of the last frame. */
  void Forget() { this->HasLast = false; }

  GLuint NextTexture() const { return this->Words[this->Next].Texture(); }
  GLuint NowTexture() const { return this->Now ? this->Now->Texture() : 0; }
  void SetUniforms(vtkShaderProgram* program, int unitOfNow) const;

  bool HasFailed() const { return this->Spread.HasFailed() || this->Cut.HasFailed(); }
  std::int64_t Bytes() const;
  void Release();

private:
  bool Reserve(const RenderTarget& target);
  bool SpreadWords(vtkOpenGLRenderWindow* window);
  bool RunSpread(vtkOpenGLRenderWindow* window, const Buffer& in, const std::array<int, 2>& sizeIn,
    const Buffer& out, const std::array<int, 2>& sizeOut, int pixelsOfBlock);
  std::string DrawCut(
    vtkOpenGLRenderWindow* window, const RenderTarget& target, RenderTarget& fill);

  double Light = 0.0;
  bool HasLast = false;
  int Next = 0;  // The buffer of words that the resolve writes.
  int Block = 0; // Pixels of a side for which Now has a word, or 0.
  int Row = 0;   // Words of a row of Now.
  const Buffer* Now = nullptr;
  std::array<int, 2> Size{};
  std::array<int, 2> Blocks{};
  std::array<Buffer, 2> Words;      // A word for each pixel: of the last frame and of this one.
  std::array<Buffer, 2> BlockWords; // Of blocks, and of blocks with their neighbours.
  ComputeProgram Spread;
  ProgramCache Cut;
  EmptyVertexArray VertexArray;
  Image2D Depth;
  Framebuffer Target;
};

/** Binds what the resolve reads and writes while the object lives. */
class ScopedHiddenDepths
{
public:
  ScopedHiddenDepths(vtkOpenGLState* state, const HiddenDepths& depths);
  void SetUniforms(vtkShaderProgram* program) const;

private:
  const HiddenDepths& Depths;
  ScopedImage Next;
  ScopedTextureUnit Now;
};

}
#endif
