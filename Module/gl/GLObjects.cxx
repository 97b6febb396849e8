#include "gl/GLObjects.h"

#include <algorithm>

namespace vitrine
{
namespace
{

// Bits a texel of what is allocated, as the driver has it. The texture is bound to `target`.
std::int64_t BitsPerTexel(GLenum target)
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

GLint BoundTexture(GLenum target)
{
  GLint name = 0;
  glGetIntegerv(
    target == GL_TEXTURE_2D ? GL_TEXTURE_BINDING_2D : GL_TEXTURE_BINDING_2D_MULTISAMPLE, &name);
  return name;
}

// Binds a buffer to the generic shader storage target, which draws do not read.
class ScopedBuffer
{
public:
  explicit ScopedBuffer(GLuint buffer)
  {
    glGetIntegerv(GL_SHADER_STORAGE_BUFFER_BINDING, &this->Previous);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
  }
  ~ScopedBuffer() { glBindBuffer(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(this->Previous)); }
  ScopedBuffer(const ScopedBuffer&) = delete;
  void operator=(const ScopedBuffer&) = delete;

private:
  GLint Previous = 0;
};

}

bool Image2D::Allocate(GLenum internalFormat, int width, int height, int samples)
{
  if (this->Texture != 0 && this->InternalFormat == internalFormat && this->Width == width &&
    this->Height == height && this->Samples == samples)
  {
    return false;
  }
  this->Release();
  this->InternalFormat = internalFormat;
  this->Width = width;
  this->Height = height;
  this->Samples = samples;

  const GLint previous = BoundTexture(this->Target());
  glGenTextures(1, &this->Texture);
  glBindTexture(this->Target(), this->Texture);
  if (samples > 0)
  {
    glTexStorage2DMultisample(this->Target(), samples, internalFormat, width, height, GL_TRUE);
  }
  else
  {
    glTexStorage2D(this->Target(), 1, internalFormat, width, height);
    glTexParameteri(this->Target(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(this->Target(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  glBindTexture(this->Target(), static_cast<GLuint>(previous));
  return true;
}

void Image2D::Release()
{
  glDeleteTextures(1, &this->Texture);
  *this = Image2D();
}

std::int64_t Image2D::Bytes() const
{
  if (this->Texture == 0)
  {
    return 0;
  }
  const GLint previous = BoundTexture(this->Target());
  glBindTexture(this->Target(), this->Texture);
  const std::int64_t bits = BitsPerTexel(this->Target());
  glBindTexture(this->Target(), static_cast<GLuint>(previous));
  return bits / 8 * this->Width * this->Height * std::max(this->Samples, 1);
}

bool Buffer::Allocate(std::int64_t size, GLenum texelFormat)
{
  if (this->Name == 0)
  {
    glGenBuffers(1, &this->Name);
  }
  while (glGetError() != GL_NO_ERROR)
  {
    // an earlier error must not be taken for this allocation's
  }
  {
    const ScopedBuffer bound(this->Name);
    glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(size), nullptr, GL_DYNAMIC_COPY);
  }
  if (glGetError() != GL_NO_ERROR)
  {
    this->Release();
    return false;
  }
  this->Size = size;

  if (texelFormat != GL_NONE)
  {
    if (this->BufferTexture == 0)
    {
      glGenTextures(1, &this->BufferTexture);
    }
    GLint previous = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_BUFFER, &previous);
    glBindTexture(GL_TEXTURE_BUFFER, this->BufferTexture);
    glTexBuffer(GL_TEXTURE_BUFFER, texelFormat, this->Name);
    glBindTexture(GL_TEXTURE_BUFFER, static_cast<GLuint>(previous));
  }
  return true;
}

void Buffer::Write(std::int64_t offset, std::int64_t size, const void* data)
{
  const ScopedBuffer bound(this->Name);
  glBufferSubData(
    GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(size), data);
}

void Buffer::Read(std::int64_t offset, std::int64_t size, void* data) const
{
  const ScopedBuffer bound(this->Name);
  glGetBufferSubData(
    GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(size), data);
}

void Buffer::Release()
{
  glDeleteTextures(1, &this->BufferTexture);
  glDeleteBuffers(1, &this->Name);
  *this = Buffer();
}

GLuint Framebuffer::Handle()
{
  if (this->Name == 0)
  {
    glGenFramebuffers(1, &this->Name);
  }
  return this->Name;
}

void Framebuffer::Release()
{
  glDeleteFramebuffers(1, &this->Name);
  this->Name = 0;
}

GLuint EmptyVertexArray::Handle()
{
  if (this->Name == 0)
  {
    glGenVertexArrays(1, &this->Name);
  }
  return this->Name;
}

void EmptyVertexArray::Release()
{
  glDeleteVertexArrays(1, &this->Name);
  this->Name = 0;
}

}
