/** The pixels of a render target on the CPU, and back. */
#ifndef VITRINE_GL_TARGET_PIXELS_H
#define VITRINE_GL_TARGET_PIXELS_H

#include "gl/GLObjects.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLState;

namespace vitrine
{

struct RenderTarget;

/**
 * Reads and writes colours and depths of single-sampled targets, by rows from the bottom. Each value survives a way
 * there and back to the bit.
 *
 * A pixel's colour is one word of 4 bytes in targets of 8 bits a channel, and 4 floats in others. A depth is a word:
 * the bits of a float, or an integer, of which 0xffffffff is the farthest.
 */
class TargetPixels
{
public:
  ///@{
  /** Returns the words of a pixel's colour, 1 or 4, and the type of its channels. */
  static int ColorWords(const RenderTarget& target);
  static GLenum ColorType(const RenderTarget& target);
  ///@}

  /** Returns the word of the farthest depth. Samples have floats. */
  static std::uint32_t Farthest(const RenderTarget& target);

  ///@{
  /** Read all pixels of the target. Waits for the device. Changes the binding of the framebuffer that is read. */
  static std::vector<std::uint32_t> ReadColors(vtkOpenGLState* state, const RenderTarget& target);
  static std::vector<std::uint32_t> ReadDepths(vtkOpenGLState* state, const RenderTarget& target);
  ///@}

  ///@{
  /**
   * Write the pixels of the target's region. `words` are those of all pixels. Changes the framebuffer bindings and the
   * scissor test. Returns an error message, empty on success.
   */
  std::string WriteColors(
    vtkOpenGLState* state, const RenderTarget& target, const std::vector<std::uint32_t>& words);
  std::string WriteDepths(
    vtkOpenGLState* state, const RenderTarget& target, const std::vector<std::uint32_t>& words);
  ///@}

  std::int64_t Bytes() const { return this->Colors.Bytes() + this->Depths.Bytes(); }
  void Release();

private:
  Image2D Colors;
  Image2D Depths;
  Framebuffer ColorTarget;
  Framebuffer DepthTarget;
};

}
#endif
