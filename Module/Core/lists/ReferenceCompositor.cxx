#include "Core/lists/ReferenceCompositor.h"

#include "Core/lists/CoincidentGroup.h"
#include "Core/lists/StoredColor.h"
#include "Core/threads/ForEachInThreads.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <tuple>
#include <utility>

namespace vitrine
{

namespace
{

// The pixels First to End - 1.
struct PixelRange
{
  std::size_t First;
  std::size_t End;
};

// A sanitized fragment.
struct Layer
{
  float Depth;
  std::tuple<std::uint64_t, std::uint64_t> Order; // of layers of equal depth
  float A;
  float B;
  float G;
  float R;
  std::uint32_t Coverage;
  float Extent;
  bool IsAdded; // its colour is premultiplied, and A is 0

  // Returns the share of the colour that is visible if nothing is in front.
  double Weight() const { return this->IsAdded ? 1.0 : this->A; }

  bool IsInFrontOf(const Layer& other) const
  {
    return std::tie(this->Depth, this->Order, this->A, this->B, this->G, this->R) <
      std::tie(other.Depth, other.Order, other.A, other.B, other.G, other.R);
  }

  bool HasLesserColor(const Layer& other) const
  {
    return std::tie(this->Order, this->A, this->B, this->G, this->R) <
      std::tie(other.Order, other.A, other.B, other.G, other.R);
  }

  // Returns the far end of the interval. Without an extent it is minus infinity, so no other layer meets it.
  float FarEnd() const
  {
    return this->Extent > 0.0f ? this->Depth + this->Extent
                               : -std::numeric_limits<float>::infinity();
  }
};

// Packs a number in [0, 65504] into an unsigned 16-bit float: 5 bits of exponent, 11 bits of mantissa, rounded. Code 0
// begins at `exponent`, a biased single-precision exponent.
std::uint64_t Packed16(float value, std::int64_t exponent)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  const std::int64_t code = ((std::int64_t(bits) + 0x800) >> 12) - (exponent << 11);
  return static_cast<std::uint64_t>(std::clamp<std::int64_t>(code, 0, 0xffff));
}

// Colours are ordered by the precision of storage, alpha first. The last bits of a float are noise of the rasteriser's
// interpolation: even a constant alpha differs in them from pixel to pixel.
std::tuple<std::uint64_t, std::uint64_t> OrderOf(const Layer& layer, TargetRange range)
{
  if (range == TargetRange::Unit)
  {
    return ColorOrder(StoredColor(layer.R, layer.G, layer.B, layer.A));
  }
  const std::int64_t unitExponent = 96;
  const std::int64_t colorExponent = range == TargetRange::NonNegative ? 111 : unitExponent;
  return { Packed16(layer.A, unitExponent) << 16 | Packed16(layer.B, colorExponent),
    Packed16(layer.G, colorExponent) << 16 | Packed16(layer.R, colorExponent) };
}

// NaN, for which every comparison is false, becomes 0.
float Clamped(float value, float largest)
{
  return value > 0.0f ? std::min(value, largest) : 0.0f;
}

std::uint32_t PixelOf(const CapturedFragment& fragment)
{
  return fragment.Pixel & ~CapturedFragment::Added;
}

// A colour without alpha adds nothing, even if it is infinite.
void Premultiply(Layer& layer)
{
  for (float* const color : { &layer.R, &layer.G, &layer.B })
  {
    *color = layer.A > 0.0f ? layer.A * *color : 0.0f;
  }
  layer.A = 0.0f;
}

Layer MakeLayer(const CapturedFragment& fragment, TargetRange range)
{
  const float largest =
    range == TargetRange::NonNegative ? std::numeric_limits<float>::infinity() : 1.0f;
  const bool hasDepth = fragment.Depth == fragment.Depth;
  Layer layer = { hasDepth ? fragment.Depth : 0.0f, {}, Clamped(fragment.Rgba[3], 1.0f),
    Clamped(fragment.Rgba[2], largest), Clamped(fragment.Rgba[1], largest),
    Clamped(fragment.Rgba[0], largest), fragment.Coverage, fragment.Extent,
    (fragment.Pixel & CapturedFragment::Added) != 0 };
  if (layer.IsAdded)
  {
    Premultiply(layer);
  }
  layer.Order = OrderOf(layer, range);
  return layer;
}

// A view ray that passes the layers of a sample, front to back.
struct Ray
{
  double Sum[3] = { 0.0, 0.0, 0.0 };
  double Transmittance = 1.0;

