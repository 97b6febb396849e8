#include "transparency/ranks/FrameFacts.h"

#include <cstring>

namespace vitrine
{
namespace
{

std::string SizeText(const FrameFacts& facts)
{
  return std::to_string(facts.Width) + " x " + std::to_string(facts.Height) + " pixels";
}

// Returns what is different about `facts`, and of `first`, those of rank 0.
std::string Compare(const FrameFacts& facts, const FrameFacts& first)
{
  if (facts.Width != first.Width || facts.Height != first.Height)
  {
    return "draws " + SizeText(facts) + " and rank 0 " + SizeText(first) +
      "; give all windows one size";
  }
  if (!(facts.Region == first.Region))
  {
    return "draws another part of the window than rank 0; give all renderers one viewport";
  }
  if (facts.ColorFormat != first.ColorFormat || facts.DepthFormat != first.DepthFormat)
  {
    return "has another format of pixels than rank 0; make all windows alike";
  }
  if (facts.ColorStorage != first.ColorStorage || facts.PictureRank != first.PictureRank ||
    facts.ToleranceSteps != first.ToleranceSteps || facts.ToleranceSlope != first.ToleranceSlope)
  {
    return "has another color storage, coincidence tolerance or picture rank than rank 0; give all "
           "passes one "
           "setting";
  }
  if (facts.Matrices != first.Matrices)
  {
    return "has another camera than rank 0; call SynchronizeCamera() on all ranks before they "
           "render";
  }
  return {};
}

}

Message FrameFacts::ToMessage() const
{
  Message message(sizeof(*this));
  std::memcpy(message.data(), this, sizeof(*this));
  return message;
}

std::string FindDifference(const std::vector<Message>& factsOfRanks)
{
  std::vector<FrameFacts> facts(factsOfRanks.size());
  for (std::size_t rank = 0; rank < facts.size(); ++rank)
  {
    if (factsOfRanks[rank].size() != sizeof(FrameFacts))
    {
      return "rank " + std::to_string(rank) + " has another version of this library than others";
    }
    std::memcpy(&facts[rank], factsOfRanks[rank].data(), sizeof(FrameFacts));
    const std::string difference = Compare(facts[rank], facts[0]);
    if (!difference.empty())
    {
      return "rank " + std::to_string(rank) + " " + difference;
    }
  }
  return {};
}

}
