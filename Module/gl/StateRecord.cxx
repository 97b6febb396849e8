#include "gl/StateRecord.h"

namespace vitrine
{
namespace
{

/** What is recorded of the draw or read buffer of the framebuffer that is bound. */
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

void SetDrawBuffers(vtkOpenGLState* state, const std::vector<GLenum>& buffers)
{
  glDrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
  StateRecord::Of(state).DrawBinding.DrawBuffers[0] = BufferOfBound(GL_DRAW_BUFFER);
}

void SetReadBuffer(vtkOpenGLState* state, GLenum buffer)
{
  glReadBuffer(buffer);
  StateRecord::Of(state).ReadBinding.ReadBuffer = BufferOfBound(GL_READ_BUFFER);
}

}
