#include "gl/ScopedState.h"

#include "gl/Capabilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace vitrine
{
namespace
{

struct PixelSetting
{
  GLenum Name;
  GLint Default;
};

// Settings of pixel transfers, and OpenGL's defaults.
const PixelSetting PixelSettings[] = { { GL_PACK_SWAP_BYTES, 0 }, { GL_PACK_LSB_FIRST, 0 },
  { GL_PACK_ROW_LENGTH, 0 }, { GL_PACK_SKIP_ROWS, 0 }, { GL_PACK_SKIP_PIXELS, 0 },
  { GL_PACK_ALIGNMENT, 4 }, { GL_UNPACK_SWAP_BYTES, 0 }, { GL_UNPACK_LSB_FIRST, 0 },
  { GL_UNPACK_ROW_LENGTH, 0 }, { GL_UNPACK_SKIP_ROWS, 0 }, { GL_UNPACK_SKIP_PIXELS, 0 },
  { GL_UNPACK_ALIGNMENT, 4 } };

// Capabilities that confine multisampled drawing to some samples.
const GLenum SampleCapabilities[] = { GL_SAMPLE_MASK, GL_SAMPLE_ALPHA_TO_COVERAGE,
  GL_SAMPLE_COVERAGE };

}

GLenum TextureBindingQuery(GLenum target)
{
  switch (target)
  {
    case GL_TEXTURE_2D:
      return GL_TEXTURE_BINDING_2D;
    case GL_TEXTURE_2D_MULTISAMPLE:
      return GL_TEXTURE_BINDING_2D_MULTISAMPLE;
    case GL_TEXTURE_2D_ARRAY:
      return GL_TEXTURE_BINDING_2D_ARRAY;
    case GL_TEXTURE_2D_MULTISAMPLE_ARRAY:
      return GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY;
    case GL_TEXTURE_BUFFER:
      return GL_TEXTURE_BINDING_BUFFER;
    default:
      assert(false && "texture target without a query");
      return 0;
  }
}

ScopedTrackedState::ScopedTrackedState(vtkOpenGLState* state)
  : State(state)
  , DepthMask(state)
  , DepthFunc(state)
  , ColorMask(state)
  , BlendFunc(state)
  , Viewport(state)
  , Scissor(state)
  , Blend(state, GL_BLEND)
  , DepthTest(state, GL_DEPTH_TEST)
  , ScissorTest(state, GL_SCISSOR_TEST)
  , CullFace(state, GL_CULL_FACE)
  , StencilTest(state, GL_STENCIL_TEST)
  , Multisample(state, GL_MULTISAMPLE)
  , ActiveTexture(state)
{
  this->State->PushFramebufferBindings();
}

ScopedTrackedState::~ScopedTrackedState()
{
  this->State->PopFramebufferBindings();
}

ScopedStencil::ScopedStencil(vtkOpenGLState* state)
  : State(state)
{
  glGetIntegerv(GL_STENCIL_FUNC, &this->Front.Function);
  glGetIntegerv(GL_STENCIL_REF, &this->Front.Reference);
  glGetIntegerv(GL_STENCIL_VALUE_MASK, &this->Front.ValueMask);
  glGetIntegerv(GL_STENCIL_WRITEMASK, &this->Front.WriteMask);
  glGetIntegerv(GL_STENCIL_FAIL, &this->Front.Fail);
  glGetIntegerv(GL_STENCIL_PASS_DEPTH_FAIL, &this->Front.DepthFail);
  glGetIntegerv(GL_STENCIL_PASS_DEPTH_PASS, &this->Front.Pass);
  glGetIntegerv(GL_STENCIL_BACK_FUNC, &this->Back.Function);
  glGetIntegerv(GL_STENCIL_BACK_REF, &this->Back.Reference);
  glGetIntegerv(GL_STENCIL_BACK_VALUE_MASK, &this->Back.ValueMask);
  glGetIntegerv(GL_STENCIL_BACK_WRITEMASK, &this->Back.WriteMask);
  glGetIntegerv(GL_STENCIL_BACK_FAIL, &this->Back.Fail);
  glGetIntegerv(GL_STENCIL_BACK_PASS_DEPTH_FAIL, &this->Back.DepthFail);
  glGetIntegerv(GL_STENCIL_BACK_PASS_DEPTH_PASS, &this->Back.Pass);
}

ScopedStencil::~ScopedStencil()
{
  this->PutBack(GL_FRONT, this->Front);
  this->PutBack(GL_BACK, this->Back);
}

void ScopedStencil::PutBack(GLenum which, const Face& face)
{
  this->State->vtkglStencilFuncSeparate(
    which, static_cast<GLenum>(face.Function), face.Reference, static_cast<GLuint>(face.ValueMask));
  this->State->vtkglStencilMaskSeparate(which, static_cast<GLuint>(face.WriteMask));
  this->State->vtkglStencilOpSeparate(which, static_cast<GLenum>(face.Fail),
    static_cast<GLenum>(face.DepthFail), static_cast<GLenum>(face.Pass));
}

ScopedFirstDrawBuffer::ScopedFirstDrawBuffer(vtkOpenGLState* state)
  : State(state)
{
  const std::int64_t count = Limit(GL_MAX_DRAW_BUFFERS);
  for (std::int64_t i = 0; i < count; ++i)
  {
    GLint buffer = 0;
    glGetIntegerv(GL_DRAW_BUFFER0 + static_cast<GLenum>(i), &buffer);
    this->Previous.push_back(static_cast<GLenum>(buffer));
  }
  if (this->HasOthers())
  {
    this->Confine();
  }
}

ScopedFirstDrawBuffer::~ScopedFirstDrawBuffer()
{
  if (this->Changed)
  {
    this->Set(this->Previous);
  }
}

bool ScopedFirstDrawBuffer::HasOthers() const
{
  return std::any_of(this->Previous.begin() + 1, this->Previous.end(),
    [](GLenum buffer) { return buffer != GL_NONE; });
}

void ScopedFirstDrawBuffer::Confine()
{
  std::vector<GLenum> first(this->Previous.size(), GL_NONE);
  first[0] = this->Previous[0];
  this->Set(first);
  this->Changed = true;
}

// vtkOpenGLState skips calls that it considers redundant, and its cache of the buffers after the first may be that of
// another framebuffer. So OpenGL is called as well.
void ScopedFirstDrawBuffer::Set(std::vector<GLenum> buffers)
{
  const auto count = static_cast<GLsizei>(buffers.size());
  this->State->vtkglDrawBuffers(static_cast<unsigned int>(count), buffers.data());
  glDrawBuffers(count, buffers.data());
}

ScopedReadBuffer::ScopedReadBuffer(vtkOpenGLState* state, GLenum buffer)
  : State(state)
{
  glGetIntegerv(GL_READ_BUFFER, &this->Previous);
  state->vtkglReadBuffer(buffer);
}

ScopedReadBuffer::~ScopedReadBuffer()
{
  this->State->vtkglReadBuffer(static_cast<GLenum>(this->Previous));
}

ScopedPixelTransfer::ScopedPixelTransfer()
{
  static_assert(std::size(PixelSettings) == Settings, "one value each");
  for (int i = 0; i < Settings; ++i)
  {
    glGetIntegerv(PixelSettings[i].Name, &this->Previous[i]);
    glPixelStorei(PixelSettings[i].Name, PixelSettings[i].Default);
  }
  glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &this->PreviousPack);
  glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &this->PreviousUnpack);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

