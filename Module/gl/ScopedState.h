/** Scoped keepers of GL state. A constructor reads the current state, and the destructor restores it. */
#ifndef VITRINE_GL_SCOPED_STATE_H
#define VITRINE_GL_SCOPED_STATE_H

#include "gl/VitrineOpenGL.h"
#include "vtkOpenGLState.h"
#include "vtkSmartPointer.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace vitrine
{

/**
 * While it lives, ScopedStorageBuffer, ScopedImage, ScopedTextureUnit and ScopedPixelTransfer from the device ask
 * OpenGL once for each binding and setting that they keep. Later objects find those that earlier ones have put back.
 */
class ScopedBindingMemory
{
public:
  /** The values that describe a binding, up to six. */
  using Binding = std::array<GLint64, 6>;

  ScopedBindingMemory();
  ~ScopedBindingMemory();
  ScopedBindingMemory(const ScopedBindingMemory&) = delete;
  void operator=(const ScopedBindingMemory&) = delete;

  /** Returns the binding of point `index` of a kind. Calls `ask` unless it is remembered. */
  template <class Ask>
  static Binding Recall(GLenum kind, GLuint index, const Ask& ask);

  /**
   * Remember no texture that was deleted. Call this after props were drawn: a mapper may hold the last reference to the
   * passes of its last frame, and with them their textures. OpenGL then binds 0 in place of these.
   */
  static void ForgetDeletedTextures();

private:
  std::map<std::pair<GLenum, GLuint>, Binding> Bindings;
  ScopedBindingMemory* Previous;
  static ScopedBindingMemory* Current;
};

/**
 * Returns the name of the object that `query` tells, such as GL_COPY_READ_BUFFER. If the query is of the active texture
 * unit, `index` is that unit. A ScopedBindingMemory remembers it.
 */
GLuint BoundName(GLenum query, GLuint index);

/** Returns the query for the texture bound to `target` of the active unit. */
GLenum TextureBindingQuery(GLenum target);

/**
 * Keeps the state that vtkOpenGLState tracks and passes change: masks, tests, blending, viewport, scissor box,
 * framebuffer bindings. Changes go through vtkOpenGLState, so its cache stays valid.
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

/** Keeps function, operations and mask of the stencil test, for both faces. */
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
    std::array<GLuint, 3> Function = {}; // With its reference and mask.
    std::array<GLuint, 3> Operations = {};
    GLuint WriteMask = 0;
  };
  void PutBack(GLenum which, const Face& face);

  vtkOpenGLState* State;
  Face Front;
  Face Back;
};

/**
 * Confines drawing to the first draw buffer of the bound framebuffer, so that the other buffers keep their contents.
 * The same framebuffer must be bound when the object is destroyed.
 */
class ScopedFirstDrawBuffer
{
public:
  explicit ScopedFirstDrawBuffer(vtkOpenGLState* state);
  ~ScopedFirstDrawBuffer();
  ScopedFirstDrawBuffer(const ScopedFirstDrawBuffer&) = delete;
  void operator=(const ScopedFirstDrawBuffer&) = delete;

  /** Returns true if there are other draw buffers. */
  bool HasOthers() const;

  /** Confine drawing to the first draw buffer again, after other code set the draw buffers of the same framebuffer. */
  void Confine();

private:
  void Set(std::vector<GLenum> buffers);

  vtkOpenGLState* State;
  std::vector<GLenum> Previous;
  bool Changed = false;
};

/**
 * Keeps the read buffer of the framebuffer bound for reading. The same framebuffer must be bound when the object is
 * destroyed.
 */
class ScopedReadBuffer
{
public:
  ScopedReadBuffer(vtkOpenGLState* state, GLenum buffer);
  ~ScopedReadBuffer();
  ScopedReadBuffer(const ScopedReadBuffer&) = delete;
  void operator=(const ScopedReadBuffer&) = delete;

private:
  vtkOpenGLState* State;
  GLuint Previous;
};

/**
 * Makes pixel transfers in one direction use client memory with OpenGL's default layout (rows aligned to 4 bytes).
 * Keeps the previous settings and buffer binding.
 */
class ScopedPixelTransfer
{
public:
  enum Direction
  {
    FROM_DEVICE,
    TO_DEVICE
  };
  explicit ScopedPixelTransfer(Direction direction);
  ~ScopedPixelTransfer();
  ScopedPixelTransfer(const ScopedPixelTransfer&) = delete;
  void operator=(const ScopedPixelTransfer&) = delete;

private:
  static constexpr int Settings = 5;
  Direction Way;
  GLint Previous[Settings] = {};
  GLint PreviousBuffer = 0;
};

