#include "gl/GLObjects.h"

#include "gl/Capabilities.h"
#include "gl/ScopedState.h"
#include "gl/StateRecord.h"
#include "vtkObject.h"
#include "vtkOpenGLState.h"

#include <algorithm>
#include <atomic>

namespace vitrine
{
namespace
{

// Returns the bits per texel that the driver allocated for the texture bound to `target`.
std::int64_t AllocatedBitsPerTexel(GLenum target)
{
  const GLenum sizes[] = { GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
    GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_DEPTH_SIZE, GL_TEXTURE_STENCIL_SIZE };
  std::int64_t bits = 0;
  for (const GLenum size : sizes)
  {
    GLint value = 0;
    glGetTexLevelParameteriv(target, 0, size, &value);
    bits += value;
  }
  return bits;
}

struct TransferFormat
{
  GLenum Format;
  GLenum Type;
};

// Returns the transfer format with which glTexImage2D() accepts null pixels for this internal format. glTexStorage2D()
// is not in OpenGL 3.2.
TransferFormat AnyTransferFormat(GLenum internalFormat)
{
  switch (internalFormat)
  {
    case GL_DEPTH_COMPONENT16:
    case GL_DEPTH_COMPONENT24:
    case GL_DEPTH_COMPONENT32:
    case GL_DEPTH_COMPONENT32F:
      return { GL_DEPTH_COMPONENT, GL_FLOAT };
    case GL_DEPTH24_STENCIL8:
      return { GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8 };
    case GL_DEPTH32F_STENCIL8:
      return { GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV };
    case GL_R32UI:
    case GL_RG32UI:
      return { GL_RED_INTEGER, GL_UNSIGNED_INT };
    default:
      return { GL_RGBA, GL_FLOAT };
  }
}

GLint BoundTexture(GLenum target)
{
  GLint name = 0;
  glGetIntegerv(TextureBindingQuery(target), &name);
  return name;
}

// Returns true if OpenGL had an error on record, and clears it. The loop is bounded, since a driver may return errors
// forever if no context is current.
bool TakeError()
{
  constexpr int most = 16;
  int errors = 0;
  while (errors < most && glGetError() != GL_NO_ERROR)
  {
    ++errors;
  }
  return errors > 0;
}

// An earlier error must neither be mistaken for one of the allocation, nor be lost.
void ReportEarlierErrors()
{
  if (TakeError())
  {
    vtkGenericWarningMacro("OpenGL had an error on record before an allocation of Vitrine's.");
  }
}

int LargestImage()
{
  return static_cast<int>(Limit(GL_MAX_TEXTURE_SIZE));
}

int MostLayers()
{
  return static_cast<int>(Limit(GL_MAX_ARRAY_TEXTURE_LAYERS));
}

std::string DescribeSize(int width, int height, int samples, int layers)
{
  return std::to_string(width) + "x" + std::to_string(height) + " pixels" +
    (samples > 0 ? " of " + std::to_string(samples) + " samples" : "") +
    (layers > 0 ? " in " + std::to_string(layers) + " layers" : "");
}

// Binds a buffer to a target that draws do not read: GL_COPY_WRITE_BUFFER or GL_COPY_READ_BUFFER. The names of these
// targets are also those of the queries for their bindings.
class ScopedBuffer
{
public:
  explicit ScopedBuffer(GLuint buffer, GLenum target = GL_COPY_WRITE_BUFFER)
    : Target(target)
    , Previous(BoundName(target, 0))
  {
    glBindBuffer(target, buffer);
  }
  ~ScopedBuffer() { glBindBuffer(this->Target, this->Previous); }
  ScopedBuffer(const ScopedBuffer&) = delete;
  void operator=(const ScopedBuffer&) = delete;

private:
  GLenum Target;
  GLuint Previous;
};

}

GLenum Image2D::Target() const
{
  if (this->Layers > 0)
  {
    return this->Samples > 0 ? GL_TEXTURE_2D_MULTISAMPLE_ARRAY : GL_TEXTURE_2D_ARRAY;
  }
  return this->Samples > 0 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
}

std::string Image2D::Allocate(GLenum internalFormat, int width, int height, int samples, int layers)
{
  if (this->Texture != 0 && this->InternalFormat == internalFormat && this->Width == width &&
    this->Height == height && this->Samples == samples && this->Layers == layers)
  {
    return {};
  }
  this->Release();
  if (std::max(width, height) > LargestImage())
  {
    return "it takes an image of " + DescribeSize(width, height, samples, layers) +
      ", and the driver's largest has " + std::to_string(LargestImage()) + " a side";
  }
  if (layers > MostLayers())
  {
    return "it takes an image of " + DescribeSize(width, height, samples, layers) +
      ", and the driver has at most " + std::to_string(MostLayers());
  }
  this->InternalFormat = internalFormat;
  this->Width = width;
  this->Height = height;
  this->Samples = samples;
  this->Layers = layers;

  ReportEarlierErrors();
  static std::atomic<std::uint64_t> allocations{ 0 };
  this->Allocation = ++allocations;
  this->AllocateTexture();
  if (TakeError())
  {
    this->Release();
    return "the driver has no memory for an image of " +
      DescribeSize(width, height, samples, layers);
  }
  return {};
}

void Image2D::AllocateTexture()
{
  const GLint previous = BoundTexture(this->Target());
  glGenTextures(1, this->Texture.Address());
  glBindTexture(this->Target(), this->Texture);
  if (this->Samples > 0 && this->Layers > 0)
  {
    glTexImage3DMultisample(this->Target(), this->Samples, this->InternalFormat, this->Width,
      this->Height, this->Layers, GL_TRUE);
  }
  else if (this->Samples > 0)
  {
    glTexImage2DMultisample(
      this->Target(), this->Samples, this->InternalFormat, this->Width, this->Height, GL_TRUE);
  }
  else
  {
    const ScopedPixelTransfer pixelTransfer(
      ScopedPixelTransfer::TO_DEVICE); // A bound unpack buffer would be read.
    const TransferFormat none = AnyTransferFormat(this->InternalFormat);
    const auto format = static_cast<GLint>(this->InternalFormat);
    if (this->Layers > 0)
    {
      glTexImage3D(this->Target(), 0, format, this->Width, this->Height, this->Layers, 0,
        none.Format, none.Type, nullptr);
    }
    else
    {
      glTexImage2D(
        this->Target(), 0, format, this->Width, this->Height, 0, none.Format, none.Type, nullptr);
    }
    glTexParameteri(this->Target(), GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(this->Target(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(this->Target(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  this->BitsPerTexel = AllocatedBitsPerTexel(this->Target());
  glBindTexture(this->Target(), static_cast<GLuint>(previous));
}

void Image2D::Release()
{
  glDeleteTextures(1, this->Texture.Address());
  *this = Image2D();
}

std::int64_t Image2D::Bytes() const
{
  return this->BitsPerTexel / 8 * this->Width * this->Height * std::max(this->Samples, 1) *
    std::max(this->Layers, 1);
}

bool Buffer::Allocate(std::int64_t size, GLenum texelFormat, GLenum usage)
{
  if (this->Name == 0)
  {
    glGenBuffers(1, this->Name.Address());
  }
  ReportEarlierErrors();
  {
    const ScopedBuffer bound(this->Name);
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(size), nullptr, usage);
  }
  if (texelFormat != GL_NONE)
  {
    this->AttachTexture(texelFormat);
  }
  if (TakeError())
  {
    this->Release();
    return false;
  }
  this->Size = size;
  return true;
}

void Buffer::AttachTexture(GLenum texelFormat)
{
  if (this->BufferTexture == 0)
  {
    glGenTextures(1, this->BufferTexture.Address());
  }
  GLint previous = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_BUFFER, &previous);
  glBindTexture(GL_TEXTURE_BUFFER, this->BufferTexture);
  glTexBuffer(GL_TEXTURE_BUFFER, texelFormat, this->Name);
  glBindTexture(GL_TEXTURE_BUFFER, static_cast<GLuint>(previous));
}

void Buffer::Clear()
{
  const ScopedBuffer bound(this->Name);
  glClearBufferData(
    GL_COPY_WRITE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr); // null means 0
}

void Buffer::CopyFrom(
  const Buffer& source, std::int64_t sourceOffset, std::int64_t offset, std::int64_t size)
{
  const ScopedBuffer bound(this->Name);
  const ScopedBuffer read(source.Name, GL_COPY_READ_BUFFER);
  glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER,
    static_cast<GLintptr>(sourceOffset), static_cast<GLintptr>(offset),
    static_cast<GLsizeiptr>(size));
}

void Buffer::Write(std::int64_t offset, std::int64_t size, const void* data)
{
  const ScopedBuffer bound(this->Name);
  glBufferSubData(
    GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(size), data);
}

void Buffer::Read(std::int64_t offset, std::int64_t size, void* data) const
{
  const ScopedBuffer bound(this->Name);
  glGetBufferSubData(
    GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(size), data);
}

void Buffer::Release()
{
  glDeleteTextures(1, this->BufferTexture.Address());
  glDeleteBuffers(1, this->Name.Address());
  *this = Buffer();
}

GLuint Framebuffer::Handle()
{
  if (this->Name == 0)
  {
    glGenFramebuffers(1, this->Name.Address());
  }
  return this->Name;
}

void Framebuffer::Attach(vtkOpenGLState* state, const Image2D& image)
{
  if (this->Attached == image.Number())
  {
    return;
  }
  BindForDrawing(state, this->Handle());
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, image.Target(), image.Handle(), 0);
  this->Attached = image.Number();
}

void Framebuffer::Release()
{
  glDeleteFramebuffers(1, this->Name.Address());
  *this = Framebuffer();
}

GLuint EmptyVertexArray::Handle()
{
  if (this->Name == 0)
  {
    glGenVertexArrays(1, this->Name.Address());
  }
  return this->Name;
}

void EmptyVertexArray::Release()
{
  glDeleteVertexArrays(1, this->Name.Address());
  this->Name = {};
}

}
