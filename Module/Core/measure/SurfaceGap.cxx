#include "Core/measure/SurfaceGap.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

namespace vitrine
{

namespace
{

double SquaredDistance(const WideBox& a, const WideBox& b)
{
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double beside =
      std::max(std::max(a.Low[axis] - b.High[axis], b.Low[axis] - a.High[axis]), 0.0);
    sum += beside * beside;
  }
  return sum;
}

/** A tree of boxes over triangles, each half of its parent. */
class HalvedTriangles
{
public:
  struct Node
  {
    WideBox Extent;
    std::uint32_t First;
    std::uint32_t Count;
    std::uint32_t Right; ///< The left child stands behind the node. 0 for a leaf.
  };

  explicit HalvedTriangles(const std::vector<PlacedTriangle>& triangles)
    : Items(triangles.size())
  {
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      this->Items[i] = &triangles[i];
    }
    this->Nodes.reserve(this->Items.size());
    this->Build(0, static_cast<std::uint32_t>(this->Items.size()));
  }

  const Node& At(std::uint32_t node) const { return this->Nodes[node]; }
  const PlacedTriangle* const* ItemsOf(const Node& node) const
  {
    return this->Items.data() + node.First;
  }

private:
  static constexpr std::uint32_t LeafSize = 4;

  std::uint32_t Build(std::uint32_t first, std::uint32_t count)
  {
    const auto number = static_cast<std::uint32_t>(this->Nodes.size());
    WideBox extent;
    for (std::uint32_t i = first; i < first + count; ++i)
    {
      extent.Add(this->Items[i]->Extent);
    }
    this->Nodes.push_back({ extent, first, count, 0 });
    if (count > LeafSize)
    {
      const glm::dvec3 size = extent.High - extent.Low;
      const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
      const auto begin = this->Items.begin() + first;
      std::nth_element(begin, begin + count / 2, begin + count,
        [axis](const PlacedTriangle* a, const PlacedTriangle* b)
        {
          const double middleOfA = a->Extent.Low[axis] + a->Extent.High[axis];
          const double middleOfB = b->Extent.Low[axis] + b->Extent.High[axis];
          return middleOfA != middleOfB ? middleOfA < middleOfB : a->Item < b->Item;
        });
      this->Build(first, count / 2);
      const std::uint32_t right = this->Build(first + count / 2, count - count / 2);
      this->Nodes[number].Right = right;
    }
    return number;
  }

  std::vector<const PlacedTriangle*> Items;
  std::vector<Node> Nodes;
};

/** Drops triangles that are farther than `within` from the box around the others. */
void DropFar(
  std::vector<PlacedTriangle>& triangles, const std::vector<PlacedTriangle>& others, double within)
{
  WideBox box;
  for (const PlacedTriangle& other : others)
  {
    box.Add(other.Extent);
  }
  const auto isFar = [&](const PlacedTriangle& triangle)
  { return box.IsEmpty() || DistanceBetween(triangle.Extent, box) > within; };
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(), isFar), triangles.end());
}

class GapSearch
{
public:
  GapSearch(
    const HalvedTriangles& first, const HalvedTriangles& second, double within, double rounding)
    : First(first)
    , Second(second)
    , Rounding(rounding)
    , Limit(within)
  {
  }

  void Search(std::uint32_t a, std::uint32_t b)
  {
    const HalvedTriangles::Node& first = this->First.At(a);
    const HalvedTriangles::Node& second = this->Second.At(b);
    if (this->AreFar(first.Extent, second.Extent))
    {
      return;
    }
    if (first.Right == 0 && second.Right == 0)
    {
      this->Compare(first, second);
    }
    else if (second.Right == 0 || (first.Right != 0 && first.Count >= second.Count))
    {
      const bool isLeftNearer = SquaredDistance(this->First.At(a + 1).Extent, second.Extent) <=
        SquaredDistance(this->First.At(first.Right).Extent, second.Extent);
      this->Search(isLeftNearer ? a + 1 : first.Right, b);
      this->Search(isLeftNearer ? first.Right : a + 1, b);
    }
    else
    {
      const bool isLeftNearer = SquaredDistance(first.Extent, this->Second.At(b + 1).Extent) <=
        SquaredDistance(first.Extent, this->Second.At(second.Right).Extent);
      this->Search(a, isLeftNearer ? b + 1 : second.Right);
      this->Search(a, isLeftNearer ? second.Right : b + 1);
    }
  }

