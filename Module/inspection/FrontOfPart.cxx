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

/**
 * Returns the layers that cover the first of some samples, and not behind a depth. Takes that sample from `samples`,
 * and all that have the same layers.
 */
std::vector<std::uint32_t> TakeLayers(
  const PixelFragments& others, float depth, std::uint32_t& samples)
{
  const std::uint32_t first = samples & (~samples + 1);
  std::uint32_t same = samples;
  std::vector<std::uint32_t> layers;
  for (const LayerFragment* other : others)
  {
    if (DepthIn(*other) <= depth)
    {
      const bool isCovered = (other->Coverage & first) != 0;
      same &= isCovered ? other->Coverage : ~other->Coverage;
      if (isCovered)
      {
        layers.push_back(NumberOf(*other));
      }
    }
  }
  samples &= ~same;
  // Fragments arrive in any order. The same picture shall give the same columns.
  std::sort(layers.begin(), layers.end());
  return layers;
}

/** Adds the stacks of a pixel's samples, before the nearest fragment of the parts in each of them. */
void AddPixel(PixelFragments& ofParts, const PixelFragments& others, int x, int y, Fronts& fronts)
{
  std::stable_sort(ofParts.begin(), ofParts.end(),
    [](const LayerFragment* a, const LayerFragment* b) { return DepthIn(*a) < DepthIn(*b); });
  std::uint32_t seen = 0;
  for (const LayerFragment* part : ofParts)
  {
    std::uint32_t samples = part->Coverage & ~seen;
    seen |= part->Coverage;
    while (samples != 0)
    {
      const std::vector<std::uint32_t> layers = TakeLayers(others, DepthIn(*part), samples);
      const std::uint32_t stack = fronts.Stacks.Add(layers.data(), layers.size());
      if (fronts.Near)
      {
        fronts.Near->Add(x, y, stack);
      }
    }
  }
  ++fronts.Pixels;
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
