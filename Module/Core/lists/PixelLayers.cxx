#include "Core/lists/PixelLayers.h"

#include "Core/lists/StoredColor.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <tuple>
#include <utility>

namespace vitrine
{
namespace
{

constexpr int MostSamples = 32;

bool IsOpaque(const LayerFragment& f)
{
  return (f.Kind & LayerFragment::Opaque) != 0;
}

/** Returns a number of the order of the 16-bit floats in which floating-point targets store colours. */
std::uint32_t FloatOrder(float x)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &x, sizeof(bits));
  return x > 0.0f ? (bits + 0x800u) >> 12 : 0u;
}

float DepthOf(const LayerFragment& f)
{
  return f.Depth > 0.0f ? f.Depth : 0.0f;
}

/** Orders fragments of one pixel from front to back. */
class IsInFront
{
public:
  explicit IsInFront(const std::vector<LayerFragment>& fragments)
    : Fragments(fragments)
  {
  }

  bool operator()(const PixelLayer& left, const PixelLayer& right) const
  {
    const LayerFragment& a = this->Fragments[left.Fragment];
    const LayerFragment& b = this->Fragments[right.Fragment];
    const bool areOpaque = IsOpaque(a) && IsOpaque(b);
    if (((a.Kind | b.Kind) & LayerFragment::Tested) != 0 && IsOpaque(a) != IsOpaque(b))
    {
      return IsOpaque(b);
    }
    const auto keyOf = [](const LayerFragment& f)
    { return std::make_tuple(DepthOf(f), IsOpaque(f)); };
    if (keyOf(a) != keyOf(b))
    {
      return keyOf(a) < keyOf(b);
    }
    const auto drawnOf = [](const LayerFragment& f)
    {
      return std::make_tuple(
        f.Kind >> LayerFragment::FirstDrawBit, f.Part & ~LayerFragment::BackFace, f.Primitive);
    };
    if (areOpaque && drawnOf(a) != drawnOf(b))
    {
      return drawnOf(a) > drawnOf(b);
    }
    const auto colorOf = [](const LayerFragment& f)
    {
      const std::uint64_t stored = StoredColor(f.Rgba[0], f.Rgba[1], f.Rgba[2], f.Rgba[3]);
      return std::make_tuple(ColorOrder(stored), FloatOrder(f.Rgba[2]), FloatOrder(f.Rgba[1]),
        FloatOrder(f.Rgba[0]), f.Part, f.Coverage);
    };
    return colorOf(a) < colorOf(b);
  }

private:
  const std::vector<LayerFragment>& Fragments;
};

/** The light that still comes through in each sample of a pixel. */
class Transmittance
{
public:
  explicit Transmittance(int samples)
    : Samples(std::min(std::max(samples, 1), MostSamples))
  {
    this->Left.fill(1.0);
  }

  /** Returns true if an opaque fragment hides all samples of `coverage`. */
  bool IsHidden(std::uint32_t coverage) const { return (coverage & ~this->Closed) == 0; }

  /** Lets a fragment take its share. */
  double Take(const LayerFragment& f)
  {
    const double alpha = IsOpaque(f) ? 1.0
      : f.Rgba[3] > 0.0f             ? std::min(1.0, static_cast<double>(f.Rgba[3]))
                                     : 0.0;
    if ((f.Kind & LayerFragment::Added) != 0)
    {
      return 0.0;
    }
    double share = 0.0;
    for (int s = 0; s < this->Samples; ++s)
    {
      if ((f.Coverage >> s & 1u) != 0)
      {
        share += this->Left[s] * alpha;
        this->Left[s] *= 1.0 - alpha;
      }
    }
    this->Closed |= IsOpaque(f) ? f.Coverage : 0u;
    return share / this->Samples;
  }

private:
  int Samples;
  std::array<double, MostSamples> Left{};
  std::uint32_t Closed = 0; ///< samples with an opaque fragment
};

/** An opaque fragment of a rank. Those that are less are drawn before. */
struct DrawnFragment
{
  std::tuple<std::uint64_t, std::uint64_t> Color; ///< ColorOrder() of the front one at its depth
  std::size_t Rank;
  std::size_t Fragment;

  bool operator<(const DrawnFragment& other) const
  {
    return std::tie(this->Color, this->Rank, other.Fragment) <
      std::tie(other.Color, other.Rank, this->Fragment);
  }
};