  std::optional<SurfaceGap> Result()
  {
    std::sort(this->Found.Meetings.begin(), this->Found.Meetings.end(),
      [](const Meeting& a, const Meeting& b)
      { return std::pair(a.First, a.Second) < std::pair(b.First, b.Second); });
    return this->IsFound ? std::optional<SurfaceGap>(std::move(this->Found)) : std::nullopt;
  }

private:
  void Compare(const HalvedTriangles::Node& first, const HalvedTriangles::Node& second)
  {
    const PlacedTriangle* const* const a = this->First.ItemsOf(first);
    const PlacedTriangle* const* const b = this->Second.ItemsOf(second);
    for (std::uint32_t i = 0; i < first.Count; ++i)
    {
      for (std::uint32_t j = 0; j < second.Count; ++j)
      {
        if (!this->AreFar(a[i]->Extent, b[j]->Extent))
        {
          this->Compare(*a[i], *b[j]);
        }
      }
    }
  }

  void Compare(const PlacedTriangle& a, const PlacedTriangle& b)
  {
    const std::optional<Gap> gap =
      GapWithin(a.Corners, b.Corners, this->WorthFinding(), this->Rounding);
    if (gap && gap->Distance == 0)
    {
      this->Found.Meetings.push_back(
        { a.Item, b.Item, gap->OnFirst, ReachThrough(a.Corners, b.Corners) });
    }
    if (gap)
    {
      this->Keep(*gap);
    }
  }

  bool AreFar(const WideBox& a, const WideBox& b) const
  {
    const double limit = this->WorthFinding() + this->Rounding;
    return SquaredDistance(a, b) > limit * limit;
  }

  /** Of equal distances, as between parallel plates, the first one found will do. */
  double WorthFinding() const { return this->IsFound ? this->Limit * (1 - 1e-12) : this->Limit; }

  void Keep(const Gap& gap)
  {
    if (!this->IsFound || gap.Distance < this->Found.Least.Distance)
    {
      this->IsFound = true;
      this->Found.Least = gap;
      this->Limit = gap.Distance;
    }
  }

  const HalvedTriangles& First;
  const HalvedTriangles& Second;
  double Rounding;
  double Limit;
  bool IsFound = false;
  SurfaceGap Found{};
};

}

std::optional<SurfaceGap> FindSurfaceGap(std::vector<PlacedTriangle> first,
  std::vector<PlacedTriangle> second, double within, double rounding)
{
  DropFar(first, second, within + rounding);
  DropFar(second, first, within + rounding);
  if (first.empty() || second.empty())
  {
    return std::nullopt;
  }
  const HalvedTriangles a(first);
  const HalvedTriangles b(second);
  GapSearch search(a, b, within, rounding);
  search.Search(0, 0);
  return search.Result();
}

std::optional<SurfaceGap> FindSurfaceGap(
  const PlacedPart& first, const PlacedPart& second, double within)
{
  if (first.Bounds().IsEmpty() || second.Bounds().IsEmpty() ||
    DistanceBetween(first.Bounds(), second.Bounds()) > within)
  {
    return std::nullopt;
  }
  const double rounding = RoundingOf(first, second);
  return FindSurfaceGap(first.TrianglesTouching(second.Bounds().GrownBy(within + rounding)),
    second.TrianglesTouching(first.Bounds().GrownBy(within + rounding)), within, rounding);
}

double RoundingOf(const PlacedPart& first, const PlacedPart& second)
{
  return 1e-14 * std::max(first.Bounds().Reach(), second.Bounds().Reach());
}

}
