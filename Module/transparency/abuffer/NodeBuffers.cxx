#include "transparency/abuffer/NodeBuffers.h"

#include "Shaders/SharedLayout.h"
#include "gl/Capabilities.h"

#include <cassert>

namespace vitrine
{
namespace
{

constexpr int WordBytes = sizeof(uint);

}

void NodeBuffers::SetNodeBytes(int nodeBytes)
{
  assert(nodeBytes == 8 || nodeBytes == 12 || nodeBytes == 16);
  if (nodeBytes != this->BytesPerNode)
  {
    this->Release();
    this->BytesPerNode = nodeBytes;
  }
}

bool NodeBuffers::Allocate(std::int64_t nodes)
{
  const bool hasThirdWords = this->BytesPerNode == 12;
  const int texelBytes = hasThirdWords ? this->BytesPerNode - WordBytes : this->BytesPerNode;
  const bool allocated = this->Texels.Allocate(nodes * texelBytes, this->Format()) &&
    (!hasThirdWords || this->ThirdWords.Allocate(nodes * WordBytes, GL_R32UI));
  if (!allocated)
  {
    this->Release();
    return false;
  }
  this->Nodes = nodes;
  return true;
}

void NodeBuffers::Release()
{
  this->Texels.Release();
  this->ThirdWords.Release();
  this->Nodes = 0;
}

std::int64_t NodeBuffers::LargestCount()
{
  return LargestBufferTexture();
}

//------------------------------------------------------------------------------
ScopedNodeImages::ScopedNodeImages(const NodeBuffers& nodes)
  : Texels(VITRINE_IMAGE_NODES, nodes.Texture(), nodes.Format())
  , ThirdWords(VITRINE_IMAGE_THIRD_WORDS, nodes.ThirdWordTexture())
{
}

}
