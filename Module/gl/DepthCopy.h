/**
 * A copy of a render target's depth for shaders to read, made in the frames in which one asks for it.
 */
#ifndef VITRINE_GL_DEPTH_COPY_H
#define VITRINE_GL_DEPTH_COPY_H

#include "gl/GLObjects.h"
#include "gl/ScopedState.h"

#include <memory>
#include <string>

class vtkOpenGLState;

namespace vitrine
{

struct RenderTarget;

class DepthCopy
{
public:
  /**
   * The texture unit where the copy is bound in this frame, or -1, see Problem(). The first call of a frame copies
   * the depth of the target's region, sample by sample: to a texture of the target's size and format, or, where
   * RenderTarget::DepthIntegers, to a buffer texture of the target's pixels in 32-bit unsigned integers, row by row.
   */
  int UnitOf(vtkOpenGLState* state, const RenderTarget& target);

  /** Why the driver could not hold this frame's copy; empty if it could, or had none to make. */
  const std::string& Problem() const { return this->WhyNone; }

  /** Give the texture unit back; the next frame copies anew. */
  void EndFrame();

  /** GPU memory that the copy holds. */
  std::int64_t Bytes() const { return this->Depth.Bytes() + this->Integers.Bytes(); }

  void Release();

private:
  std::string CopyImage(vtkOpenGLState* state, const RenderTarget& target);
  std::string CopyIntegers(vtkOpenGLState* state, const RenderTarget& target);

  Image2D Depth;
  Framebuffer Target; // of Depth
  Buffer Integers;
  std::unique_ptr<ScopedTextureUnit> Binding;
  std::string WhyNone;
};

}
#endif
