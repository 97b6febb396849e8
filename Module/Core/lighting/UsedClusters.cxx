#include "Core/lighting/UsedClusters.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine
{

namespace
{

constexpr float EndlessDepth = std::numeric_limits<float>::infinity();

/** Error bound of a depth buffer of 24 bits or of floats. */
constexpr double WindowDepthSlack = 0x1p-22;

/** Error bound of the place where a box is drawn, in pixels. */
constexpr double BoxPixelSlack = 1.0;

/** Boxes are drawn from slightly in front of the near plane, given as a share of its distance. */
constexpr double NearSlack = 0.999;

/** Corners are clamped to this coordinate (VC), since products of larger or infinite ones may be NaN. */
constexpr double FarthestCorner = 1e18;

/** The range of window depths of a slice. */
struct SliceDepths
{
  float Nearest;
  float Farthest;

  bool Holds(float depth) const { return this->Nearest <= depth && depth <= this->Farthest; }
};

/** Collects the slices that the depths of one tile fall into. */
class TileSlices
{
public:
  explicit TileSlices(const ClusterGrid& grid)
    : IsHit(grid.Slices(), 0)
  {
    for (int slice = 0; slice < grid.Slices(); ++slice)
    {
      const glm::vec2 depths = grid.DepthsOf(slice);
      const bool isFirst = slice == 0, isLast = slice == grid.Slices() - 1;
      this->Slices.push_back({ isFirst || !grid.HasLevelDepths()
          ? -EndlessDepth
          : static_cast<float>(grid.WindowDepthAt(depths.x) - WindowDepthSlack),
        isLast || !grid.HasLevelDepths()
          ? EndlessDepth
          : static_cast<float>(grid.WindowDepthAt(depths.y) + WindowDepthSlack) });
    }
    this->FindLoneDepths();
  }

  void Add(const float* depths, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      // Neighbouring pixels are mostly in one slice.
      if (depths[i] < 1.0f && !this->Lone[this->Last].Holds(depths[i]))
      {
        this->Add(depths[i]);
      }
    }
  }

  /** Calls mark(slice) for each slice that was hit and clears the hits. */
  template <class Mark>
  void TakeHits(const Mark& mark)
  {
    for (std::size_t slice = 0; slice < this->IsHit.size(); ++slice)
    {
      if (this->IsHit[slice] != 0)
      {
        mark(static_cast<int>(slice));
        this->IsHit[slice] = 0;
      }
    }
    this->Last = this->Slices.size();
  }

private:
  /** Finds the depths that are in one slice only. The last entry belongs to no slice and is empty. */
  void FindLoneDepths()
  {
    for (std::size_t slice = 0; slice < this->Slices.size(); ++slice)
    {
      SliceDepths lone = this->Slices[slice];
      if (slice > 0)
      {
        lone.Nearest = std::nextafter(this->Slices[slice - 1].Farthest, EndlessDepth);
      }
      if (slice + 1 < this->Slices.size())
      {
        lone.Farthest = std::nextafter(this->Slices[slice + 1].Nearest, -EndlessDepth);
      }
      this->Lone.push_back(lone);
    }
    this->Lone.push_back({ EndlessDepth, -EndlessDepth });
    this->Last = this->Slices.size();
  }

  void Add(float depth)
  {
    for (std::size_t slice = 0; slice < this->Slices.size(); ++slice)
    {
      if (this->Slices[slice].Holds(depth))
      {
        this->IsHit[slice] = 1;
        this->Last = this->Lone[slice].Holds(depth) ? slice : this->Last;
      }
    }
  }

  std::vector<SliceDepths> Slices;
  std::vector<SliceDepths> Lone;
  std::vector<std::uint8_t> IsHit;
  std::size_t Last = 0; ///< the slice that was hit last, or the empty entry
};
}

void UsedClusters::AddDepths(const float* depths, int width, int height)
{
  TileSlices slices(this->Grid);
  const int size = this->Grid.TileSize();
  for (int row = 0; row < this->Grid.Rows(); ++row)
  {
    for (int column = 0; column < this->Grid.Columns(); ++column)
    {
      const int left = column * size, right = std::min(width, left + size);
      for (int line = row * size; line < std::min(height, (row + 1) * size) && left < right; ++line)
      {
        slices.Add(depths + static_cast<std::size_t>(line) * width + left, right - left);
      }
      slices.TakeHits(
        [&](int slice) { this->Marks[this->Grid.ClusterAt(column, row, slice)] = 1; });
    }
  }
}

void UsedClusters::AddAll()
{
  std::fill(this->Marks.begin(), this->Marks.end(), std::uint8_t{ 1 });
}

void UsedClusters::AddBox(const Box& box)
{
  if (box.IsEmpty())
  {
    return;
  }
  const double nearest = this->Grid.IsParallel() ? -FarthestCorner : NearSlack * this->Grid.Near();
  for (int slice = 0; slice < this->Grid.Slices(); ++slice)
  {
    const glm::dvec2 depths(this->Grid.DepthsOf(slice));
    glm::dvec3 low(glm::clamp(glm::dvec3(box.Min), -FarthestCorner, FarthestCorner));
    glm::dvec3 high(glm::clamp(glm::dvec3(box.Max), -FarthestCorner, FarthestCorner));
    low.z = std::max(low.z, -depths.y);
    high.z = std::min(high.z, -std::max(depths.x, nearest));
    if (low.z <= high.z)
    {
      this->AddPart(slice, low, high);
    }
  }
}

/** Marks the clusters of one slice that a part of a box is drawn to. The part lies in front of the eye. */
void UsedClusters::AddPart(int slice, const glm::dvec3& low, const glm::dvec3& high)
{
  glm::dvec2 first(FarthestCorner), last(-FarthestCorner);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 point(
      corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z);
    const glm::dvec2 tile = this->Grid.TileOf(point);
    first = glm::min(first, tile);
    last = glm::max(last, tile);
  }
  const glm::dvec2 slack(BoxPixelSlack / this->Grid.TileSize());
  const glm::dvec2 tiles(this->Grid.Columns(), this->Grid.Rows());
  const glm::dvec2 begin = first - slack, end = last + slack;
  // Wide lines may extend slightly outside, where the outermost tiles continue.
  if (end.x < -0.5 || end.y < -0.5 || begin.x > tiles.x + 0.5 || begin.y > tiles.y + 0.5)
  {
    return;
  }
  const glm::ivec2 least(glm::clamp(begin, glm::dvec2(0.0), tiles - 1.0));
  const glm::ivec2 most(glm::clamp(end, glm::dvec2(0.0), tiles - 1.0));
  for (int row = least.y; row <= most.y; ++row)
  {
    std::uint8_t* const marks = this->Marks.data() + this->Grid.ClusterAt(0, row, slice);
    std::fill(marks + least.x, marks + most.x + 1, std::uint8_t{ 1 });
  }
}

std::uint32_t UsedClusters::Count() const
{
  return static_cast<std::uint32_t>(
    std::count_if(this->Marks.begin(), this->Marks.end(), [](std::uint8_t mark) { return mark; }));
}

}
