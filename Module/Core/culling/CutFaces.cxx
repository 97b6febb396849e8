#include "Core/culling/CutFaces.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

// Of places in the view, where edges are cut: a device sums and multiplies seven times.
const float RoundingOfCuts = 0x1p-21f;

// No two places that it tells apart there are closer than a step of a sum of half the view's width or height.
const float StepOfCuts = 0x1p-25f;

// Of a face of which more corners are left, as it is cut so often and so close to them, nothing is known.
const std::size_t MostCorners = 9;

// No samples are so few steps of the grid that corners are snapped to beside the view's sides.
const double StepsOnASide = 2.0;

const float AnyDepth = 2.0f; // more than all depths differ
}

void CutFaces::Begin(const MeshProjection& projection)
{
  this->Projection = &projection;
  this->MayBeCut = projection.MayBeCut();
  if (!this->MayBeCut)
  {
    return;
  }
  const ScreenMatrix& view = projection.View();
  const float width = view.Size.x;
  const float height = view.Top() - view.Bottom();
  this->Cuts.Begin(view);
  this->OfCuts = { { RoundingOfCuts * width, 0.0f, 0.0f }, { RoundingOfCuts * height, 0.0f, 0.0f },
    { RoundingOfCuts, 0.0f, 0.0f } };
  this->Step = StepOfCuts * std::min(width, height);
}

float CutFaces::UnsteadyOf(std::uint32_t face)
{
  if (!this->MayBeCut || !this->Projection->MayBeCut(face))
  {
    return 0.0f;
  }
  const std::array<glm::dvec4, 3> corners = this->Projection->CornersOnScreen(face);
  this->Corners = &this->Cuts.Cut(corners[0], corners[1], corners[2]);
  if (this->Corners->empty())
  {
    return 0.0f;
  }
  if (!this->IsKnown())
  {
    return AnyDepth;
  }
  this->FindSlopes();
  float most = 0.0f;
  this->ForEachTriangle(
    [&](const std::array<int, 3>& triangle)
    {
      if (!this->IsOnASide(triangle))
      {
        most = std::max(most, this->UnsteadyIn(triangle));
      }
    });
  return most;
}

/** Every three corners. */
template <class Function>
void CutFaces::ForEachTriangle(const Function& function) const
{
  const int count = static_cast<int>(this->Corners->size());
  for (int a = 0; a < count; ++a)
  {
    for (int b = a + 1; b < count; ++b)
    {
      for (int c = b + 1; c < count; ++c)
      {
        function({ a, b, c });
      }
    }
  }
}

bool CutFaces::IsKnown() const
{
  return this->Corners->size() >= 3 && this->Corners->size() <= MostCorners &&
    std::all_of(this->Corners->begin(), this->Corners->end(),
      [&](const CutCorner& corner)
      { return !corner.HasMore && corner.Place.w > this->Projection->View().Rounding.w; });
}

FacePlaces<float> CutFaces::PlacesOf(const std::array<int, 3>& corners) const
{
  FacePlaces<float> places;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const glm::dvec4& place = this->At(corners[i]).Place;
    places.Columns[i] = static_cast<float>(place.x / place.w);
    places.Lines[i] = static_cast<float>(place.y / place.w);
    places.Depths[i] = static_cast<float>(place.z / place.w);
    places.InversesOfW[i] = static_cast<float>(1.0 / place.w);
  }
  return places;
}

/** Those of the largest triangle. */
void CutFaces::FindSlopes()
{
  float largest = -1.0f;
  this->ForEachTriangle(
    [&](const std::array<int, 3>& corners)
    {
      const FacePlaces<float> places = this->PlacesOf(corners);
      const ScreenRounding& rounding = this->Projection->Rounding();
      const float area = std::abs(SidesOnScreen<float>(places, rounding).Area.Value);
      if (area > largest)
      {
        const FaceSlopes<float> slopes(places, rounding, this->Projection->Snapping());
        this->ByColumn = std::abs(slopes.ByColumn.Value);
        this->ByLine = std::abs(slopes.ByLine.Value);
        largest = area;
      }
    });
}

/** By how much twice the area of a triangle may be off since its corners slide along edges. */
double CutFaces::AreaDoubt(const std::array<int, 3>& corners) const
{
  const auto placeOf = [&](int corner)
  { return glm::dvec2(this->At(corner).Place) / this->At(corner).Place.w; };
  double doubt = 0.0, slidBefore = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const CutCorner& corner = this->At(corners[i]);
    const glm::dvec2 across = placeOf(corners[(i + 2) % 3]) - placeOf(corners[(i + 1) % 3]);
    double slid = 0.0;
    for (int k = 0; k < corner.SlideCount; ++k)
    {
      const glm::dvec2 slide = corner.SlideOnScreen(k);
      doubt += std::abs(across.x * slide.y - across.y * slide.x);
      slid += glm::length(slide);
    }
    doubt += slid * slidBefore;
    slidBefore += slid;
  }
  return doubt;
}

/** Whether a triangle lies so close to one of the view's sides that it has no samples. */
bool CutFaces::IsOnASide(const std::array<int, 3>& corners) const
{
  const ScreenMatrix& view = this->Projection->View();
  const glm::dvec2 most = StepsOnASide *
    glm::dvec2(this->Projection->Snapping().Column, this->Projection->Snapping().Line);
  const glm::dvec2 low(0.0, view.Bottom()), high(view.Size.x, view.Top());
  glm::bvec2 isLow(true), isHigh(true);
  for (const int i : corners)
  {
    const CutCorner& corner = this->At(i);
    const glm::dvec2 place = glm::dvec2(corner.Place) / corner.Place.w;
    glm::dvec2 slid(0.0);
    for (int k = 0; k < corner.SlideCount; ++k)
    {
      slid += glm::abs(corner.SlideOnScreen(k));
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      isLow[axis] = isLow[axis] && place[axis] + slid[axis] < low[axis] + most[axis];
      isHigh[axis] = isHigh[axis] && place[axis] - slid[axis] > high[axis] - most[axis];
    }
  }
  return glm::any(isLow) || glm::any(isHigh);
}

/** The corners lie in the face's plane, wherever it is, but for what is rounded where it is cut. */
float CutFaces::UnsteadyIn(const std::array<int, 3>& corners) const
{
  FacePlaces<float> places = this->PlacesOf(corners);
  const SidesOnScreen<float> anywhere(places, this->Projection->Rounding());
  const float leastArea =
    std::max(anywhere.LeastArea() - static_cast<float>(this->AreaDoubt(corners)),
      this->Step * std::min(anywhere.Columns.Largest(), anywhere.Lines.Largest()));
  for (std::size_t i = 0; i < 3; ++i)
  {
    places.InversesOfW[i] = static_cast<float>(this->At(corners[i]).Reach);
  }
  const SidesOnScreen<float> sides(places, this->OfCuts);
  const float byColumn = Cross(sides.Depths, sides.Lines).Off + this->ByColumn * sides.Area.Off;
  const float byLine = Cross(sides.Columns, sides.Depths).Off + this->ByLine * sides.Area.Off;
  const ScreenMargin& snapping = this->Projection->Snapping();
  const float off =
    (byColumn * snapping.Column + byLine * snapping.Line) / leastArea + sides.Tilt(leastArea);
  return off < AnyDepth ? off : AnyDepth; // as where it is no number
}

}
