/**
 * The few GL objects that the passes hold: an image to render into, a buffer, each with its size in bytes.
 *
 * They belong to the context that is current at their first use; Release() needs that context current, and
 * their destructors free nothing, since no context need be current by then. They move and do not copy.
 */
#ifndef VITRINE_GL_GL_OBJECTS_H
#define VITRINE_GL_GL_OBJECTS_H

#include "gl/VitrineOpenGL.h"

#include <cstdint>
#include <string>
#include <utility>

namespace vitrine
{

/** The name of a GL object, which one owner has: what it is moved from holds no name. */
class ObjectName
{
public:
  ObjectName() = default;
  ObjectName(ObjectName&& other) noexcept
    : Name(std::exchange(other.Name, 0))
  {
  }
  ObjectName& operator=(ObjectName&& other) noexcept
  {
    this->Name = std::exchange(other.Name, 0);
    return *this;
  }

  operator GLuint() const { return this->Name; }
  GLuint* Address() { return &this->Name; }

private:
  GLuint Name = 0;
};

/** A 2D texture or an array of them, single- or multisampled, sampled by texelFetch only. */
class Image2D
{
public:
  /**
   * (Re)allocate where anything differs; contents are undefined and the name is a new one then. Returns an empty
   * string, or why the driver cannot hold such an image: there is none then. Any `layers` but 0 make an array.
   */
  std::string Allocate(GLenum internalFormat, int width, int height, int samples, int layers = 0);
  void Release();

  GLuint Handle() const { return this->Texture; }
  GLenum Target() const;
  std::int64_t Bytes() const;

private:
  void AllocateTexture();

  ObjectName Texture;
  GLenum InternalFormat = GL_NONE;
  int Width = 0;
  int Height = 0;
  int Samples = 0;
  int Layers = 0;
};

/** A buffer, and a buffer texture over it if a texel format is given. */
class Buffer
{
public:
  /**
   * Reallocate to `size` bytes; contents are undefined. Returns false if the driver has no memory for it: there is
   * no buffer then.
   */
  bool Allocate(std::int64_t size, GLenum texelFormat = GL_NONE);
  void Release();

  void Write(std::int64_t offset, std::int64_t size, const void* data);

  /** Waits for the device. */
  void Read(std::int64_t offset, std::int64_t size, void* data) const;

  GLuint Handle() const { return this->Name; }
  GLuint Texture() const { return this->BufferTexture; }
  std::int64_t Bytes() const { return this->Size; }

private:
  void AttachTexture(GLenum texelFormat);

  ObjectName Name;
  ObjectName BufferTexture;
  std::int64_t Size = 0;
};

/** A framebuffer object made on demand. */
class Framebuffer
{
public:
  GLuint Handle();
  void Release();

private:
  ObjectName Name;
};

/** A vertex array without attributes, for draws that make their vertices from gl_VertexID. */
class EmptyVertexArray
{
public:
  GLuint Handle();
  void Release();

private:
  ObjectName Name;
};

}
#endif
