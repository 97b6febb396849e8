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
  static constexpr std::uint32_t LeafSize = 8;

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

  void Search()
  {
    this->Search(0, 0, SquaredDistance(this->First.At(0).Extent, this->Second.At(0).Extent));
  }

  std::optional<SurfaceGap> Result()
  {
    std::sort(this->Found.Meetings.begin(), this->Found.Meetings.end(),
      [](const Meeting& a, const Meeting& b)
      { return std::pair(a.First, a.Second) < std::pair(b.First, b.Second); });
    return this->IsFound ? std::optional<SurfaceGap>(std::move(this->Found)) : std::nullopt;
  }

private:
  void Search(std::uint32_t a, std::uint32_t b, double squaredDistance)
  {
    const HalvedTriangles::Node& first = this->First.At(a);
    const HalvedTriangles::Node& second = this->Second.At(b);
    const double limit = this->WorthFinding() + this->Rounding;
    if (squaredDistance > limit * limit || this->AreFarAlong(first.Extent, second.Extent))
    {
      return;
    }
    if (first.Right == 0 && second.Right == 0)
    {
      this->Compare(first, second);
    }
    else if (second.Right == 0 || (first.Right != 0 && first.Count >= second.Count))
    {
      this->SearchNearerFirst({ a + 1, first.Right }, { b, b });
    }
    else
    {
      this->SearchNearerFirst({ a, a }, { b + 1, second.Right });
    }
  }

  void SearchNearerFirst(const std::uint32_t (&a)[2], const std::uint32_t (&b)[2])
  {
    double squared[2];
    for (int i = 0; i < 2; ++i)
    {
      squared[i] = SquaredDistance(this->First.At(a[i]).Extent, this->Second.At(b[i]).Extent);
    }
    const int nearer = squared[0] <= squared[1] ? 0 : 1;
    this->Search(a[nearer], b[nearer], squared[nearer]);
    this->Search(a[1 - nearer], b[1 - nearer], squared[1 - nearer]);
  }

  void Compare(const HalvedTriangles::Node& first, const HalvedTriangles::Node& second)
  {
    const PlacedTriangle* const* const a = this->First.ItemsOf(first);
    const PlacedTriangle* const* const b = this->Second.ItemsOf(second);
    for (std::uint32_t i = 0; i < first.Count; ++i)
    {
      for (std::uint32_t j = 0; j < second.Count; ++j)
      {
        if (!this->AreFar(a[i]->Extent, b[j]->Extent) &&
          !this->AreFarAlong(a[i]->Corners, b[j]->Corners))
        {
          this->Compare(*a[i], *b[j]);
        }
      }
    }
  }

  void Compare(const PlacedTriangle& a, const PlacedTriangle& b)
  {
    const std::optional<Gap> gap = GapWithin(a.Corners, b.Corners, this->WorthFinding(),
      this->Rounding, this->IsFound ? nullptr : &this->Along);
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

  /**
   * Returns true if boxes or triangles are farther apart than the limit along one direction: that of the least gap so
   * far, or else the last one that set triangles apart. Surfaces often face each other, so it is often right again.
   */
  bool AreFarAlong(const WideBox& a, const WideBox& b) const
  {
    const glm::dvec3& along = this->Along;
    double between = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      between +=
        along[axis] * (along[axis] > 0 ? b.Low[axis] - a.High[axis] : b.High[axis] - a.Low[axis]);
    }
    return between > this->WorthFinding() + this->Rounding;
  }

  bool AreFarAlong(const Triangle& a, const Triangle& b) const
  {
    const glm::dvec3& along = this->Along;
    const double reach =
      std::max(0.0, std::max(glm::dot(a[1] - a[0], along), glm::dot(a[2] - a[0], along)));
    const double begin = std::min(glm::dot(b[0] - a[0], along),
      std::min(glm::dot(b[1] - a[0], along), glm::dot(b[2] - a[0], along)));
    return begin - reach > this->WorthFinding() + this->Rounding;
  }

  /**
   * Of distances that differ by rounding, as between parallel plates, the first one found will do. Meetings are all
   * found.
   */
  double WorthFinding() const
  {
    return this->IsFound ? std::max(this->Limit * (1 - 1e-12) - 2 * this->Rounding, this->Rounding)
                         : this->Limit;
  }

  void Keep(const Gap& gap)
  {
    if (!this->IsFound || gap.Distance < this->Found.Least.Distance)
    {
      this->IsFound = true;
      this->Found.Least = gap;
      this->Limit = gap.Distance;
      this->Along =
        gap.Distance > 0 ? (gap.OnSecond - gap.OnFirst) / gap.Distance : glm::dvec3(0.0);
    }
  }

  const HalvedTriangles& First;
  const HalvedTriangles& Second;
  double Rounding;
  double Limit;
  bool IsFound = false;
  SurfaceGap Found{};
  glm::dvec3 Along{ 0.0 }; ///< of the least gap, else one that set triangles apart; 0 at first
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
  search.Search();
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
