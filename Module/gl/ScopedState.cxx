#include "gl/ScopedState.h"

#include "gl/Capabilities.h"
#include "gl/StateRecord.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <set>

namespace vitrine
{

template <class Ask>
ScopedBindingMemory::Binding ScopedBindingMemory::Recall(GLenum kind, GLuint index, const Ask& ask)
{
  if (!ScopedBindingMemory::Current)
  {
    return ask();
  }
  const auto [entry, isNew] =
    ScopedBindingMemory::Current->Bindings.try_emplace({ kind, index }, Binding());
  if (isNew)
  {
    entry->second = ask();
  }
  return entry->second;
}

namespace
{

// The targets of textures that ScopedTextureUnit binds, and the queries for what is bound to them.
const std::pair<GLenum, GLenum> TextureBindings[] = {
  { GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D },
  { GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE },
  { GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY },
  { GL_TEXTURE_2D_MULTISAMPLE_ARRAY, GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY },
  { GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER },
};

// Returns `texture`, or 0 if it was deleted. OpenGL binds no name that was deleted.
GLuint Living(GLuint texture)
{
  return texture != 0 && glIsTexture(texture) ? texture : 0;
}

// Settings of pixel transfers in one direction, the first with a default of 4 and the others with 0, and the target of
// their buffer.
struct TransferState
{
  GLenum Settings[5];
  GLenum Buffer;
  GLenum BufferQuery;
};
const TransferState Packing = { { GL_PACK_ALIGNMENT, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS,
                                  GL_PACK_SKIP_PIXELS, GL_PACK_SWAP_BYTES },
  GL_PIXEL_PACK_BUFFER, GL_PIXEL_PACK_BUFFER_BINDING };
const TransferState Unpacking = { { GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS,
                                    GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SWAP_BYTES },
  GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_UNPACK_BUFFER_BINDING };

const TransferState& StateOf(ScopedPixelTransfer::Direction direction)
{
  return direction == ScopedPixelTransfer::FROM_DEVICE ? Packing : Unpacking;
}

// Capabilities that confine multisampled drawing to some samples.
const GLenum SampleCapabilities[] = { GL_SAMPLE_MASK, GL_SAMPLE_ALPHA_TO_COVERAGE,
  GL_SAMPLE_COVERAGE };

}

GLuint BoundName(GLenum query, GLuint index)
{
  const auto ask = [query]
  {
    GLint name = 0;
    glGetIntegerv(query, &name);
    return ScopedBindingMemory::Binding{ name };
  };
  return static_cast<GLuint>(ScopedBindingMemory::Recall(query, index, ask)[0]);
}

ScopedBindingMemory* ScopedBindingMemory::Current = nullptr;

ScopedBindingMemory::ScopedBindingMemory()
  : Previous(ScopedBindingMemory::Current)
{
  ScopedBindingMemory::Current = this;
}

ScopedBindingMemory::~ScopedBindingMemory()
{
  ScopedBindingMemory::Current = this->Previous;
}

void ScopedBindingMemory::ForgetDeletedTextures()
{
  if (!ScopedBindingMemory::Current)
  {
    return;
  }
  for (auto& [point, binding] : ScopedBindingMemory::Current->Bindings)
  {
    const bool isTexture = std::any_of(std::begin(TextureBindings), std::end(TextureBindings),
      [kind = point.first](const auto& each) { return each.second == kind; });
    if (isTexture)
    {
      binding[0] = Living(static_cast<GLuint>(binding[0]));
    }
  }
}

GLenum TextureBindingQuery(GLenum target)
{
  const auto* const found = std::find_if(std::begin(TextureBindings), std::end(TextureBindings),
    [target](const auto& each) { return each.first == target; });
  assert(found != std::end(TextureBindings) && "texture target without a query");
  return found != std::end(TextureBindings) ? found->second : 0;
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
  const auto& record = StateRecord::Of(state);
  this->Front = { record.StencilFuncFront, record.StencilOpFront, record.StencilMaskFront };
  this->Back = { record.StencilFuncBack, record.StencilOpBack, record.StencilMaskBack };
}

ScopedStencil::~ScopedStencil()
{
  this->PutBack(GL_FRONT, this->Front);
  this->PutBack(GL_BACK, this->Back);
}

void ScopedStencil::PutBack(GLenum which, const Face& face)
{
  const auto& [function, reference, mask] = face.Function;
  const auto& [fail, depthFail, pass] = face.Operations;
  this->State->vtkglStencilFuncSeparate(which, function, static_cast<GLint>(reference), mask);
  this->State->vtkglStencilOpSeparate(which, fail, depthFail, pass);
  this->State->vtkglStencilMaskSeparate(which, face.WriteMask);
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
  , Previous(StateRecord::Of(state).ReadBinding.ReadBuffer)
{
  state->vtkglReadBuffer(buffer);
}

ScopedReadBuffer::~ScopedReadBuffer()
{
  this->State->vtkglReadBuffer(this->Previous);
}

ScopedPixelTransfer::ScopedPixelTransfer(Direction direction)
  : Way(direction)
{
  const TransferState& state = StateOf(direction);
  static_assert(std::size(TransferState().Settings) == Settings, "one value each");
  // Mappers that upload textures within a frame change the settings of unpacking.
  const auto ask = [direction](GLenum name)
  {
    GLint value = 0;
    direction == FROM_DEVICE ? void(value = static_cast<GLint>(BoundName(name, 0)))
                             : glGetIntegerv(name, &value);
    return value;
  };
  for (int i = 0; i < Settings; ++i)
  {
    this->Previous[i] = ask(state.Settings[i]);
    glPixelStorei(state.Settings[i], i == 0 ? 4 : 0);
  }
  this->PreviousBuffer = ask(state.BufferQuery);
  glBindBuffer(state.Buffer, 0);
}

ScopedPixelTransfer::~ScopedPixelTransfer()
{
  const TransferState& state = StateOf(this->Way);
  for (int i = 0; i < Settings; ++i)
  {
    glPixelStorei(state.Settings[i], this->Previous[i]);
  }
  glBindBuffer(state.Buffer, static_cast<GLuint>(this->PreviousBuffer));
}

ScopedExclusiveOr::ScopedExclusiveOr()
  : HadLogic(glIsEnabled(GL_COLOR_LOGIC_OP))
  , HadClamp(glIsEnabled(GL_DEPTH_CLAMP))
{
  glGetIntegerv(GL_LOGIC_OP_MODE, &this->Previous);
  glEnable(GL_COLOR_LOGIC_OP);
  glEnable(GL_DEPTH_CLAMP);
  glLogicOp(GL_XOR);
}

ScopedExclusiveOr::~ScopedExclusiveOr()
{
  glLogicOp(static_cast<GLenum>(this->Previous));
  (this->HadLogic ? glEnable : glDisable)(GL_COLOR_LOGIC_OP);
  (this->HadClamp ? glEnable : glDisable)(GL_DEPTH_CLAMP);
}

ScopedEncoding::ScopedEncoding(bool on)
  : WasEnabled(glIsEnabled(GL_FRAMEBUFFER_SRGB))
{
  (on ? glEnable : glDisable)(GL_FRAMEBUFFER_SRGB);
}

ScopedEncoding::~ScopedEncoding()
{
  (this->WasEnabled ? glEnable : glDisable)(GL_FRAMEBUFFER_SRGB);
}

ScopedSampleShading::ScopedSampleShading()
  : WasEnabled(glIsEnabled(GL_SAMPLE_SHADING))
{
  glGetFloatv(GL_MIN_SAMPLE_SHADING_VALUE, &this->Previous);
  glEnable(GL_SAMPLE_SHADING);
  glMinSampleShading(1.0f);
}

ScopedSampleShading::~ScopedSampleShading()
{
  glMinSampleShading(this->Previous);
  (this->WasEnabled ? glEnable : glDisable)(GL_SAMPLE_SHADING);
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
  , PreviousGeneric(BoundName(GL_SHADER_STORAGE_BUFFER_BINDING, 0))
  , Previous(ScopedBindingMemory::Recall(GL_SHADER_STORAGE_BUFFER, index,
      [index]
      {
        GLint name = 0;
        ScopedBindingMemory::Binding binding = {};
        glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, index, &name);
        if (name != 0)
        {
          binding[0] = name;
          glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, index, &binding[1]);
          glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, index, &binding[2]);
        }
        return binding;
      }))
{
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, index, buffer);
}

