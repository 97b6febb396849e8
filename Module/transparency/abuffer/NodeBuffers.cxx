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

bool NodeBuffers::SetNode(int nodeBytes, bool hasPart)
{
  assert(nodeBytes == 8 || nodeBytes == 12 || nodeBytes == 16);
  if (this->HasNode(nodeBytes, hasPart))
  {
    return false;
  }
  this->Release();
  this->BytesPerNode = nodeBytes;
  this->HasPart = hasPart;
  return true;
}

bool NodeBuffers::Allocate(std::int64_t nodes)
{
  const bool hasThirdWords = this->BytesPerNode == 12;
  const int texelBytes = hasThirdWords ? this->BytesPerNode - WordBytes : this->BytesPerNode;
  ++this->Allocation;
  const bool allocated = this->Texels.Allocate(nodes * texelBytes, this->Format()) &&
    (!hasThirdWords || this->ThirdWords.Allocate(nodes * WordBytes, GL_R32UI)) &&
    (!this->HasPart || this->Parts.Allocate(nodes * WordBytes, GL_R32UI));
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
  this->Parts.Release();
  ++this->Allocation;
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
  , Parts(VITRINE_IMAGE_PARTS, nodes.PartTexture())
{
}

}
