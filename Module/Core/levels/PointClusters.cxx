#include "Core/levels/PointClusters.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace vitrine
{

namespace
{

constexpr std::uint32_t NoCell = std::numeric_limits<std::uint32_t>::max();

struct KeyHash
{
  template <class Key>
  std::size_t operator()(const Key& key) const
  {
    std::uint64_t hash = 0;
    for (const auto part : key)
    {
      hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }
};

/** The cells of points, and the points that stand for others. */
class Clusters
{
public:
  Clusters(const DetailedMesh& mesh, double side)
    : Mesh(mesh)
    , Side(side)
    , Cells(mesh.Points.size(), NoCell)
    , Points(mesh.Points.size())
  {
  }

  std::uint32_t CellOf(std::uint32_t point)
  {
    this->Find(point);
    return this->Cells[point];
  }

  std::uint32_t Of(std::uint32_t point)
  {
    this->Find(point);
    return this->Points[point];
  }

private:
  void Find(std::uint32_t point)
  {
    if (this->Cells[point] != NoCell)
    {
      return;
    }
    const glm::dvec3 place =
      glm::floor((this->Mesh.Points[point] - this->Mesh.Points[0]) / this->Side);
    const std::array<std::int64_t, 3> cell{ static_cast<std::int64_t>(place.x),
      static_cast<std::int64_t>(place.y), static_cast<std::int64_t>(place.z) };
    const auto next = static_cast<std::uint32_t>(this->Known.size());
    this->Cells[point] = this->Known.emplace(cell, next).first->second;
    std::uint32_t octant = 0;
    for (int axis = 0; axis < 3 && !this->Mesh.Normals.empty(); ++axis)
    {
      octant = 2 * octant + (this->Mesh.Normals[point][axis] > 0 ? 1 : 0);
    }
    const std::uint32_t color = this->Mesh.Colors.empty() ? 0 : this->Mesh.Colors[point];
    const std::array<std::uint32_t, 3> look{ this->Cells[point], octant, color };
    this->Points[point] = this->First.emplace(look, point).first->second;
  }

  const DetailedMesh& Mesh;
  const double Side;
  std::vector<std::uint32_t> Cells;  ///< for each point, NoCell if it was not asked for
  std::vector<std::uint32_t> Points; ///< for each of these
  std::unordered_map<std::array<std::int64_t, 3>, std::uint32_t, KeyHash> Known;
  std::unordered_map<std::array<std::uint32_t, 3>, std::uint32_t, KeyHash> First;
};

/** The cells of a triangle that has some in common: one or two, the lower one first. */
using CellPair = std::array<std::uint32_t, 2>;

CellPair PairOf(std::uint32_t a, std::uint32_t b)
{
  return { std::min(a, b), std::max(a, b) };
}

}

std::vector<std::uint32_t> Clustered(
  const DetailedMesh& mesh, const std::vector<std::uint32_t>& corners, double side)
{
  Clusters clusters(mesh, side);
  std::vector<std::uint32_t> left;
  std::unordered_set<std::array<std::uint32_t, 3>, KeyHash> known;
  std::unordered_set<CellPair, KeyHash> covered; // cells, and pairs of them, that triangles have
  std::vector<std::pair<CellPair, std::size_t>> flat; // triangles in a cell or a pair
  for (std::size_t i = 0; i < corners.size(); i += 3)
  {
    std::array<std::uint32_t, 3> cells;
    std::array<std::uint32_t, 3> moved;
    for (int k = 0; k < 3; ++k)
    {
      cells[k] = clusters.CellOf(corners[i + k]);
      moved[k] = clusters.Of(corners[i + k]);
    }
    const auto [low, high] = std::minmax({ cells[0], cells[1], cells[2] });
    if (cells[0] == cells[1] || cells[1] == cells[2] || cells[2] == cells[0])
    {
      flat.push_back({ PairOf(low, high), i });
      continue;
    }
    std::array<std::uint32_t, 3> sorted = moved;
    std::sort(sorted.begin(), sorted.end());
    if (known.insert(sorted).second)
    {
      left.insert(left.end(), moved.begin(), moved.end());
    }
    for (int k = 0; k < 3; ++k)
    {
      covered.insert(PairOf(cells[k], cells[k]));
      covered.insert(PairOf(cells[k], cells[(k + 1) % 3]));
    }
  }
  // Pairs first, which cover their cells.
  std::stable_sort(flat.begin(), flat.end(),
    [](const auto& a, const auto& b)
    { return (a.first[0] != a.first[1]) > (b.first[0] != b.first[1]); });
  for (const auto& [pair, i] : flat)
  {
    if (covered.insert(pair).second)
    {
      covered.insert(PairOf(pair[0], pair[0]));
      covered.insert(PairOf(pair[1], pair[1]));
      left.insert(left.end(), &corners[i], &corners[i] + 3);
    }
  }
  return left;
}

}