  void Pass(const Layer& layer)
  {
    const double weight = this->Transmittance * layer.Weight();
    // A layer of weight 0 adds nothing, even if its colour is infinite.
    if (weight == 0.0)
    {
      return;
    }
    this->Sum[0] += weight * layer.R;
    this->Sum[1] += weight * layer.G;
    this->Sum[2] += weight * layer.B;
    this->Transmittance *= 1.0 - layer.A;
  }

  // Passes a group of coincident layers.
  void Pass(const CoincidentGroup& group)
  {
    group.AddColor(this->Transmittance, this->Sum);
    this->Transmittance *= group.Transmittance();
  }
};

// Returns the end of the group of coincident layers that begins at `first`. Layers are ordered by their near ends.
std::size_t EndOfGroup(const std::vector<Layer>& layers, std::size_t first)
{
  float farEnd = layers[first].FarEnd();
  std::size_t end = first + 1;
  while (end < layers.size() && layers[end].Depth <= farEnd)
  {
    farEnd = std::max(farEnd, layers[end].FarEnd());
    ++end;
  }
  return end;
}

// Layers of a group arrive in any order. Sorting makes the sum the same to the last bit.
CoincidentGroup MakeGroup(std::vector<Layer> layers)
{
  std::sort(layers.begin(), layers.end(),
    [](const Layer& a, const Layer& b) { return a.HasLesserColor(b); });
  CoincidentGroup group;
  for (const Layer& layer : layers)
  {
    const double rgb[3] = { layer.R, layer.G, layer.B };
    layer.IsAdded ? group.AddLight(rgb) : group.Add(layer.A, rgb);
  }
  return group;
}

// Composites layers, front to back, over the colour in `rgba`.
void CompositeSample(const std::vector<Layer>& layers, double* rgba)
{
  Ray ray;
  for (std::size_t first = 0, end = 0; first < layers.size(); first = end)
  {
    end = EndOfGroup(layers, first);
    if (end == first + 1)
    {
      ray.Pass(layers[first]);
    }
    else
    {
      ray.Pass(MakeGroup({ layers.begin() + first, layers.begin() + end }));
    }
  }
  for (int channel = 0; channel < 3; ++channel)
  {
    const double behind = ray.Transmittance == 0.0 ? 0.0 : ray.Transmittance * rgba[channel];
    rgba[channel] = ray.Sum[channel] + behind;
  }
  rgba[3] = (1.0 - ray.Transmittance) + ray.Transmittance * rgba[3];
}
}

// The fragments of each pixel p: Order[Begin[p]] to Order[Begin[p + 1] - 1].
struct ReferenceCompositor::PixelLists
{
  std::vector<std::size_t> Begin;
  std::vector<std::uint32_t> Order;

  std::size_t Length(std::size_t pixel) const
  {
    return this->Begin[pixel + 1] - this->Begin[pixel];
  }
};

ReferenceCompositor::ReferenceCompositor(
  int width, int height, int samples, TargetRange range, std::vector<double> backdrop)
  : PixelCount(static_cast<std::size_t>(std::max(width, 0)) * std::max(height, 0))
  , SamplesPerPixel(std::max(samples, 0))
  , Range(range)
  , Picture(std::move(backdrop))
  , IsComposited(this->PixelCount)
{
  if (width < 0 || height < 0 || samples < 1 || samples > 32 ||
    this->Picture.size() != this->PixelCount * this->SamplesPerPixel * 4)
  {
    throw std::invalid_argument("backdrop of " + std::to_string(this->Picture.size()) +
      " values does not match a picture of " + std::to_string(width) + " x " +
      std::to_string(height) + " pixels of " + std::to_string(samples) + " samples");
  }
}

