/** The state that vtkOpenGLState has recorded. It tells only a part by itself. */
#ifndef VITRINE_GL_STATE_RECORD_H
#define VITRINE_GL_STATE_RECORD_H

#include "gl/VitrineOpenGL.h"
#include "vtkOpenGLState.h"

namespace vitrine
{

/** Gives access to the record, so that OpenGL need not be asked for tracked state. */
class StateRecord : private vtkOpenGLState
{
public:
  static auto& Of(vtkOpenGLState* state) { return (state->*(&StateRecord::Stack)).top(); }
};

///@{
/**
 * Bind a framebuffer, as vtkglBindFramebuffer() does, without asking OpenGL for its draw or read buffer: those remain
 * unknown to vtkOpenGLState until it restores other bindings. A VTK that checks its record is told them. A
 * ScopedTrackedState lives around the calls.
 */
void BindForDrawing(vtkOpenGLState* state, GLuint framebuffer);
void BindForReading(vtkOpenGLState* state, GLuint framebuffer);
///@}

}
#endif
