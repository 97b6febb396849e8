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
  const bool hasThirdWords = this->HasThirdWords();
  const int texelBytes = this->TexelWords() * WordBytes;
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

void NodeBuffers::Read(
  std::vector<std::uint32_t>& texels, std::vector<std::uint32_t>& thirdWords) const
{
  this->Texels.Read(0, static_cast<std::int64_t>(texels.size()) * WordBytes, texels.data());
  if (!thirdWords.empty())
  {
    this->ThirdWords.Read(
      0, static_cast<std::int64_t>(thirdWords.size()) * WordBytes, thirdWords.data());
  }
}

void NodeBuffers::Write(
  const std::vector<std::uint32_t>& texels, const std::vector<std::uint32_t>& thirdWords)
{
  this->Texels.Write(0, static_cast<std::int64_t>(texels.size()) * WordBytes, texels.data());
  if (!thirdWords.empty())
  {
    this->ThirdWords.Write(
      0, static_cast<std::int64_t>(thirdWords.size()) * WordBytes, thirdWords.data());
  }
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
