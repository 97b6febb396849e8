#include "Core/culling/PartCuller.h"

#include "Core/ForEachInThreads.h"

#include <algorithm>

namespace vitrine
{

namespace
{

/** What the tree holds and does not show is not visible. By the million, so without branches. */
void KeepShown(const std::uint8_t* states, const std::uint8_t* isHeld, std::size_t count,
  std::uint8_t* isVisible)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const int isShown = (states[i] & PartStates::IsShown) != 0;
    isVisible[i] &= static_cast<std::uint8_t>(isShown | (isHeld[i] ^ 1));
  }
}
}

PartCuller::PartCuller(int columns, int lines, const SampleGrid& samples, int bands)
{
  const int count = std::min(bands, lines);
  for (int i = 0; i < count; ++i)
  {
    const int first = i * lines / count, end = (i + 1) * lines / count;
    this->Bands.push_back({ first, BandCuller(columns, end - first, samples) });
  }
}

void PartCuller::Cull(const LooseOctree& tree, OccluderSource& occluders,
  const ScreenProjection& view, bool occlusion, std::vector<std::uint8_t>& visible)
{
  ForEachInThreads(this->Bands.size(),
    [&](std::size_t i)
    {
      BandCuller& culler = this->Bands[i].Culler;
      const ScreenProjection ofBand =
        view.OfLines(this->Bands[i].FirstLine, culler.Buffer().Lines());
      culler.Cull(tree, occluders, ofBand, occlusion, visible, this->Bands.size());
    });
  const std::size_t count = std::min(tree.HeldItems().size(), visible.size());
  KeepShown(this->StatesInAny().data(), tree.HeldItems().data(), count, visible.data());
}

std::vector<std::uint8_t> PartCuller::StayHidden(
  const std::vector<BoxedPart>& parts, ShapeSource& shapes, const ScreenProjection& view)
{
  std::vector<std::vector<std::uint8_t>> hidden(this->Bands.size());
  ForEachInThreads(this->Bands.size(),
    [&](std::size_t i)
    {
      BandCuller& culler = this->Bands[i].Culler;
      const ScreenProjection ofBand =
        view.OfLines(this->Bands[i].FirstLine, culler.Buffer().Lines());
      hidden[i].assign(parts.size(), 1);
      culler.LookAgain(parts, shapes, ofBand, hidden[i]);
    });
  for (const std::vector<std::uint8_t>& ofBand : hidden)
  {
    std::transform(ofBand.begin(), ofBand.end(), hidden[0].begin(), hidden[0].begin(),
      [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(a & b); });
  }
  return hidden[0];
}

/** Of each part what is so in a band. */
const std::vector<std::uint8_t>& PartCuller::StatesInAny()
{
  if (this->Bands.size() == 1)
  {
    return this->Bands[0].Culler.States().All();
  }
  this->States = this->Bands[0].Culler.States().All();
  for (std::size_t i = 1; i < this->Bands.size(); ++i)
  {
    const std::vector<std::uint8_t>& ofBand = this->Bands[i].Culler.States().All();
    std::transform(this->States.begin(), this->States.end(), ofBand.begin(), this->States.begin(),
      [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(a | b); });
  }
  return this->States;
}

CullCounts PartCuller::Counts() const
{
  CullCounts sum;
  for (const Band& band : this->Bands)
  {
    const CullCounts& counts = band.Culler.Counts();
    sum.Nodes += counts.Nodes;
    sum.Tested += counts.Tested;
    sum.Inserted += counts.Inserted;
  }
  return sum;
}

SBufferCounts PartCuller::BufferCounts() const
{
  SBufferCounts sum;
  for (const Band& band : this->Bands)
  {
    const SBufferCounts& counts = band.Culler.Buffer().Counts();
    sum.Inserted += counts.Inserted;
    sum.Comparisons += counts.Comparisons;
    sum.Refused += counts.Refused;
  }
  return sum;
}

}
