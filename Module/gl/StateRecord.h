/** The state that vtkOpenGLState has recorded. It tells only a part by itself. */
#ifndef VITRINE_GL_STATE_RECORD_H
#define VITRINE_GL_STATE_RECORD_H

#include "gl/VitrineOpenGL.h"
#include "vtkOpenGLState.h"

#include <vector>

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

///@{
/**
 * Set the draw buffers of the framebuffer that is bound for drawing, or the read buffer of that for reading. OpenGL is
 * called in any case: vtkOpenGLState may take a call to be redundant, since its record of draw buffers after the first
 * is not kept for each framebuffer.
 */
void SetDrawBuffers(vtkOpenGLState* state, const std::vector<GLenum>& buffers);
void SetReadBuffer(vtkOpenGLState* state, GLenum buffer);
///@}

}
#endif
