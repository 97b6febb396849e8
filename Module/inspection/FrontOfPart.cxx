#include "inspection/FrontOfPart.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace vitrine
{
namespace
{

/** The number of pixels that are captured at once, unless their fragments are too many for the driver. */
constexpr int BandPixels = 1 << 17;

std::uint32_t NumberOf(const LayerFragment& fragment)
{
  return fragment.Part & ~LayerFragment::BackFace;
}

/** A depth that is NaN counts as 0, as in the methods. */
float DepthIn(const LayerFragment& fragment)
{
  return fragment.Depth > 0.0f ? fragment.Depth : 0.0f;
}

/** Fragments of one pixel, in any order. */
using PixelFragments = std::vector<const LayerFragment*>;

/** Adds the stacks of a pixel: one for each fragment of the parts that is their nearest in some samples. */
void AddPixel(PixelFragments& ofParts, const PixelFragments& others, int x, int y, Fronts& fronts)
{
  std::stable_sort(ofParts.begin(), ofParts.end(),
    [](const LayerFragment* a, const LayerFragment* b) { return DepthIn(*a) < DepthIn(*b); });
  std::uint32_t seen = 0;
  std::vector<std::uint32_t> layers;
  for (const LayerFragment* part : ofParts)
  {
    const std::uint32_t samples = part->Coverage & ~seen;
    seen |= part->Coverage;
    if (samples == 0)
    {
      continue;
    }
    layers.clear();
    for (const LayerFragment* other : others)
    {
      if ((other->Coverage & samples) != 0 && DepthIn(*other) <= DepthIn(*part))
      {
        layers.push_back(NumberOf(*other));
      }
    }
    // Fragments arrive in any order. The same picture shall give the same columns.
    std::sort(layers.begin(), layers.end());
    const std::uint32_t stack = fronts.Stacks.Add(layers.data(), layers.size());
    if (fronts.Near)
    {
      fronts.Near->Add(x, y, stack);
    }
  }
}

/** Indices of fragments, pixel by pixel. */
struct ByPixels
{
  std::vector<std::size_t> Starts; // for each pixel, and the end
  std::vector<std::uint32_t> Indices;

  ByPixels(const std::vector<LayerFragment>& fragments, std::size_t pixels)
    : Starts(pixels + 2, 0)
    , Indices(fragments.size())
  {
    for (const LayerFragment& f : fragments)
    {
      ++this->Starts[std::min<std::size_t>(f.Pixel, pixels) + 1];
    }
    std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
    std::vector<std::size_t> next = this->Starts;
    for (std::size_t i = 0; i < fragments.size(); ++i)
    {
      this->Indices[next[std::min<std::size_t>(fragments[i].Pixel, pixels)]++] =
        static_cast<std::uint32_t>(i);
    }
  }
};
}

void AddFronts(const std::vector<LayerFragment>& fragments, const PixelRegion& region,
  const PartSet& parts, Fronts& fronts)
{
  const std::size_t pixels = static_cast<std::size_t>(region.Width) * region.Height;
  std::vector<bool> hasPart(pixels + 1, false);
  for (const LayerFragment& f : fragments)
  {
    if (f.Pixel < pixels && parts.count(NumberOf(f)) != 0)
    {
      hasPart[f.Pixel] = true;
    }
  }
  const ByPixels sorted(fragments, pixels);
  PixelFragments ofParts;
  PixelFragments others;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel)
  {
    ofParts.clear();
    others.clear();
    for (std::size_t i = sorted.Starts[pixel]; hasPart[pixel] && i < sorted.Starts[pixel + 1]; ++i)
    {
      const LayerFragment& f = fragments[sorted.Indices[i]];
      if (parts.count(NumberOf(f)) != 0)
      {
        ofParts.push_back(&f);
      }
      else if ((f.Kind & LayerFragment::Added) == 0)
      {
        others.push_back(&f);
      }
    }
    if (!ofParts.empty())
    {
      const auto at = static_cast<int>(pixel);
      AddPixel(ofParts, others, region.X + at % region.Width, region.Y + at / region.Width, fronts);
    }
  }
}

std::string CaptureFronts(LayerCapture& capture, const FrameOfRenderer& frame,
  const PixelRegion& region, const PartSet& parts, Fronts& fronts)
{
  int rows = std::clamp(BandPixels / std::max(1, region.Width), 1, std::max(1, region.Height));
  for (int row = 0; row < region.Height;)
  {
    const PixelRegion band{ region.X, region.Y + row, region.Width,
      std::min(rows, region.Height - row) };
    std::vector<LayerFragment> fragments;
    const std::string problem =
      capture.Capture(frame.RequestOf(band, /* translucent= */ true), fragments);
    if (problem.empty())
    {
      AddFronts(fragments, band, parts, fronts);
      row += band.Height;
    }
    else if (rows > 1) // there may be room for the fragments of fewer pixels
    {
      rows /= 2;
    }
    else
    {
      return problem;
    }
  }
  return {};
}

}
