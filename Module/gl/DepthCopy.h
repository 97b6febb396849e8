/** A copy of a render target's depth for shaders to read. It is made in frames in which a shader asks for it. */
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
   * Returns the texture unit to which the copy is bound in this frame, or -1 on failure; see Problem().
   * The first call of a frame copies the depth of the target's region, sample by sample. The copy is a texture of the
   * target's size and format. With RenderTarget::DepthIntegers it is a buffer texture of 32-bit unsigned integers, one
   * for each pixel of the target, row by row.
   */
  int UnitOf(vtkOpenGLState* state, const RenderTarget& target);

  /** Returns why the driver could not hold this frame's copy. It is empty if it could, or if no copy was asked for. */
  const std::string& Problem() const { return this->WhyNone; }

  /** Release the texture unit. The next frame copies again. */
  void EndFrame();

  /** Bytes of GPU memory that the copy holds. */
  std::int64_t Bytes() const { return this->Depth.Bytes() + this->Integers.Bytes(); }

  void Release();

private:
  std::string CopyImage(vtkOpenGLState* state, const RenderTarget& target);
  std::string CopyIntegers(vtkOpenGLState* state, const RenderTarget& target);

  Image2D Depth;
  Framebuffer Target; // Framebuffer of Depth.
  Buffer Integers;
  std::unique_ptr<ScopedTextureUnit> Binding;
  std::string WhyNone;
};

}
#endif
