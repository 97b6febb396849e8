#include "gl/StateRecord.h"

namespace vitrine
{
namespace
{

/** What is recorded of the draw or read buffer of a framebuffer that was bound just now. */
unsigned int BufferOfBound([[maybe_unused]] GLenum which)
{
#ifdef VITRINE_VTK_CHECKS_STATE
  GLint buffer = 0;
  glGetIntegerv(which, &buffer);
  return static_cast<unsigned int>(buffer);
#else
  return GL_INVALID_INDEX; // equals no buffer, so that no call which sets one is skipped
#endif
}

}

void BindForDrawing(vtkOpenGLState* state, GLuint framebuffer)
{
  auto& bound = StateRecord::Of(state).DrawBinding;
  if (bound.Binding != framebuffer)
  {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    bound.Binding = framebuffer;
    bound.DrawBuffers[0] = BufferOfBound(GL_DRAW_BUFFER);
  }
}

void BindForReading(vtkOpenGLState* state, GLuint framebuffer)
{
  auto& bound = StateRecord::Of(state).ReadBinding;
  if (bound.Binding != framebuffer)
  {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    bound.Binding = framebuffer;
    bound.ReadBuffer = BufferOfBound(GL_READ_BUFFER);
  }
}

}
