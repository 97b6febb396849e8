#include "Core/culling/walk/PartCuller.h"

#include "Core/threads/ForEachInThreads.h"

#include <algorithm>

namespace vitrine
{

PartCuller::PartCuller(int columns, int lines, const SampleGrid& samples, int bands)
{
  const int ofPixel = samples.LinesPerPixel();
  const int pixels = (lines + ofPixel - 1) / ofPixel;
  const int count = std::min(bands, pixels);
  for (int i = 0; i < count; ++i)
  {
    const int first = ofPixel * (i * pixels / count);
    const int end = std::min(ofPixel * ((i + 1) * pixels / count), lines);
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
  this->KeepShown(tree, visible);
}

/**
 * Sets the bytes of all parts: a part in the tree is visible if a band shows it. There may be a million parts, few of
 * which show, so no work is done for each of them.
 */
void PartCuller::KeepShown(const LooseOctree& tree, std::vector<std::uint8_t>& visible)
{
  const std::size_t count = std::min(tree.ItemCount(), visible.size());
  const std::vector<std::uint32_t>& unplaced = tree.Unplaced();
  const auto end = std::lower_bound(unplaced.begin(), unplaced.end(), count);
  this->Unplaced.clear();
  std::for_each(
    unplaced.begin(), end, [&](std::uint32_t part) { this->Unplaced.push_back(visible[part]); });
  std::fill_n(visible.begin(), count, std::uint8_t{ 0 });
  for (std::size_t i = 0; i < this->Unplaced.size(); ++i)
  {
    visible[unplaced[i]] = this->Unplaced[i];
  }
  for (const Band& band : this->Bands)
  {
    band.Culler.AddShown(visible);
  }
}

std::vector<std::uint8_t> PartCuller::VerifyHidden(
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
      culler.VerifyHidden(parts, shapes, ofBand, hidden[i]);
    });
  for (const std::vector<std::uint8_t>& ofBand : hidden)
  {
    std::transform(ofBand.begin(), ofBand.end(), hidden[0].begin(), hidden[0].begin(),
      [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(a & b); });
  }
  return hidden[0];
}

int PartCuller::LineCount() const
{
  const Band& last = this->Bands.back();
  return last.FirstLine + last.Culler.Buffer().Lines();
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
