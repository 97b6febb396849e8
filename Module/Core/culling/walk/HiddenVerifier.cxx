#include "Core/culling/walk/HiddenVerifier.h"

#include "Core/culling/screen/DeviceModel.h"
#include "Core/geometry/BoxLanes.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

/** Returns the square of the length of the longest axis. */
double LongestAxisOf(const glm::dmat4& m)
{
  const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
  return std::max({ glm::dot(x, x), glm::dot(y, y), glm::dot(z, z) });
}

/** Returns true if the axes stay at right angles, up to the rounding of doubles. */
bool IsOrthogonal(const glm::dmat4& m)
{
  const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
  const double most = 1e-9 * LongestAxisOf(m);
  return std::abs(glm::dot(x, y)) <= most && std::abs(glm::dot(y, z)) <= most &&
    std::abs(glm::dot(z, x)) <= most;
}

/**
 * The greatest factors by which lengths grow on the way to the world and back. No length grows by more than all three
 * axes together.
 */
struct Stretch
{
  double ToWorld;
  double FromWorld;

  Stretch(const glm::dmat4& toWorld, const glm::dmat4& fromWorld)
  {
    const double most = IsOrthogonal(toWorld) ? 1.0 : std::sqrt(3.0);
    this->ToWorld = most * std::sqrt(LongestAxisOf(toWorld));
    this->FromWorld = most * std::sqrt(LongestAxisOf(glm::transpose(fromWorld)));
  }
};
}

HiddenVerifier::HiddenVerifier(BandTools& tools, ShapeSource& shapes, const ScreenProjection& view)
  : Tools(tools)
  , Shapes(shapes)
  , View(view)
  , Planes(view.OfPlanes())
  , Snapping(view.Snapping().Column, view.Snapping().Line)
  , Faces(tools.Lines, view)
  , ApartView(view.GrownBy(glm::vec2(tools.Lines.Samples().LinesPerPixel())))
  , FacesApart(tools.Lines, this->ApartView)
{
  const double scale = view.SmallestScale();
  this->Thinnest.Fixed = ThinOfSnapping * std::max(this->Snapping.x, this->Snapping.y) / scale;
  this->Thinnest.ByNear = ThinOfRounding * view.RoundingAtOne() / scale;
}

void HiddenVerifier::Verify(
  const std::vector<BoxedPart>& parts, std::size_t first, std::vector<std::uint8_t>& areHidden)
{
  const std::size_t end = std::min<std::size_t>(parts.size(), first + LaneCount);
  BoxLanes boxes;
  for (std::size_t i = first; i < end; ++i)
  {
    boxes.Set(static_cast<int>(i - first), parts[i].Bounds);
  }
  RectangleLanes rectangles;
  this->View.Project(boxes, rectangles);
  for (std::size_t i = first; i < end; ++i)
  {
    const auto lane = static_cast<int>(i - first);
    const bool isKnown = this->Tools.States.Has(parts[i].Part, PartStates::AreFacesHidden) &&
      !this->Shapes.IsDrawnApart(parts[i].Part);
    if ((rectangles.Outside >> lane & 1u) == 0 && !isKnown)
    {
      areHidden[i] = this->IsHidden(parts[i].Part, rectangles, lane);
    }
  }
}

bool HiddenVerifier::IsHidden(std::uint32_t part, const RectangleLanes& rectangles, int lane)
{
  ScreenRectangle around = rectangles.At(lane);
  const bool isBehindNear = (rectangles.Near >> lane & 1u) == 0;
  const bool mayBeCut = this->View.MayBeCut(around, rectangles.Farthest[lane]);
  around.Nearest +=
    this->FindThinFaces(part) + this->TiltOf(around, around.Nearest - rectangles.Farthest[lane]);
  if (this->Shapes.IsDrawnApart(part))
  {
    return isBehindNear && !mayBeCut && this->IsHiddenApart(part, around);
  }
  const bool isBoxHidden = isBehindNear && this->Tools.Lines.Hides(around);
  const bool areFacesHidden = (isBoxHidden && this->ThinFaces.empty() && !mayBeCut) ||
    this->AreFacesHidden(part, around, isBoxHidden);
  return areFacesHidden && this->AreItsLinesHidden(part);
}

