#include "transparency/abuffer/ListLayout.h"

#include <cstdint>

namespace vitrine
{

const char* ListLayout::ColorDefine() const
{
  switch (this->Colors)
  {
    case NodeColors::HalfFloat:
      return "VITRINE_HALF_FLOAT";
    case NodeColors::Compact:
      return "VITRINE_COMPACT_NODES";
    case NodeColors::EightBit:
      break;
  }
  return nullptr;
}

std::vector<std::string> ListLayout::Defines() const
{
  std::vector<std::string> defines = { "VITRINE_SAMPLES " + std::to_string(this->Samples),
    "VITRINE_PAGE_SIZE " + std::to_string(this->PageSize) };
  if (this->ResolvesAllSamples())
  {
    defines.emplace_back("VITRINE_ALL_SAMPLES");
  }
  if (this->Packed)
  {
    defines.emplace_back("VITRINE_PACKED_LISTS");
  }
  if (const char* colors = this->ColorDefine())
  {
    defines.emplace_back(colors);
  }
  if (this->FixedPoint)
  {
    defines.emplace_back("VITRINE_FIXED_POINT_TARGET");
  }
  if (this->Additive)
  {
    defines.emplace_back("VITRINE_ADDITIVE");
  }
  if (this->Coincidence)
  {
    defines.emplace_back("VITRINE_COINCIDENCE");
  }
  if (this->ErrorBounds)
  {
    defines.emplace_back("VITRINE_ERROR_BOUND");
    if (this->FixedBound)
    {
      defines.emplace_back("VITRINE_FIXED_BOUND");
    }
  }
  if (this->HiddenDepths)
  {
    defines.emplace_back("VITRINE_HIDDEN_DEPTHS");
  }
  if (this->FramebufferFetch)
  {
    defines.emplace_back("VITRINE_FRAMEBUFFER_FETCH");
  }
  return defines;
}

int ListLayout::NodeBytes() const
{
  return this->NodeWords() * static_cast<int>(sizeof(std::uint32_t));
}

int ListLayout::NodeWords() const
{
  const bool hasExtra = this->Samples > 0 || this->Coincidence;
  return 1 + (this->Colors == NodeColors::HalfFloat ? 2 : 1) + (hasExtra ? 1 : 0);
}

// A network that takes the fragments of one sample has no coverage in registers.
int ListLayout::FragmentWords() const
{
  const bool dropsCoverage = this->Samples > 0 && !this->Coincidence && !this->ResolvesAllSamples();
  return this->NodeWords() - (dropsCoverage ? 1 : 0);
}

}