ScopedStorageBuffer::~ScopedStorageBuffer()
{
  const auto& [name, start, size, none3, none4, none5] = this->Previous;
  if (size > 0)
  {
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, this->Index, static_cast<GLuint>(name),
      static_cast<GLintptr>(start), static_cast<GLsizeiptr>(size));
  }
  else
  {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, this->Index, static_cast<GLuint>(name));
  }
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->PreviousGeneric);
}

ScopedImage::ScopedImage(GLuint unit, GLuint texture, GLenum format)
  : Unit(unit)
  , Previous(ScopedBindingMemory::Recall(GL_IMAGE_BINDING_NAME, unit,
      [unit]
      {
        GLint name = 0;
        glGetIntegeri_v(GL_IMAGE_BINDING_NAME, unit, &name);
        if (name == 0)
        {
          return ScopedBindingMemory::Binding{ 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R8 };
        }
        ScopedBindingMemory::Binding binding = { name };
        const GLenum others[] = { GL_IMAGE_BINDING_LEVEL, GL_IMAGE_BINDING_LAYERED,
          GL_IMAGE_BINDING_LAYER, GL_IMAGE_BINDING_ACCESS, GL_IMAGE_BINDING_FORMAT };
        for (std::size_t i = 0; i < std::size(others); ++i)
        {
          GLint value = 0;
          glGetIntegeri_v(others[i], unit, &value);
          binding[i + 1] = value;
        }
        return binding;
      }))
{
  glBindImageTexture(unit, texture, 0, GL_FALSE, 0, GL_READ_WRITE, format);
}

