/**
 * A copy of what stands in a render target, for a resolve to read while it writes the target.
 */
#ifndef VITRINE_GL_BACKDROP_COPY_H
#define VITRINE_GL_BACKDROP_COPY_H

#include "gl/GLObjects.h"

#include <string>

class vtkOpenGLState;

namespace vitrine
{

struct RenderTarget;

class BackdropCopy
{
public:
  /**
   * Copy the colours of the target's region, sample by sample. Changes the framebuffer bindings. Returns an empty
   * string, or why the driver cannot hold a copy.
   */
  std::string Copy(vtkOpenGLState* state, const RenderTarget& target);

  /** Put the copied colours back into the target. Changes the framebuffer bindings and the scissor test. */
  void PutBack(vtkOpenGLState* state, const RenderTarget& target);

  void Release();

  /** The copy: the target's size, samples and format. */
  const Image2D& Image() const { return this->Colors; }

private:
  Image2D Colors;
  Framebuffer Target;
};

}
#endif
