/**
 * The GL objects that passes hold: images to render into and buffers, with their size in bytes, and a few more.
 *
 * An object belongs to the context that is current at its first use, and Release() needs that context current.
 * Destructors free nothing, since there may be no current context by then. Objects can be moved, not copied.
 */
#ifndef VITRINE_GL_GL_OBJECTS_H
#define VITRINE_GL_GL_OBJECTS_H

#include "gl/VitrineOpenGL.h"

#include <cstdint>
#include <string>
#include <utility>

class vtkOpenGLState;

namespace vitrine
{

/** The name of a GL object, with one owner. A moved-from owner holds no name. */
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

/** A 2D texture or an array of them, single- or multisampled. Shaders sample it by texelFetch only. */
class Image2D
{
public:
  /**
   * Reallocate the image if any parameter differs. Then its contents are undefined, and its name is new. With `layers`
   * other than 0 it is an array. Returns an error message if the driver cannot hold such an image; there is no image
   * then.
   */
  std::string Allocate(GLenum internalFormat, int width, int height, int samples, int layers = 0);
  void Release();

  GLuint Handle() const { return this->Texture; }
  GLenum Target() const;
  std::int64_t Bytes() const;

  /** The number of the allocation. Other than the texture's name, it never comes again. It is 0 without an image. */
  std::uint64_t Number() const { return this->Allocation; }

private:
  void AllocateTexture();

  ObjectName Texture;
  GLenum InternalFormat = GL_NONE;
  int Width = 0;
  int Height = 0;
  int Samples = 0;
  int Layers = 0;
  std::int64_t BitsPerTexel = 0; // The number that the driver allocated.
  std::uint64_t Allocation = 0;
};

/** A buffer. If a texel format is given, it has a buffer texture. */
class Buffer
{
public:
  /**
   * Reallocate to `size` bytes. The contents are undefined. Returns false if the driver has no memory for it; there is
   * no buffer then.
   */
  bool Allocate(std::int64_t size, GLenum texelFormat = GL_NONE, GLenum usage = GL_DYNAMIC_COPY);
  void Release();

  /** Set all bytes to 0, on the device. Needs OpenGL 4.3. */
  void Clear();

  void Write(std::int64_t offset, std::int64_t size, const void* data);

  /**
   * Copy the first bytes of `source` to `offset`, on the device. A driver may move a buffer that is read back into the
   * memory of the CPU, where shaders are slow to change it. So read back a copy, in a buffer of usage GL_STREAM_READ.
   */
  void CopyFrom(
    const Buffer& source, std::int64_t sourceOffset, std::int64_t offset, std::int64_t size);

  /** Read bytes back. Waits for the device. */
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

/** A framebuffer object that is made on demand. */
class Framebuffer
{
public:
  GLuint Handle();

  /** Make the image the first colour attachment. Changes the framebuffer binding, unless the image is attached. */
  void Attach(vtkOpenGLState* state, const Image2D& image);

  void Release();

private:
  ObjectName Name;
  std::uint64_t Attached = 0; // Number() of the attached image.
};

/** A vertex array without attributes, for draws that compute their vertices from gl_VertexID. */
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