/**
 * Makes draws change integer images by exclusive or, and keeps what lies beyond the near and far planes. Neither is
 * tracked by VTK.
 */
class ScopedExclusiveOr
{
public:
  ScopedExclusiveOr();
  ~ScopedExclusiveOr();
  ScopedExclusiveOr(const ScopedExclusiveOr&) = delete;
  void operator=(const ScopedExclusiveOr&) = delete;

private:
  GLboolean HadLogic;
  GLboolean HadClamp;
  GLint Previous = 0;
};

/** Has colours encoded as they are written into targets of sRGB, if `on`. VTK does not track it. */
class ScopedEncoding
{
public:
  explicit ScopedEncoding(bool on);
  ~ScopedEncoding();
  ScopedEncoding(const ScopedEncoding&) = delete;
  void operator=(const ScopedEncoding&) = delete;

private:
  GLboolean WasEnabled;
};

/** Runs shaders for each sample, with inputs at the place of the sample. VTK does not track it. Needs OpenGL 4.0. */
class ScopedSampleShading
{
public:
  ScopedSampleShading();
  ~ScopedSampleShading();
  ScopedSampleShading(const ScopedSampleShading&) = delete;
  void operator=(const ScopedSampleShading&) = delete;

private:
  GLboolean WasEnabled;
  GLfloat Previous = 0.0f;
};

/** Keeps the buffer bound for vertex attributes, which VTK's mappers leave changed. */
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
 * Keeps the state that confines drawing to some samples, which VTK does not track. Until DrawInto() chooses a sample,
 * all samples are drawn: sample mask, sample coverage and alpha-to-coverage are off.
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

/** Binds a vertex array and keeps the previous one. VTK does not track it. */
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

/** Binds a vertex array, and then none. A ScopedVertexArray lives around it. */
class BoundVertexArray
{
public:
  explicit BoundVertexArray(GLuint vertexArray) { glBindVertexArray(vertexArray); }
  ~BoundVertexArray() { glBindVertexArray(0); }
  BoundVertexArray(const BoundVertexArray&) = delete;
  void operator=(const BoundVertexArray&) = delete;
};

/** Keeps the program that VTK's shader cache has bound. */
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

/** Binds a shader storage buffer to an index. Keeps that binding and the generic one, which it changes too. */
class ScopedStorageBuffer
{
public:
  ScopedStorageBuffer(GLuint index, GLuint buffer);
  ~ScopedStorageBuffer();
  ScopedStorageBuffer(const ScopedStorageBuffer&) = delete;
  void operator=(const ScopedStorageBuffer&) = delete;

private:
  GLuint Index;
  GLuint PreviousGeneric;
  ScopedBindingMemory::Binding Previous; // Name, start and size.
};

/** Binds level 0 of a texture of unsigned integers to an image unit, for reading and writing. */
class ScopedImage
{
public:
  ScopedImage(GLuint unit, GLuint texture, GLenum format = GL_R32UI);
  ~ScopedImage();
  ScopedImage(const ScopedImage&) = delete;
  void operator=(const ScopedImage&) = delete;

private:
  GLuint Unit;
  // Name, level, layered, layer, access and format. A unit without a texture is left as OpenGL initialises it.
  ScopedBindingMemory::Binding Previous;
};

/** What a ScopedTextureUnit does where all units are taken. */
enum class WhenTaken
{
  BORROW, ///< Take one from a texture that is not drawn with meanwhile, from the last unit downwards.
  FAIL,   ///< Unit() is -1.
};

/**
 * Allocates a unit of VTK's texture unit manager and binds a texture to it. The destructor restores the previous
 * binding and frees the unit.
 */
class ScopedTextureUnit
{
public:
  ScopedTextureUnit(
    vtkOpenGLState* state, GLenum target, GLuint texture, WhenTaken whenTaken = WhenTaken::BORROW);
  ~ScopedTextureUnit();
  ScopedTextureUnit(const ScopedTextureUnit&) = delete;
  void operator=(const ScopedTextureUnit&) = delete;
  int Unit() const { return this->UsedUnit; }

private:
  vtkOpenGLState* State;
  GLenum Target;
  GLuint PreviousTexture = 0;
  int UsedUnit;
  bool IsBorrowed = false;
};

}
#endif