void ReferenceCompositor::AddBatch(const CapturedFragment* fragments, std::size_t count)
{
  const PixelLists lists = this->SortByPixel(fragments, count);

  // Contiguous ranges of pixels, each with about the same number of fragments.
  const std::size_t threads = std::max(2u, std::thread::hardware_concurrency());
  std::vector<PixelRange> ranges;
  std::size_t firstPixel = 0;
  for (std::size_t thread = 1; thread <= threads; ++thread)
  {
    const std::size_t share = count / threads * thread + count % threads * thread / threads;
    const auto end = std::lower_bound(lists.Begin.begin(), lists.Begin.end() - 1, share);
    const std::size_t lastPixel =
      thread == threads ? this->PixelCount : static_cast<std::size_t>(end - lists.Begin.begin());
    if (lastPixel > firstPixel)
    {
      ranges.push_back({ firstPixel, lastPixel });
      firstPixel = lastPixel;
    }
  }
  ForEachInThreads(ranges.size(),
    [&](std::size_t i)
    { this->CompositePixels(fragments, lists, ranges[i].First, ranges[i].End); });

  this->Fragments += count;
  for (std::size_t pixel = 0; pixel < this->PixelCount; ++pixel)
  {
    if (lists.Length(pixel) > 0)
    {
      this->IsComposited[pixel] = true;
      ++this->CoveredPixels;
      this->DeepestPixel = std::max<std::uint64_t>(this->DeepestPixel, lists.Length(pixel));
    }
  }
}

ReferenceCompositor::PixelLists ReferenceCompositor::SortByPixel(
  const CapturedFragment* fragments, std::size_t count) const
{
  if (count > std::numeric_limits<std::uint32_t>::max())
  {
    throw std::invalid_argument("a batch holds at most 2^32 - 1 fragments");
  }
  PixelLists lists{ std::vector<std::size_t>(this->PixelCount + 1),
    std::vector<std::uint32_t>(count) };
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::uint32_t pixel = PixelOf(fragments[i]);
    if (pixel >= this->PixelCount || this->IsComposited[pixel])
    {
      throw std::invalid_argument("pixel " + std::to_string(pixel) +
        (pixel < this->PixelCount ? " was in an earlier batch" : " lies outside the picture"));
    }
    ++lists.Begin[pixel + 1];
  }
  std::partial_sum(lists.Begin.begin(), lists.Begin.end(), lists.Begin.begin());

  std::vector<std::size_t> next(lists.Begin.begin(), lists.Begin.end() - 1);
  for (std::size_t i = 0; i < count; ++i)
  {
    lists.Order[next[PixelOf(fragments[i])]++] = static_cast<std::uint32_t>(i);
  }
  return lists;
}

void ReferenceCompositor::CompositePixels(const CapturedFragment* fragments,
  const PixelLists& lists, std::size_t firstPixel, std::size_t lastPixel)
{
  std::vector<Layer> layers;
  std::vector<Layer> covering;
  for (std::size_t pixel = firstPixel; pixel < lastPixel; ++pixel)
  {
    if (lists.Length(pixel) == 0)
    {
      continue;
    }
    layers.clear();
    for (std::size_t i = lists.Begin[pixel]; i < lists.Begin[pixel + 1]; ++i)
    {
      layers.push_back(MakeLayer(fragments[lists.Order[i]], this->Range));
    }
    std::sort(layers.begin(), layers.end(),
      [](const Layer& a, const Layer& b) { return a.IsInFrontOf(b); });
    for (std::size_t sample = 0; sample < this->SamplesPerPixel; ++sample)
    {
      covering.clear();
      std::copy_if(layers.begin(), layers.end(), std::back_inserter(covering),
        [=](const Layer& layer) { return (layer.Coverage >> sample & 1u) != 0; });
      CompositeSample(covering, &this->Picture[(pixel * this->SamplesPerPixel + sample) * 4]);
    }
  }
}

std::vector<double> ReferenceCompositor::Resolve() const
{
  std::vector<double> resolved(this->PixelCount * 4);
  for (std::size_t pixel = 0; pixel < this->PixelCount; ++pixel)
  {
    for (std::size_t sample = 0; sample < this->SamplesPerPixel; ++sample)
    {
      for (std::size_t channel = 0; channel < 4; ++channel)
      {
        resolved[pixel * 4 + channel] +=
          this->Picture[(pixel * this->SamplesPerPixel + sample) * 4 + channel];
      }
    }
    for (std::size_t channel = 0; channel < 4; ++channel)
    {
      resolved[pixel * 4 + channel] /= static_cast<double>(this->SamplesPerPixel);
    }
  }
  return resolved;
}

double ReferenceCompositor::LayersMean() const
{
  return this->CoveredPixels == 0
    ? 0.0
    : static_cast<double>(this->Fragments) / static_cast<double>(this->CoveredPixels);
}

}