/**
 * Finds the faces of a part that are too thin to have a known depth. Returns by how much a device may draw the other
 * faces nearer than their corners.
 */
float HiddenVerifier::FindThinFaces(std::uint32_t part)
{
  const PartPlanes known = this->Shapes.PlanesOf(part);
  const glm::dmat4& fromWorld = *known.FromWorld;
  const PlaneView fromPart{ fromWorld * this->Planes.Eye, fromWorld * this->Planes.ByColumn,
    fromWorld * this->Planes.ByLine };
  FacePlanes::Thickness thinnest = this->Thinnest;
  const Stretch stretch(*known.ToWorld, fromWorld);
  thinnest.ByNear *= stretch.FromWorld;
  thinnest.Unevenness = stretch.ToWorld * stretch.ToWorld * stretch.FromWorld * stretch.FromWorld;
  this->ThinFaces.clear();
  const glm::dvec2 slopes = known.Planes->FindThin(fromPart, thinnest, this->ThinFaces);
  return static_cast<float>(SteeperOnDevice * glm::dot(slopes, this->Snapping)) +
    StepsOnDevice * this->View.Snapping().Depth;
}

/** Returns by how much the other faces may be nearer because a device rounds their planes. */
float HiddenVerifier::TiltOf(const ScreenRectangle& around, float depth) const
{
  const float narrowest = std::min(around.Right - around.Left, around.Top - around.Bottom);
  return RoundingOfTilt * depth * narrowest /
    static_cast<float>(ThinOfSnapping * std::max(this->Snapping.x, this->Snapping.y));
}

bool HiddenVerifier::AreItsLinesHidden(std::uint32_t part)
{
  const std::vector<MeshLine>& lines = this->Shapes.LinesOf(part);
  const PartPlanes known = this->Shapes.PlanesOf(part);
  return lines.empty() ||
    AreLinesHidden(lines, this->View.Of(*known.ToWorld, *known.Drawn), this->View.GrowthOnScreen(),
      this->Tools.Lines);
}

/**
 * Verifies a part that is drawn at another place of a pixel than its occluders (ShapeSource::IsDrawnApart). They have
 * to hide it all over the pixels that it touches.
 */
bool HiddenVerifier::IsHiddenApart(std::uint32_t part, const ScreenRectangle& around)
{
  return this->Shapes.LinesOf(part).empty() &&
    this->Tools.Lines.Hides(this->ApartView.Grown(around)) &&
    (this->ThinFaces.empty() ||
      (this->Project(part) && this->Tools.Projected.IsBehindNear() &&
        this->FacesApart.AreSomeOfAnyThickness(
          this->Tools.Projected, this->ThinFaces, around.Nearest)));
}

/** Verifies faces one by one: the thin ones, or all of them if the box may show. */
bool HiddenVerifier::AreFacesHidden(
  std::uint32_t part, const ScreenRectangle& around, bool isBoxHidden)
{
  if (!this->Project(part))
  {
    return false;
  }
  const MeshProjection& projected = this->Tools.Projected;
  return isBoxHidden && projected.IsBehindNear()
    ? this->Faces.AreSomeOfAnyThickness(projected, this->ThinFaces, around.Nearest)
    : this->Faces.AreAllOfAnyThickness(projected) && !projected.MayShowBeforeNear();
}

/** Projects a part. Returns false if more than faces is drawn of it, or if it has no mesh. */
bool HiddenVerifier::Project(std::uint32_t part)
{
  const Occluder shape = this->Shapes.OccluderOf(part);
  if (!shape.Mesh || !shape.IsOfFacesAlone)
  {
    return false;
  }
  this->Tools.Projected.Project(*shape.Mesh, this->View.Of(*shape.ToWorld, *shape.Drawn));
  return true;
}

}
