#include "assembly/PieceLevels.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

/** Sections move planes by a few roundings of the coordinates around. */
constexpr double SlackOfPlanes = 16;

/** The area of a level is at least this share of the part's, and at most its inverse. */
constexpr double LeastShare = 0.8;

/** So many triangles of a part in each pixel are enough, whatever their area. */
constexpr double TrianglesOfPixel = 16;

bool HasArea(const PartDetail& detail, int level)
{
  const double share = level < 0 ? 1.0 : detail.Shares[static_cast<std::size_t>(level)];
  return share >= LeastShare && share * LeastShare <= 1;
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

std::size_t Piece::Triangles() const
{
  return this->By == LEVEL ? this->Corners(this->Level).size() / 3
    : this->By == SPECK    ? TrianglesOf(*this->Detail->Speck).size() / 3
                           : 0;
}

void Piece::Choose(const LevelRequest& asked, double length)
{
  this->By = LEVEL;
  this->Level = -1;
  this->Bound = this->Rounding;
  if (asked.Exact.Props.count(this->Own) > 0)
  {
    this->By = OWN_PROP;
    this->Bound = 0;
    return;
  }
  if (this->IsMetByPlane(asked))
  {
    return;
  }
  this->Level = CoarsestWithin(this->Detail->Levels, (length - this->Rounding) / this->Scale);
  const double radius = this->Radius / LengthOfPixels(asked.View, 1.0, this->Centre, this->Radius);
  const double most = TrianglesOfPixel * glm::pi<double>() * radius * radius;
  while (!HasArea(*this->Detail, this->Level) &&
    static_cast<double>(this->Corners(this->Level - 1).size()) <= 3 * most)
  {
    --this->Level;
  }
  if (this->BoundOfSpeck <= length &&
    (!HasArea(*this->Detail, this->Level) ||
      this->Triangles() > TrianglesOf(*this->Detail->Speck).size() / 3))
  {
    this->By = SPECK;
    this->Bound = this->BoundOfSpeck;
  }
  else if (this->Level >= 0)
  {
    this->Bound += this->Scale * this->Detail->Levels[static_cast<std::size_t>(this->Level)].Bound;
  }
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

}
