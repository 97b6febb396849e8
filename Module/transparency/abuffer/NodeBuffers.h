/** The buffers of a store's nodes. Shaders write them as images and read them as textures. */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_NODE_BUFFERS_H
#define VITRINE_TRANSPARENCY_ABUFFER_NODE_BUFFERS_H

#include "gl/GLObjects.h"
#include "gl/ScopedState.h"

#include <cstdint>

namespace vitrine
{

/**
 * Nodes of 8, 12 or 16 bytes. A node is a texel of a buffer texture. Buffer textures are bounded by texels, not by the
 * size of a shader storage block, which many drivers limit to 128 MiB. The third word of a node of 12 bytes is in a
 * second buffer (Shaders/FragmentNode.glsl).
 */
class NodeBuffers
{
public:
  /** Set the size of a node in bytes. Another size releases the buffers. */
  void SetNodeBytes(int nodeBytes);

  /** Reallocate for `nodes` nodes. Returns false if the driver has no memory for them; there are no buffers then. */
  bool Allocate(std::int64_t nodes);
  void Release();

  /** Returns the largest number of nodes that shaders can address. */
  static std::int64_t LargestCount();

  std::int64_t Count() const { return this->Nodes; }
  std::int64_t Bytes() const { return this->Texels.Bytes() + this->ThirdWords.Bytes(); }
  int NodeBytes() const { return this->BytesPerNode; }
  GLenum Format() const { return this->BytesPerNode == 16 ? GL_RGBA32UI : GL_RG32UI; }
  GLuint Texture() const { return this->Texels.Texture(); }
  GLuint ThirdWordTexture() const { return this->ThirdWords.Texture(); }

private:
  int BytesPerNode = 8;
  std::int64_t Nodes = 0;
  Buffer Texels;
  Buffer ThirdWords;
};

/** Binds the buffers as the images that NodeImages.glsl writes while the object lives. */
class ScopedNodeImages
{
public:
  explicit ScopedNodeImages(const NodeBuffers& nodes);

private:
  ScopedImage Texels;
  ScopedImage ThirdWords;
};

}
#endif
