/** A copy of a render target's colours, which a resolve reads while it writes the target. */
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
   * Copy the colours of the target's region, sample by sample. Changes the framebuffer bindings. Returns an error
   * message if the driver cannot hold the copy, else an empty string.
   */
  std::string Copy(vtkOpenGLState* state, const RenderTarget& target);

  /** Put the copied colours back into the target. Changes the framebuffer bindings and the scissor test. */
  void PutBack(vtkOpenGLState* state, const RenderTarget& target);

  void Release();

  /** The copy. It has the target's size, samples and format. */
  const Image2D& Image() const { return this->Colors; }

private:
  Image2D Colors;
  Framebuffer Target;
};

}
#endif
