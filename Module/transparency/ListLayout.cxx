#include "transparency/ListLayout.h"

#include <cstdint>

namespace vitrine
{

std::vector<std::string> ListLayout::Defines() const
{
  std::vector<std::string> defines = { "VITRINE_SAMPLES " + std::to_string(this->Samples),
    "VITRINE_PAGE_SIZE " + std::to_string(this->PageSize) };
  if (this->Packed)
  {
    defines.emplace_back("VITRINE_PACKED_LISTS");
  }
  if (this->HalfFloat)
  {
    defines.emplace_back("VITRINE_HALF_FLOAT");
  }
  if (this->FixedPoint)
  {
    defines.emplace_back("VITRINE_FIXED_POINT_TARGET");
  }
  if (this->FramebufferFetch)
  {
    defines.emplace_back("VITRINE_FRAMEBUFFER_FETCH");
  }
  return defines;
}

int ListLayout::NodeBytes() const
{
  const int words = 1 + (this->HalfFloat ? 2 : 1) + (this->Samples > 0 ? 1 : 0);
  return words * static_cast<int>(sizeof(std::uint32_t));
}

}
