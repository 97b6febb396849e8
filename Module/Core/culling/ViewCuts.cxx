#include "Core/culling/ViewCuts.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine
{

namespace
{

const double FarAway = 1e9; // columns and lines: more than matter anywhere
}

void CutCorner::AddSlide(const glm::dvec4& slide)
{
  this->HasMore = this->HasMore || this->SlideCount == MostSlides;
  if (!this->HasMore)
  {
    this->Slides[this->SlideCount++] = slide;
  }
}

glm::dvec2 CutCorner::SlideOnScreen(int i) const
{
  const glm::dvec4& slide = this->Slides[i];
  const double nearestW = this->Place.w - std::abs(slide.w);
  const glm::dvec2 change = glm::dvec2(slide) - glm::dvec2(this->Place) / this->Place.w * slide.w;
  return nearestW > 0.0 ? change / nearestW : glm::dvec2(FarAway);
}

void ViewCuts::Begin(const ScreenMatrix& toScreen)
{
  const glm::dvec4 own(toScreen.Rounding);
  const double width = toScreen.Size.x;
  const double bottom = toScreen.Bottom(), top = toScreen.Top();
  const double ofColumn = own.x + width * own.w;
  const double ofLine = own.y + std::max(top, -bottom) * own.w;
  this->Size = { width, top - bottom };
  const double ofDepth = own.z + own.w;
  // The near one first, so that what is left has a positive w.
  this->Planes[0] = { { 0.0, 0.0, -1.0, 1.0 }, ofDepth };
  this->Planes[1] = {
    { 0.0, 0.0, 1.0, 0.0 }, 0.0
  }; // views that hold all that is drawn reach so far that rounding would have all of it in doubt
  this->Planes[2] = { { 1.0, 0.0, 0.0, 0.0 }, ofColumn };
  this->Planes[3] = { { -1.0, 0.0, 0.0, width }, ofColumn };
  this->Planes[4] = { { 0.0, 1.0, 0.0, -bottom }, ofLine };
  this->Planes[5] = { { 0.0, -1.0, 0.0, top }, ofLine };
  for (unsigned i = 0; i < 6; ++i)
  {
    this->Planes[i].Bit = 1u << i;
  }
}

const std::vector<CutCorner>& ViewCuts::Cut(
  const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c)
{
  this->Corners.assign({ { a }, { b }, { c } });
  for (const Plane& plane : this->Planes)
  {
    if (!this->AreAllInside(plane))
    {
      this->CutAt(plane);
    }
  }
  return this->Corners;
}

bool ViewCuts::AreAllInside(const Plane& plane) const
{
  return std::all_of(this->Corners.begin(), this->Corners.end(),
    [&](const CutCorner& corner)
    { return glm::dot(plane.Normal, corner.Place) > DoubtOf(corner, plane); });
}

/** Keeps what is inside, twice what may be, and where edges lead from surely inside to surely beyond. */
void ViewCuts::CutAt(const Plane& plane)
{
  this->Around.clear();
  for (const CutCorner& corner : this->Corners)
  {
    const double distance = glm::dot(plane.Normal, corner.Place);
    const double doubt = DoubtOf(corner, plane);
    this->Around.push_back({ corner, distance, doubt,
      distance > doubt      ? 1
        : distance < -doubt ? -1
                            : 0 });
  }
  this->Corners.clear();
  const std::size_t count = this->Around.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Sided &corner = this->Around[i], &next = this->Around[(i + 1) % count];
    if (corner.Side == 0)
    {
      const Sided& last = this->Around[(i + count - 1) % count];
      const std::size_t more = corner.Corner.IsOneOfTwo ? 1 : 2;
      this->Corners.resize(this->Corners.size() + more, MaybeCutOf(corner, last, next));
    }
    else if (corner.Side > 0)
    {
      this->Corners.push_back(corner.Corner);
    }
    if (corner.Side * next.Side < 0)
    {
      this->Corners.push_back(this->CrossingOf(corner, next, plane));
    }
  }
}

/** By how much the distance of a corner may be off. */
double ViewCuts::DoubtOf(const CutCorner& corner, const Plane& plane)
{
  double doubt = plane.Rounding;
  for (int i = 0; i < corner.SlideCount; ++i)
  {
    doubt += std::abs(glm::dot(plane.Normal, corner.Slides[i]));
  }
  return doubt;
}

/** A corner that may be cut off, somewhere on the edges from there. */
CutCorner ViewCuts::MaybeCutOf(const Sided& corner, const Sided& last, const Sided& next)
{
  CutCorner cut = corner.Corner;
  cut.IsOneOfTwo = true;
  for (const Sided* other : { &last, &next })
  {
    const double most = 3.0 * std::max(corner.Doubt, other->Doubt);
    const double differ = std::abs(other->Distance - corner.Distance);
    cut.AddSlide(
      (differ > most ? most / differ : 1.0) * (other->Corner.Place - corner.Corner.Place));
  }
  return cut;
}

/** Where a plane cuts an edge: as much farther on or back as either end is off, and beside it as they are; where two planes meet it does so nowhere else. */
CutCorner ViewCuts::CrossingOf(const Sided& from, const Sided& to, const Plane& plane) const
{
  const glm::dvec4 along = to.Corner.Place - from.Corner.Place;
  const double share = from.Distance / (from.Distance - to.Distance);
  const double most = 4.0 * std::max(from.Doubt, to.Doubt);
  const double differ = std::abs(to.Distance - from.Distance);
  CutCorner cut;
  cut.Place = from.Corner.Place + share * along;
  cut.Reach = std::max(this->ReachOf(from.Corner), this->ReachOf(to.Corner)) / cut.Place.w;
  cut.Planes = plane.Bit | (from.Corner.Planes & to.Corner.Planes);
  if (cut.Planes != plane.Bit)
  {
    return cut; // where two planes meet
  }
  cut.AddSlide((differ > most ? most / differ : 1.0) * along);
  cut.HasMore = from.Corner.HasMore || to.Corner.HasMore;
  for (const auto& [end, weight] : { std::pair(&from, 1.0 - share), std::pair(&to, share) })
  {
    for (int i = 0; i < end->Corner.SlideCount; ++i)
    {
      cut.AddSlide(weight * end->Corner.Slides[i]);
    }
  }
  return cut;
}

/** Times w: the numbers that a point between it and another is summed of are no larger. */
double ViewCuts::ReachOf(const CutCorner& corner) const
{
  const glm::dvec2 times = glm::abs(glm::dvec2(corner.Place)) / this->Size;
  return std::max({ corner.Reach * std::abs(corner.Place.w), times.x, times.y });
}

}
