/**
 * Scoped keepers of GL state: each reads what is there when it is made and puts that back when it goes.
 */
#ifndef VITRINE_GL_SCOPED_STATE_H
#define VITRINE_GL_SCOPED_STATE_H

#include "gl/VitrineOpenGL.h"
#include "vtkOpenGLState.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace vitrine
{

/** The query that tells which texture is bound to `target` of the active unit. */
GLenum TextureBindingQuery(GLenum target);

/**
 * What vtkOpenGLState tracks and a pass changes: masks, tests, blending, viewport, scissor, framebuffer
 * bindings. Changes go through vtkOpenGLState, so its cache stays true.
 */
class ScopedTrackedState
{
public:
  explicit ScopedTrackedState(vtkOpenGLState* state);
  ~ScopedTrackedState();
  ScopedTrackedState(const ScopedTrackedState&) = delete;
  void operator=(const ScopedTrackedState&) = delete;

private:
  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunc;
  vtkOpenGLState::ScopedglColorMask ColorMask;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunc;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
  vtkOpenGLState::ScopedglEnableDisable StencilTest;
  vtkOpenGLState::ScopedglEnableDisable Multisample;
  vtkOpenGLState::ScopedglActiveTexture ActiveTexture;
};

/** Function, operations and mask of the stencil test, of both faces. */
class ScopedStencil
{
public:
  explicit ScopedStencil(vtkOpenGLState* state);
  ~ScopedStencil();
  ScopedStencil(const ScopedStencil&) = delete;
  void operator=(const ScopedStencil&) = delete;

private:
  struct Face
  {
    GLint Function = 0;
    GLint Reference = 0;
    GLint ValueMask = 0;
    GLint WriteMask = 0;
    GLint Fail = 0;
    GLint DepthFail = 0;
    GLint Pass = 0;
  };
  void PutBack(GLenum which, const Face& face);

  vtkOpenGLState* State;
  Face Front;
  Face Back;
};

/**
 * The draw buffers of the bound framebuffer: what is drawn goes to the first alone, so that the others keep what they
 * have. The same framebuffer must be bound when the keeper goes.
 */
class ScopedFirstDrawBuffer
{
public:
  explicit ScopedFirstDrawBuffer(vtkOpenGLState* state);
  ~ScopedFirstDrawBuffer();
  ScopedFirstDrawBuffer(const ScopedFirstDrawBuffer&) = delete;
  void operator=(const ScopedFirstDrawBuffer&) = delete;

  /** Whether there are others. */
  bool HasOthers() const;

  /** Confine drawing to the first again, after somebody else has set the draw buffers of the same framebuffer. */
  void Confine();

private:
  void Set(std::vector<GLenum> buffers);

  vtkOpenGLState* State;
  std::vector<GLenum> Previous;
  bool Changed = false;
};

/** The read buffer of the framebuffer that is bound for reading, and must be so again when the keeper goes. */
class ScopedReadBuffer
{
public:
  ScopedReadBuffer(vtkOpenGLState* state, GLenum buffer);
  ~ScopedReadBuffer();
  ScopedReadBuffer(const ScopedReadBuffer&) = delete;
  void operator=(const ScopedReadBuffer&) = delete;

private:
  vtkOpenGLState* State;
  GLint Previous = 0;
};

/** Pixels go to and come from client memory, tightly packed, whatever is bound and set for their transfer. */
class ScopedPixelTransfer
{
public:
  ScopedPixelTransfer();
  ~ScopedPixelTransfer();
  ScopedPixelTransfer(const ScopedPixelTransfer&) = delete;
  void operator=(const ScopedPixelTransfer&) = delete;

private:
  static constexpr int Settings = 12;
  GLint Previous[Settings] = {};
  GLint PreviousPack = 0;
  GLint PreviousUnpack = 0;
};

/** The buffer bound for vertex attributes, which VTK's mappers leave changed. */
class ScopedArrayBuffer
{
public:
  ScopedArrayBuffer();
  ~ScopedArrayBuffer();
  ScopedArrayBuffer(const ScopedArrayBuffer&) = delete;
  void operator=(const ScopedArrayBuffer&) = delete;

private:
  GLint Previous = 0;
};

/**
 * The samples that drawing is confined to, which VTK does not track: all of them, until one is chosen, whatever their mask,
 * coverage or the alpha of fragments says.
 */
class ScopedSampleMask
{
public:
  ScopedSampleMask();
  ~ScopedSampleMask();
  ScopedSampleMask(const ScopedSampleMask&) = delete;
  void operator=(const ScopedSampleMask&) = delete;

  /** Confine multisampled drawing to one of the first 32 samples. */
  static void DrawInto(int sample);

private:
  static constexpr int Capabilities = 3;
  GLboolean WereEnabled[Capabilities] = {};
  GLint Previous = 0;
};

/** The bound vertex array, which VTK does not track. */
class ScopedVertexArray
{
public:
  explicit ScopedVertexArray(GLuint vertexArray);
  ~ScopedVertexArray();
  ScopedVertexArray(const ScopedVertexArray&) = delete;
  void operator=(const ScopedVertexArray&) = delete;

private:
  GLint Previous = 0;
};

/** The shader program that VTK's shader cache has bound. */
class ScopedShaderProgram
{
public:
  explicit ScopedShaderProgram(vtkOpenGLRenderWindow* window);
  ~ScopedShaderProgram();
  ScopedShaderProgram(const ScopedShaderProgram&) = delete;
  void operator=(const ScopedShaderProgram&) = delete;

private:
  vtkOpenGLRenderWindow* Window;
  vtkSmartPointer<vtkShaderProgram> Previous;
};

/** An indexed shader storage binding, and the generic one that setting it changes too. */
class ScopedStorageBuffer
{
public:
  ScopedStorageBuffer(GLuint index, GLuint buffer);
  ~ScopedStorageBuffer();
  ScopedStorageBuffer(const ScopedStorageBuffer&) = delete;
  void operator=(const ScopedStorageBuffer&) = delete;

private:
  GLuint Index;
  GLint Previous = 0;
  GLint64 PreviousStart = 0;
  GLint64 PreviousSize = 0;
  GLint PreviousGeneric = 0;
};

/** The binding of an image unit to level 0 of a texture of unsigned integers, read and written. */
class ScopedImage
{
public:
  ScopedImage(GLuint unit, GLuint texture, GLenum format = GL_R32UI);
  ~ScopedImage();
  ScopedImage(const ScopedImage&) = delete;
  void operator=(const ScopedImage&) = delete;

private:
  GLuint Unit;
  GLint Name = 0;
  GLint Level = 0;
  GLint Layered = 0;
  GLint Layer = 0;
  GLint Access = 0;
  GLint Format = 0;
};

/**
 * A texture unit of VTK's unit manager with a texture bound to it; unbound and given back at the end.
 * Unit() is -1 when the driver's units are used up.
 */
class ScopedTextureUnit
{
public:
  ScopedTextureUnit(vtkOpenGLState* state, GLenum target, GLuint texture);
  ~ScopedTextureUnit();
  ScopedTextureUnit(const ScopedTextureUnit&) = delete;
  void operator=(const ScopedTextureUnit&) = delete;
  int Unit() const { return this->AllocatedUnit; }

private:
  vtkOpenGLState* State;
  GLenum Target;
  GLint PreviousTexture = 0;
  int AllocatedUnit;
};

}
#endif
