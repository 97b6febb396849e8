#include "gl/StateRecord.h"

namespace vitrine
{
namespace
{

// Equals no buffer, so that no call which sets one is skipped.
constexpr unsigned int UnknownBuffer = GL_INVALID_INDEX;

}

void BindForDrawing(vtkOpenGLState* state, GLuint framebuffer)
{
  auto& bound = StateRecord::Of(state).DrawBinding;
  if (bound.Binding != framebuffer)
  {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    bound.Binding = framebuffer;
    bound.DrawBuffers[0] = UnknownBuffer;
  }
}

void BindForReading(vtkOpenGLState* state, GLuint framebuffer)
{
  auto& bound = StateRecord::Of(state).ReadBinding;
  if (bound.Binding != framebuffer)
  {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    bound.Binding = framebuffer;
    bound.ReadBuffer = UnknownBuffer;
  }
}

}
