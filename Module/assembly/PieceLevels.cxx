#include "assembly/PieceLevels.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>

namespace vitrine
{

namespace
{

/** Sections move planes by a few roundings of the coordinates around. */
constexpr double SlackOfPlanes = 16;

/** Choices are a little finer than needed, so that they last for some frames. */
constexpr double ShareOfChoice = 0.9;

/** A cell of a grid, its size, and the sides of planes on which it lies. */
using Cell = std::array<std::int64_t, 5>;

struct CellHash
{
  std::size_t operator()(const Cell& cell) const
  {
    std::uint64_t hash = 0;
    for (const std::int64_t place : cell)
    {
      hash = (hash ^ static_cast<std::uint64_t>(place)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }
};

/** Returns the cell of a tiny part. Its diagonal is less than 0.44 times the length. */
Cell CellOf(const Piece& piece, double length, const std::vector<CutPlane>& planes)
{
  const int power = static_cast<int>(std::floor(std::log2(length / 4)));
  const double side = std::ldexp(1.0, power);
  Cell cell{ 0, 0, 0, power, 0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    cell[axis] = static_cast<std::int64_t>(std::floor(piece.Centre[axis] / side));
  }
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    cell[4] |= std::int64_t{ planes[i].At(piece.Centre) >= 0 } << i;
  }
  return cell;
}

double BoundOf(const Piece& piece)
{
  const auto place = static_cast<std::size_t>(piece.Level);
  return piece.Rounding + (piece.Level < 0 ? 0.0 : piece.Scale * piece.Detail->Levels[place].Bound);
}
}

const std::vector<std::uint32_t>& Piece::Corners(int level) const
{
  return level < 0 ? this->Detail->Whole
                   : this->Detail->Levels[static_cast<std::size_t>(level)].Corners;
}

bool Piece::IsMetByPlane(const LevelRequest& asked) const
{
  const auto& planes = asked.Exact.Planes;
  return std::any_of(planes.begin(), planes.end(),
    [&](const CutPlane& plane)
    {
      const double slack =
        this->Rounding + SlackOfPlanes * MarginOf(plane, glm::dvec3(asked.Reach));
      return !(std::abs(plane.At(this->Centre)) > this->Radius + slack);
    });
}

int Piece::CoarsestFor(const LevelRequest& asked, double length) const
{
  return this->IsMetByPlane(asked)
    ? -1
    : CoarsestWithin(this->Detail->Levels, (length - this->Rounding) / this->Scale);
}

bool Piece::IsRightFor(const LevelRequest& asked, double length) const
{
  const bool isOwn = asked.Exact.Props.count(this->Own) > 0;
  const bool isExact = isOwn || (this->By == LEVEL && this->Level < 0);
  return isOwn == (this->By == OWN_PROP) &&
    (isExact || (this->Bound <= length && !this->IsMetByPlane(asked)));
}

double LengthFor(const Piece& piece, const LevelRequest& asked, double share)
{
  return LengthOfPixels(asked.View, share * asked.Pixels, piece.Centre, piece.Radius);
}

// Of tiny parts in one cell of a grid, the first stands for all. With the length L that points may move by, their radii
// are at most L / 4 and the cell's diagonal is less than 0.44 L, so that no point is farther than 0.94 L from what
// stands for it.
void ChooseLevels(std::vector<Piece>& pieces, const LevelRequest& asked)
{
  std::unordered_set<Cell, CellHash> taken;
  for (Piece& piece : pieces)
  {
    if (asked.Exact.Props.count(piece.Own) > 0)
    {
      piece.By = Piece::OWN_PROP;
      piece.Bound = 0;
      continue;
    }
    const double length = LengthFor(piece, asked, ShareOfChoice);
    piece.By = Piece::LEVEL;
    piece.Level = piece.CoarsestFor(asked, length);
    piece.Bound = BoundOf(piece);
    if (piece.Radius + piece.Rounding <= length / 4 && !piece.IsMetByPlane(asked) &&
      !taken.insert(CellOf(piece, length, asked.Exact.Planes)).second)
    {
      piece.By = Piece::NEIGHBOUR;
      piece.Bound = 0.94 * length;
    }
  }
}

}
