#include "Core/culling/steady/ViewCuts.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine
{

ScreenRounding RoundingWhereCut(const ScreenMatrix& view)
{
  const glm::vec2 ofPlaces = view.OfPlaces();
  return { { RoundingOfCuts * view.Size.x, 0.0f, 0.0f, ofPlaces.x },
    { RoundingOfCuts * (view.Top() - view.Bottom()), 0.0f, 0.0f, ofPlaces.y },
    { RoundingOfCuts, 0.0f, 0.0f } };
}

void ViewCuts::Begin(const ScreenMatrix& toScreen)
{
  const ScreenMargin rounded = toScreen.RoundingOnScreen().OnScreenAtOne();
  const double width = toScreen.Size.x;
  const double bottom = toScreen.Bottom(), top = toScreen.Top();
  this->Size = { width, top - bottom };
  // The near plane comes first, so that what is left has a positive w.
  this->Planes[0] = { { 0.0, 0.0, -1.0, 1.0 }, rounded.Depth };
  this->Planes[1] = { { 0.0, 0.0, 1.0, 0.0 }, 0.0 };
  this->Planes[2] = { { 1.0, 0.0, 0.0, 0.0 }, rounded.Column };
  this->Planes[3] = { { -1.0, 0.0, 0.0, width }, rounded.Column };
  this->Planes[4] = { { 0.0, 1.0, 0.0, -bottom }, rounded.Line };
  this->Planes[5] = { { 0.0, -1.0, 0.0, top }, rounded.Line };
  for (unsigned i = 0; i < 6; ++i)
  {
    this->Planes[i].Bit = 1u << i;
  }
}

const std::vector<CutCorner>& ViewCuts::Cut(
  const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c)
{
  this->Corners.assign({ { a }, { b }, { c } });
  this->Slid.clear();
  // The rounding is that of this face alone. In views that hold all that is drawn, the far plane is so far away that a
  // rounding for all points would put every face in doubt.
  this->Planes[1].Rounding =
    RoundingOfCuts * std::max({ std::abs(a.w), std::abs(b.w), std::abs(c.w) });
  for (const Plane& plane : this->Planes)
  {
    const bool areAllInside = glm::dot(plane.Normal, a) > plane.Rounding &&
      glm::dot(plane.Normal, b) > plane.Rounding && glm::dot(plane.Normal, c) > plane.Rounding;
    if (!areAllInside)
    {
      this->CutAt(plane);
    }
  }
  return this->Corners;
}

/**
 * Cuts the face at a plane: keeps corners that are inside, doubles those that may be, and adds crossings of edges from
 * surely inside to surely beyond.
 */
void ViewCuts::CutAt(const Plane& plane)
{
  if (this->FindSides(plane))
  {
    return;
  }
  this->Corners.swap(this->Uncut);
  this->Corners.clear();
  const std::size_t count = this->Around.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Sided &corner = this->Around[i], &next = this->Around[(i + 1) % count];
    if (corner.Side == 0)
    {
      const Sided& last = this->Around[(i + count - 1) % count];
      this->Corners.push_back(this->MaybeCutOf(corner, last, next));
      if (!corner.Corner->IsOneOfTwo)
      {
        this->Corners.push_back(this->Corners.back());
        this->Corners.back().IsOneOfTwo = true;
      }
    }
    else if (corner.Side > 0)
    {
      this->Corners.push_back(*corner.Corner);
    }
    if (corner.Side * next.Side < 0)
    {
      this->Corners.push_back(this->CrossingOf(corner, next, plane));
    }
  }
}

/** Finds the side of each corner. Returns true if all of them are surely inside. */
bool ViewCuts::FindSides(const Plane& plane)
{
  this->Around.clear();
  bool areAllInside = true;
  for (const CutCorner& corner : this->Corners)
  {
    const double distance = glm::dot(plane.Normal, corner.Place);
    const double doubt = this->DoubtOf(corner, plane);
    const int side = distance > doubt ? 1 : distance < -doubt ? -1 : 0;
    this->Around.push_back({ &corner, distance, doubt, side });
    areAllInside = areAllInside && side > 0;
  }
  return areAllInside;
}

/** Returns the error bound of the distance of a corner. */
double ViewCuts::DoubtOf(const CutCorner& corner, const Plane& plane) const
{
  double doubt = plane.Rounding;
  for (std::size_t i = corner.Slides.First; i < corner.Slides.End; ++i)
  {
    doubt += std::abs(glm::dot(plane.Normal, this->Slid[i]));
  }
  return doubt;
}

/** Returns a corner that may be cut off: it may lie on either of its edges, close by. */
CutCorner ViewCuts::MaybeCutOf(const Sided& corner, const Sided& last, const Sided& next)
{
  CutCorner cut = *corner.Corner;
  cut.Slides.First = this->Slid.size();
  this->AddSlides(*corner.Corner, 1.0);
  for (const Sided* other : { &last, &next })
  {
    const double most = 3.0 * std::max(corner.Doubt, other->Doubt);
    const double differ = std::abs(other->Distance - corner.Distance);
    this->Slid.push_back(
      (differ > most ? most / differ : 1.0) * (other->Corner->Place - corner.Corner->Place));
  }
  cut.Slides.End = this->Slid.size();
  return cut;
}

/**
 * Returns the crossing of an edge and a plane. It slides along the edge as far as either end is off, and beside it as
 * the ends do. If two sides of the view meet there, it does not slide.
 */
CutCorner ViewCuts::CrossingOf(const Sided& from, const Sided& to, const Plane& plane)
{
  const glm::dvec4 along = to.Corner->Place - from.Corner->Place;
  const double share = from.Distance / (from.Distance - to.Distance);
  const double most = 4.0 * std::max(from.Doubt, to.Doubt);
  const double differ = std::abs(to.Distance - from.Distance);
  CutCorner cut;
  cut.Place = from.Corner->Place + share * along;
  cut.Reach = std::max(this->ReachOf(*from.Corner), this->ReachOf(*to.Corner)) / cut.Place.w;
  cut.Planes = plane.Bit | (from.Corner->Planes & to.Corner->Planes);
  const bool isWhereSidesMeet = cut.Planes != plane.Bit && (cut.Planes & ~Sides) == 0;
  if (isWhereSidesMeet)
  {
    return cut;
  }
  cut.Slides.First = this->Slid.size();
  this->Slid.push_back((differ > most ? most / differ : 1.0) * along);
  this->AddSlides(*from.Corner, 1.0 - share);
  this->AddSlides(*to.Corner, share);
  cut.Slides.End = this->Slid.size();
  return cut;
}

/** Adds the slides of another corner to the current one, times a weight. */
void ViewCuts::AddSlides(const CutCorner& of, double weight)
{
  for (std::size_t i = of.Slides.First; i < of.Slides.End; ++i)
  {
    this->Slid.push_back(weight * this->Slid[i]);
  }
}

/** Returns the reach of a corner, times w. The terms of the sums that lead to a point on its edges are no larger. */
double ViewCuts::ReachOf(const CutCorner& corner) const
{
  const glm::dvec2 times = glm::abs(glm::dvec2(corner.Place)) / this->Size;
  return std::max({ corner.Reach * std::abs(corner.Place.w), times.x, times.y });
}

}