ScopedPixelTransfer::~ScopedPixelTransfer()
{
  for (int i = 0; i < Settings; ++i)
  {
    glPixelStorei(PixelSettings[i].Name, this->Previous[i]);
  }
  glBindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(this->PreviousPack));
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(this->PreviousUnpack));
}

ScopedArrayBuffer::ScopedArrayBuffer()
{
  glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &this->Previous);
}

ScopedArrayBuffer::~ScopedArrayBuffer()
{
  // A mapper that rebuilds its buffers may have deleted this one.
  const auto previous = static_cast<GLuint>(this->Previous);
  glBindBuffer(GL_ARRAY_BUFFER, previous != 0 && glIsBuffer(previous) ? previous : 0);
}

ScopedSampleMask::ScopedSampleMask()
{
  static_assert(std::size(SampleCapabilities) == Capabilities, "one value each");
  glGetIntegeri_v(GL_SAMPLE_MASK_VALUE, 0, &this->Previous);
  for (int i = 0; i < Capabilities; ++i)
  {
    this->WereEnabled[i] = glIsEnabled(SampleCapabilities[i]);
    glDisable(SampleCapabilities[i]);
  }
}

void ScopedSampleMask::DrawInto(int sample)
{
  glEnable(GL_SAMPLE_MASK);
  glSampleMaski(0, 1u << static_cast<unsigned int>(sample));
}

