/** The buffers of a store's nodes. Shaders write them as images and read them as textures. */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_NODE_BUFFERS_H
#define VITRINE_TRANSPARENCY_ABUFFER_NODE_BUFFERS_H

#include "gl/GLObjects.h"
#include "gl/ScopedState.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Nodes of 8, 12 or 16 bytes. A node is a texel of a buffer texture. Buffer textures are bounded by texels, not by the
 * size of a shader storage block, which many drivers limit to 128 MiB. The third word of a node of 12 bytes is in a
 * second buffer (Shaders/FragmentNode.glsl). The word of a node's part, if there is one, is in a third buffer.
 */
class NodeBuffers
{
public:
  /**
   * Set the size of a node in bytes without the word of its part, and whether there is such a word. Another size
   * releases the buffers. Returns true if it is another one.
   */
  bool SetNode(int nodeBytes, bool hasPart);

  /** Returns true if nodes have this size. */
  bool HasNode(int nodeBytes, bool hasPart) const
  {
    return nodeBytes == this->BytesPerNode && hasPart == this->HasPart;
  }

  /** Reallocate for `nodes` nodes. Returns false if the driver has no memory for them; there are no buffers then. */
  bool Allocate(std::int64_t nodes);
  void Release();

  ///@{
  /**
   * Read or write the first nodes, without the words of parts. Texels have 2 or 4 words, and nodes of 12
   * bytes have one more, in `thirdWords`, which is empty for others. The vectors tell the number of nodes.
   */
  void Read(std::vector<std::uint32_t>& texels, std::vector<std::uint32_t>& thirdWords) const;
  void Write(
    const std::vector<std::uint32_t>& texels, const std::vector<std::uint32_t>& thirdWords);
  ///@}

  /** Returns the words of a texel, 2 or 4. */
  int TexelWords() const { return this->BytesPerNode == 16 ? 4 : 2; }
  bool HasThirdWords() const { return this->BytesPerNode == 12; }

  /** Returns the largest number of nodes that shaders can address. */
  static std::int64_t LargestCount();

  std::int64_t Count() const { return this->Nodes; }
  std::int64_t Bytes() const
  {
    return this->Texels.Bytes() + this->ThirdWords.Bytes() + this->Parts.Bytes();
  }
  /** Bytes of a node with the word of its part. */
  int NodeBytes() const { return this->BytesPerNode + (this->HasPart ? 4 : 0); }
  /** The number of the allocation, which never comes again for these buffers. */
  std::uint64_t Number() const { return this->Allocation; }
  GLenum Format() const { return this->BytesPerNode == 16 ? GL_RGBA32UI : GL_RG32UI; }
  GLuint Texture() const { return this->Texels.Texture(); }
  GLuint ThirdWordTexture() const { return this->ThirdWords.Texture(); }
  GLuint PartTexture() const { return this->Parts.Texture(); }

private:
  int BytesPerNode = 8;
  bool HasPart = false;
  std::uint64_t Allocation = 0;
  std::int64_t Nodes = 0;
  Buffer Texels;
  Buffer ThirdWords;
  Buffer Parts;
};

/** Binds the buffers as the images that NodeImages.glsl writes while the object lives. */
class ScopedNodeImages
{
public:
  explicit ScopedNodeImages(const NodeBuffers& nodes);

private:
  ScopedImage Texels;
  ScopedImage ThirdWords;
  ScopedImage Parts;
};

}
#endif