ScopedImage::~ScopedImage()
{
  const auto& [name, level, layered, layer, access, format] = this->Previous;
  glBindImageTexture(this->Unit, static_cast<GLuint>(name), static_cast<GLint>(level),
    static_cast<GLboolean>(layered), static_cast<GLint>(layer), static_cast<GLenum>(access),
    static_cast<GLenum>(format));
}

namespace
{
thread_local std::set<int> OwnUnits; // of all ScopedTextureUnits

/** The last unit that no ScopedTextureUnit has, or 0. */
int LastForeignUnit(int numberOfUnits)
{
  int unit = numberOfUnits - 1;
  while (unit > 0 && OwnUnits.count(unit) > 0)
  {
    --unit;
  }
  return std::max(unit, 0);
}
}

ScopedTextureUnit::ScopedTextureUnit(
  vtkOpenGLState* state, GLenum target, GLuint texture, WhenTaken whenTaken)
  : State(state)
  , Target(target)
  , UsedUnit(state->GetTextureUnitManager()->Allocate())
{
  if (this->UsedUnit < 0 && whenTaken == WhenTaken::FAIL)
  {
    return;
  }
  if (this->UsedUnit < 0)
  {
    // VTK's mappers of composite data keep a unit each from VTK 9.4 on, so that all may be taken.
    this->IsBorrowed = true;
    this->UsedUnit = LastForeignUnit(state->GetTextureUnitManager()->GetNumberOfTextureUnits());
  }
  OwnUnits.insert(this->UsedUnit);
  state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(this->UsedUnit));
  this->PreviousTexture =
    BoundName(TextureBindingQuery(target), static_cast<GLuint>(this->UsedUnit));
  glBindTexture(target, texture);
}

ScopedTextureUnit::~ScopedTextureUnit()
{
  if (this->UsedUnit < 0)
  {
    return;
  }
  this->State->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(this->UsedUnit));
  glBindTexture(this->Target, Living(this->PreviousTexture));
  OwnUnits.erase(this->UsedUnit);
  if (!this->IsBorrowed)
  {
    this->State->GetTextureUnitManager()->Free(this->UsedUnit);
  }
}

}