ScopedSampleMask::~ScopedSampleMask()
{
  glSampleMaski(0, static_cast<GLbitfield>(this->Previous));
  for (int i = 0; i < Capabilities; ++i)
  {
    (this->WereEnabled[i] ? glEnable : glDisable)(SampleCapabilities[i]);
  }
}

ScopedVertexArray::ScopedVertexArray(GLuint vertexArray)
{
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &this->Previous);
  glBindVertexArray(vertexArray);
}

ScopedVertexArray::~ScopedVertexArray()
{
  const auto previous = static_cast<GLuint>(this->Previous);
  glBindVertexArray(previous != 0 && glIsVertexArray(previous) ? previous : 0);
}

ScopedShaderProgram::ScopedShaderProgram(vtkOpenGLRenderWindow* window)
  : Window(window)
  , Previous(window->GetShaderCache()->GetLastShaderBound())
{
}

ScopedShaderProgram::~ScopedShaderProgram()
{
  vtkOpenGLShaderCache* cache = this->Window->GetShaderCache();
  if (this->Previous && this->Previous->GetHandle() != 0)
  {
    cache->ReadyShaderProgram(this->Previous);
  }
  else
  {
    cache->ReleaseCurrentShader();
  }
}

ScopedStorageBuffer::ScopedStorageBuffer(GLuint index, GLuint buffer)
  : Index(index)
{
  glGetIntegerv(GL_SHADER_STORAGE_BUFFER_BINDING, &this->PreviousGeneric);
  glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, index, &this->Previous);
  if (this->Previous != 0)
  {
    glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, index, &this->PreviousStart);
    glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, index, &this->PreviousSize);
  }
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, index, buffer);
}

ScopedStorageBuffer::~ScopedStorageBuffer()
{
  if (this->PreviousSize > 0)
  {
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, this->Index, static_cast<GLuint>(this->Previous),
      static_cast<GLintptr>(this->PreviousStart), static_cast<GLsizeiptr>(this->PreviousSize));
  }
  else
  {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, this->Index, static_cast<GLuint>(this->Previous));
  }
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(this->PreviousGeneric));
}

ScopedImage::ScopedImage(GLuint unit, GLuint texture, GLenum format)
  : Unit(unit)
{
  glGetIntegeri_v(GL_IMAGE_BINDING_NAME, unit, &this->Name);
  if (this->Name != 0)
  {
    glGetIntegeri_v(GL_IMAGE_BINDING_LEVEL, unit, &this->Level);
    glGetIntegeri_v(GL_IMAGE_BINDING_LAYERED, unit, &this->Layered);
    glGetIntegeri_v(GL_IMAGE_BINDING_LAYER, unit, &this->Layer);
    glGetIntegeri_v(GL_IMAGE_BINDING_ACCESS, unit, &this->Access);
    glGetIntegeri_v(GL_IMAGE_BINDING_FORMAT, unit, &this->Format);
  }
  glBindImageTexture(unit, texture, 0, GL_FALSE, 0, GL_READ_WRITE, format);
}

ScopedImage::~ScopedImage()
{
  glBindImageTexture(this->Unit, static_cast<GLuint>(this->Name), this->Level,
    static_cast<GLboolean>(this->Layered), this->Layer, static_cast<GLenum>(this->Access),
    static_cast<GLenum>(this->Format));
}

ScopedTextureUnit::ScopedTextureUnit(vtkOpenGLState* state, GLenum target, GLuint texture)
  : State(state)
  , Target(target)
  , AllocatedUnit(state->GetTextureUnitManager()->Allocate())
{
  if (this->AllocatedUnit >= 0)
  {
    state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(this->AllocatedUnit));
    glGetIntegerv(TextureBindingQuery(target), &this->PreviousTexture);
    glBindTexture(target, texture);
  }
}

ScopedTextureUnit::~ScopedTextureUnit()
{
  if (this->AllocatedUnit >= 0)
  {
    this->State->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(this->AllocatedUnit));
    glBindTexture(this->Target, static_cast<GLuint>(this->PreviousTexture));
    this->State->GetTextureUnitManager()->Free(this->AllocatedUnit);
  }
}

}