/** Puts the fragments of each pixel next to each other, in order of arrival. */
PixelLayers Gather(const std::vector<LayerFragment>& fragments, std::size_t pixels)
{
  PixelLayers gathered;
  gathered.Offsets.assign(pixels + 1, 0);
  for (const LayerFragment& f : fragments)
  {
    gathered.Offsets[f.Pixel < pixels ? f.Pixel + 1 : 0] += f.Pixel < pixels ? 1 : 0;
  }
  for (std::size_t p = 0; p < pixels; ++p)
  {
    gathered.Offsets[p + 1] += gathered.Offsets[p];
  }
  gathered.Layers.resize(gathered.Offsets[pixels]);
  std::vector<std::size_t> next(gathered.Offsets.begin(), gathered.Offsets.end() - 1);
  for (std::size_t i = 0; i < fragments.size(); ++i)
  {
    if (fragments[i].Pixel < pixels)
    {
      gathered.Layers[next[fragments[i].Pixel]++] = { static_cast<std::uint32_t>(i), 0.0 };
    }
  }
  return gathered;
}
}

PixelLayers SortLayers(
  const std::vector<LayerFragment>& fragments, std::size_t pixels, int samples, bool keepHidden)
{
  PixelLayers sorted = Gather(fragments, pixels);
  std::size_t kept = 0;
  for (std::size_t p = 0; p < pixels; ++p)
  {
    const auto begin = sorted.Layers.begin() + static_cast<std::ptrdiff_t>(sorted.Offsets[p]);
    const auto end = sorted.Layers.begin() + static_cast<std::ptrdiff_t>(sorted.Offsets[p + 1]);
    std::sort(begin, end, IsInFront(fragments));
    sorted.Offsets[p] = kept;
    Transmittance light(samples);
    for (auto layer = begin; layer != end; ++layer)
    {
      const LayerFragment& f = fragments[layer->Fragment];
      const bool isHidden = light.IsHidden(f.Coverage);
      if (!isHidden || keepHidden)
      {
        sorted.Layers[kept++] = { layer->Fragment, light.Take(f) };
      }
    }
  }
  sorted.Offsets[pixels] = kept;
  sorted.Layers.resize(kept);
  return sorted;
}

std::vector<LayerFragment> JoinLayers(
  const std::vector<std::vector<LayerFragment>>& ofRanks, std::vector<RankPart>& parts)
{
  std::vector<LayerFragment> joined;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
  std::vector<DrawnFragment> opaque;
  for (std::size_t rank = 0; rank < ofRanks.size(); ++rank)
  {
    const LayerFragment* front = nullptr; // of the opaque ones at a depth
    for (const LayerFragment& f : ofRanks[rank])
    {
      numbers[{ static_cast<std::uint32_t>(rank), f.Part & ~LayerFragment::BackFace }] = 0;
      if (IsOpaque(f))
      {
        const bool isBehind = front && front->Pixel == f.Pixel && DepthOf(*front) == DepthOf(f);
        front = isBehind ? front : &f;
        const std::uint64_t color = StoredColor(front->Rgba[0], front->Rgba[1], front->Rgba[2], 1);
        opaque.push_back({ ColorOrder(color), rank, joined.size() });
      }
      joined.push_back(f);
    }
  }
  std::sort(opaque.begin(), opaque.end());
  for (std::size_t place = 0; place < opaque.size(); ++place)
  {
    constexpr std::uint32_t DrawPlace = 1u << LayerFragment::FirstDrawBit;
    std::uint32_t& kind = joined[opaque[place].Fragment].Kind;
    kind = kind % DrawPlace + static_cast<std::uint32_t>(place) * DrawPlace;
  }
  parts.clear();
  for (auto& [part, number] : numbers)
  {
    number = static_cast<std::uint32_t>(parts.size());
    parts.push_back({ part.first, part.second });
  }
  std::size_t next = 0;
  for (std::size_t rank = 0; rank < ofRanks.size(); ++rank)
  {
    for (const LayerFragment& f : ofRanks[rank])
    {
      joined[next++].Part = (f.Part & LayerFragment::BackFace) |
        numbers[{ static_cast<std::uint32_t>(rank), f.Part & ~LayerFragment::BackFace }];
    }
  }
  return joined;
}

std::size_t FirstPartWithShare(const std::vector<LayerFragment>& fragments,
  const PixelLayers& layers, std::size_t first, std::size_t end, double share)
{
  const auto partOf = [&](std::size_t layer)
  { return fragments[layers.Layers[layer].Fragment].Part & ~LayerFragment::BackFace; };
  for (std::size_t candidate = first; candidate < end; ++candidate)
  {
    double sum = 0.0;
    for (std::size_t layer = first; layer < end; ++layer)
    {
      sum += partOf(layer) == partOf(candidate) ? layers.Layers[layer].Share : 0.0;
    }
    if (sum >= share)
    {
      return candidate;
    }
  }
  return end;
}

}
