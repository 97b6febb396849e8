#include "Core/culling/steady/CutFaces.h"

#include "Core/culling/screen/DeviceModel.h"
#include "Core/geometry/BeyondAll.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

// If more corners are left of a face, nothing is known of it: it is cut too often and too close to its corners.
const std::size_t MostCorners = 9;
const std::size_t MostSlides = 8; // of one corner

const double FarAway = 1e9; // columns and lines: farther than anything that matters

/** Returns the places of three corners. */
template <class Triangle>
FacePlaces<float> PlacesOf(const Triangle& corners)
{
  const auto& [a, b, c] = corners;
  return { { a->Column, b->Column, c->Column }, { a->Line, b->Line, c->Line },
    { a->Depth, b->Depth, c->Depth }, { a->InverseOfW, b->InverseOfW, c->InverseOfW } };
}
}

void CutFaces::Begin(const MeshProjection& projection, const SampleGrid& samples)
{
  this->Projection = &projection;
  this->MayBeCut = projection.MayBeCut();
  if (!this->MayBeCut)
  {
    return;
  }
  const ScreenMatrix& view = projection.View();
  this->Cuts.Begin(view);
  const ScreenMargin& snapping = projection.Snapping();
  this->AreSidesBare = samples.Inset() > StepsOnASide * std::max(snapping.Column, snapping.Line);
  this->OfCuts = RoundingWhereCut(view);
  this->Step = StepOfCuts * std::min(view.Size.x, view.Top() - view.Bottom());
}

float CutFaces::UnsteadyOf(const MeshFace& face)
{
  if (!this->MayBeCut || !this->Projection->MayBeCut(face))
  {
    return 0.0f;
  }
  const std::array<glm::dvec4, 3> corners = this->Projection->CornersOnScreen(face);
  const std::vector<CutCorner>& left = this->Cuts.Cut(corners[0], corners[1], corners[2]);
  if (left.empty())
  {
    return 0.0f;
  }
  if (!this->IsKnown(left))
  {
    return AnyDepth;
  }
  this->FindCorners(left);
  this->FindSlopes();
  float most = 0.0f;
  this->ForEachTriangle(
    [&](const Triangle& corners)
    {
      const bool isOnASide = (corners[0]->Sides & corners[1]->Sides & corners[2]->Sides) != 0;
      if (!isOnASide || !this->AreSidesBare)
      {
        most = std::max(most, this->UnsteadyIn(corners));
      }
    });
  return most;
}

FacetDepths CutFaces::UnsteadyOf(const FewFacets& facets, MeshProjection::Facing facing)
{
  FacetDepths unsteady{};
  if (!this->MayBeCut)
  {
    return unsteady;
  }
  for (int i = 0; i < LaneCount; ++i)
  {
    const MeshFace largest = facets.Largest(i);
    if (this->Projection->FacingOf(largest) == facing)
    {
      unsteady[i] = std::max(this->UnsteadyOf(largest), this->UnsteadyOf(facets.Other(i)));
    }
  }
  return unsteady;
}

bool CutFaces::IsKnown(const std::vector<CutCorner>& corners) const
{
  return corners.size() >= 3 && corners.size() <= MostCorners &&
    std::all_of(corners.begin(), corners.end(),
      [&](const CutCorner& corner)
      {
        return corner.Slides.End - corner.Slides.First <= MostSlides &&
          corner.Place.w > this->Projection->View().Rounding.w;
      });
}

/** Finds the corners on the screen. */
void CutFaces::FindCorners(const std::vector<CutCorner>& corners)
{
  this->Corners.clear();
  this->SlidesOnScreen.clear();
  for (const CutCorner& corner : corners)
  {
    const double inverse = 1.0 / corner.Place.w;
    const glm::dvec2 place = inverse * glm::dvec2(corner.Place);
    const std::size_t first = this->SlidesOnScreen.size();
    const glm::dvec2 slid = this->AddSlides(corner);
    this->Corners.push_back({ static_cast<float>(place.x), static_cast<float>(place.y),
      static_cast<float>(inverse * corner.Place.z), static_cast<float>(inverse),
      static_cast<float>(corner.Reach), place, { first, this->SlidesOnScreen.size() },
      glm::length(slid), this->SidesAt(place, slid), corner.Planes });
  }
}

/** Adds the slides of a corner on the screen. Returns how far it slides at most, in columns and in lines. */
glm::dvec2 CutFaces::AddSlides(const CutCorner& corner)
{
  double nearestW = corner.Place.w;
  for (std::size_t i = corner.Slides.First; i < corner.Slides.End; ++i)
  {
    nearestW -= std::abs(this->Cuts.Slides()[i].w);
  }
  glm::dvec2 all(0.0);
  for (std::size_t i = corner.Slides.First; i < corner.Slides.End; ++i)
  {
    const glm::dvec4& slide = this->Cuts.Slides()[i];
    const glm::dvec2 change =
      glm::dvec2(slide) - glm::dvec2(corner.Place) / corner.Place.w * slide.w;
    const glm::dvec2 onScreen = nearestW > 0.0 ? change / nearestW : glm::dvec2(FarAway);
    this->SlidesOnScreen.push_back(onScreen);
    all += glm::abs(onScreen);
  }
  return all;
}

unsigned CutFaces::SidesAt(const glm::dvec2& place, const glm::dvec2& slid) const
{
  const ScreenMatrix& view = this->Projection->View();
  const ScreenMargin& snapping = this->Projection->Snapping();
  const glm::dvec2 most = StepsOnASide * glm::dvec2(snapping.Column, snapping.Line);
  const glm::dvec2 low = most - slid, high = glm::dvec2(view.Size.x, view.Top()) - most + slid;
  return unsigned{ place.x < low.x } | unsigned{ place.x > high.x } << 1 |
    unsigned{ place.y < low.y + view.Bottom() } << 2 | unsigned{ place.y > high.y } << 3;
}

/** Calls a function with every triangle of corners. */
template <class Function>
void CutFaces::ForEachTriangle(const Function& function) const
{
  for (auto a = this->Corners.begin(); a != this->Corners.end(); ++a)
  {
    for (auto b = a + 1; b != this->Corners.end(); ++b)
    {
      for (auto c = b + 1; c != this->Corners.end(); ++c)
      {
        function({ &*a, &*b, &*c });
      }
    }
  }
}

/** Finds the slopes of the largest triangle. */
void CutFaces::FindSlopes()
{
  Triangle largest{ &this->Corners[0], &this->Corners[1], &this->Corners[2] };
  double mostArea = -1.0;
  this->ForEachTriangle(
    [&](const Triangle& corners)
    {
      const auto& [a, b, c] = corners;
      const glm::dvec2 first = b->Place - a->Place, second = c->Place - a->Place;
      const double area = std::abs(first.x * second.y - second.x * first.y);
      if (area > mostArea)
      {
        mostArea = area;
        largest = corners;
      }
    });
  const FaceSlopes<float> slopes(
    PlacesOf(largest), this->Projection->Rounding(), this->Projection->Snapping());
  const auto most = [](const Estimate<float>& slope)
  { return slope.Off >= 0.0f ? std::abs(slope.Value) + slope.Off : BeyondAll; };
  this->ByColumn = most(slopes.ByColumn);
  this->ByLine = most(slopes.ByLine);
}

/** Returns by how much twice the area of a triangle may be off because its corners slide along edges. */
double CutFaces::AreaDoubt(const Triangle& corners) const
{
  double doubt = 0.0, slidBefore = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Corner& corner = *corners[i];
    const glm::dvec2 across = corners[(i + 2) % 3]->Place - corners[(i + 1) % 3]->Place;
    for (std::size_t k = corner.Slides.First; k < corner.Slides.End; ++k)
    {
      const glm::dvec2& slide = this->SlidesOnScreen[k];
      doubt += std::abs(across.x * slide.y - across.y * slide.x);
    }
    doubt += corner.Slid * slidBefore;
    slidBefore += corner.Slid;
  }
  return doubt;
}

/**
 * Returns a lower bound of twice the area of a triangle with two corners on one side of the view. A device tells these
 * two apart by at least a step of floats, and the third corner is surely beside the side. Returns 0 for other
 * triangles.
 * @param off  bound of what rounding moves columns and lines of all corners, in sum
 */
float CutFaces::LeastOnASide(const Triangle& corners, float off) const
{
  const auto& [a, b, c] = corners;
  const unsigned shared =
    (a->Planes & b->Planes) | (b->Planes & c->Planes) | (c->Planes & a->Planes);
  const auto [leastColumn, mostColumn] = std::minmax({ a->Column, b->Column, c->Column });
  const auto [leastLine, mostLine] = std::minmax({ a->Line, b->Line, c->Line });
  return (shared & ViewCuts::Sides) != 0
    ? this->Step * std::max(0.0f, std::min(mostColumn - leastColumn, mostLine - leastLine) - off)
    : 0.0f;
}

/**
 * Returns by how much depths may be off in one triangle. Its corners lie in the plane of the face, wherever that is, up
 * to rounding where it is cut.
 */
float CutFaces::UnsteadyIn(const Triangle& corners) const
{
  FacePlaces<float> places = PlacesOf(corners);
  const SidesOnScreen<float> anywhere(places, this->Projection->Rounding());
  const auto slid = static_cast<float>(corners[0]->Slid + corners[1]->Slid + corners[2]->Slid);
  const float off = anywhere.Columns.SumOff() + anywhere.Lines.SumOff() + slid;
  const float leastArea =
    std::max(anywhere.LeastArea() - static_cast<float>(this->AreaDoubt(corners)),
      this->LeastOnASide(corners, off));
  for (std::size_t i = 0; i < 3; ++i)
  {
    places.InversesOfW[i] = corners[i]->Reach;
  }
  const SidesOnScreen<float> sides(places, this->OfCuts);
  const float byColumn = Cross(sides.Depths, sides.Lines).Off + this->ByColumn * sides.Area.Off;
  const float byLine = Cross(sides.Columns, sides.Depths).Off + this->ByLine * sides.Area.Off;
  const ScreenMargin& snapping = this->Projection->Snapping();
  const float unsteady =
    (byColumn * snapping.Column + byLine * snapping.Line) / leastArea + sides.Tilt(leastArea);
  return unsteady < AnyDepth ? unsteady : AnyDepth; // also if it is no number
}

}
