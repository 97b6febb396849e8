#include "Core/measure/PlacedPart.h"

#include "Core/geometry/Finite.h"
#include "Core/octree/OctreeQueries.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace vitrine
{

namespace
{

bool IsFiniteMatrix(const glm::dmat4& matrix)
{
  bool isFinite = true;
  for (int column = 0; column < 4; ++column)
  {
    isFinite = isFinite && IsFinite(glm::dvec3(matrix[column])) &&
      matrix[column].w == (column == 3 ? 1.0 : 0.0);
  }
  return isFinite;
}

/** Returns the scale of a matrix that scales all directions alike, or 0. */
double EvenScale(const glm::dmat4& matrix)
{
  const double tolerance = 1e-9;
  const glm::dvec3 axes[3] = { glm::dvec3(matrix[0]), glm::dvec3(matrix[1]),
    glm::dvec3(matrix[2]) };
  const double scale = glm::length(axes[0]);
  bool isEven = scale > 0 && std::isfinite(1 / scale);
  for (int i = 0; i < 3; ++i)
  {
    isEven = isEven && std::abs(glm::length(axes[i]) - scale) <= tolerance * scale &&
      std::abs(glm::dot(axes[i], axes[(i + 1) % 3])) <= tolerance * scale * scale;
  }
  return isEven ? scale : 0.0;
}

std::shared_ptr<const PartMesh> PlaceMesh(const PartMesh& mesh, const glm::dmat4& place)
{
  std::vector<glm::dvec3> points;
  for (const glm::dvec3& point : mesh.Points())
  {
    points.emplace_back(place * glm::dvec4(point, 1.0));
  }
  const std::uint32_t* const corners = mesh.TriangleCount() > 0 ? mesh.CornersOf(0) : nullptr;
  return std::make_shared<PartMesh>(
    points, std::vector<std::uint32_t>(corners, corners + 3 * std::size_t{ mesh.TriangleCount() }));
}

}

void WideBox::Add(const glm::dvec3& point)
{
  this->Low = glm::min(this->Low, point);
  this->High = glm::max(this->High, point);
}

void WideBox::Add(const WideBox& other)
{
  this->Low = glm::min(this->Low, other.Low);
  this->High = glm::max(this->High, other.High);
}

WideBox WideBox::GrownBy(double margin) const
{
  return { this->Low - margin, this->High + margin };
}

WideBox WideBox::ClippedTo(const WideBox& other) const
{
  return { glm::max(this->Low, other.Low), glm::min(this->High, other.High) };
}

bool WideBox::Contains(const glm::dvec3& point) const
{
  return point.x >= this->Low.x && point.x <= this->High.x && point.y >= this->Low.y &&
    point.y <= this->High.y && point.z >= this->Low.z && point.z <= this->High.z;
}

bool WideBox::Touches(const WideBox& other) const
{
  return !this->ClippedTo(other).IsEmpty();
}

double WideBox::Reach() const
{
  double reach = 0;
  for (int axis = 0; axis < 3 && !this->IsEmpty(); ++axis)
  {
    reach = std::max({ reach, std::abs(this->Low[axis]), std::abs(this->High[axis]) });
  }
  return reach;
}

double DistanceBetween(const WideBox& a, const WideBox& b)
{
  return glm::length(glm::max(glm::max(a.Low - b.High, b.Low - a.High), glm::dvec3(0.0)));
}

PlacedPart::PlacedPart(std::shared_ptr<const PartMesh> mesh, const glm::dmat4& place)
  : Shape(std::move(mesh))
  , Place(place)
  , Inverse(1.0)
{
  if (!IsFiniteMatrix(place))
  {
    this->Shape =
      std::make_shared<PartMesh>(std::vector<glm::dvec3>(), std::vector<std::uint32_t>());
    this->Place = glm::dmat4(1.0);
  }
  else if (const double scale = EvenScale(place); scale > 0)
  {
    this->Ratio = scale;
    this->Inverse = glm::inverse(place);
    this->IsMirrored = glm::determinant(glm::dmat3(place)) < 0;
  }
  else
  {
    this->IsMirrored = glm::determinant(glm::dmat3(place)) < 0;
    this->Shape = PlaceMesh(*this->Shape, place);
    this->Place = glm::dmat4(1.0);
  }
  for (const glm::dvec3& point : this->Shape->Points())
  {
    this->Extent.Add(this->ToWorld(point));
  }
}

PlacedPart PlacedPart::With(std::shared_ptr<const PartMesh> mesh) const
{
  PlacedPart part(*this);
  part.Shape = std::move(mesh);
  return part;
}

glm::dvec3 PlacedPart::ToWorld(const glm::dvec3& point) const
{
  return glm::dvec3(this->Place * glm::dvec4(point, 1.0));
}

glm::dvec3 PlacedPart::ToModel(const glm::dvec3& point) const
{
  return glm::dvec3(this->Inverse * glm::dvec4(point, 1.0));
}

Triangle PlacedPart::TriangleAt(std::uint32_t triangle) const
{
  const Triangle model = this->Shape->TriangleAt(triangle);
  return { this->ToWorld(model[0]), this->ToWorld(model[1]), this->ToWorld(model[2]) };
}

WideBox PlacedPart::ModelBoxAround(const WideBox& region) const
{
  const double rounding = 1e-12;
  const glm::dvec3 middle = this->ToModel((region.Low + region.High) / 2.0);
  const glm::dvec3 half = (region.High - region.Low) / 2.0;
  glm::dvec3 reach(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    reach += glm::abs(glm::dvec3(this->Inverse[axis])) * half[axis];
  }
  const double moved = glm::length(glm::dvec3(this->Inverse[3]));
  const double slack = rounding * (moved + (region.Reach() + this->Extent.Reach()) / this->Ratio);
  return WideBox{ middle - reach, middle + reach }.GrownBy(slack);
}

std::vector<PlacedTriangle> PlacedPart::TrianglesTouching(const WideBox& region) const
{
  std::vector<PlacedTriangle> found;
  const WideBox clipped = region.ClippedTo(this->Extent);
  if (clipped.IsEmpty())
  {
    return found;
  }
  const auto add = [&](std::uint32_t item)
  {
    PlacedTriangle placed{ this->TriangleAt(item), {}, item };
    for (const glm::dvec3& corner : placed.Corners)
    {
      placed.Extent.Add(corner);
    }
    if (placed.Extent.Touches(region))
    {
      found.push_back(placed);
    }
  };
  constexpr std::uint32_t few = 64; // A tree takes longer to ask than so many triangles.
  if (this->Shape->TriangleCount() <= few ||
    (clipped.Low == this->Extent.Low && clipped.High == this->Extent.High))
  {
    for (std::uint32_t item = 0; item < this->Shape->TriangleCount(); ++item)
    {
      add(item);
    }
    return found;
  }
  const WideBox model = this->ModelBoxAround(clipped);
  for (const std::uint32_t item :
    ItemsTouching(this->Shape->Tree(), this->Shape->Boxes(), Box::Around(model.Low, model.High)))
  {
    add(item);
  }
  return found;
}

std::vector<MeshCrossing> PlacedPart::Crossings(const Ray& ray) const
{
  const Ray model{ this->ToModel(ray.Origin), glm::dmat3(this->Inverse) * ray.Direction,
    ray.Furthest };
  std::vector<MeshCrossing> crossings = this->Shape->Crossings(model);
  for (MeshCrossing& crossing : crossings)
  {
    crossing.FromBehind = crossing.FromBehind != this->IsMirrored;
  }
  return crossings;
}

std::optional<NearPoint> PlacedPart::Nearest(const glm::dvec3& point, double within) const
{
  std::optional<NearPoint> near = this->Shape->Nearest(this->ToModel(point), within / this->Ratio);
  if (near)
  {
    near->Distance *= this->Ratio;
    near->Place = this->ToWorld(near->Place);
  }
  return near;
}

bool PlacedPart::HasWithin(const glm::dvec3& point, double radius) const
{
  return this->Shape->HasWithin(this->ToModel(point), radius / this->Ratio);
}

bool PlacedPart::Contains(const glm::dvec3& point) const
{
  return this->Extent.Contains(point) && this->Shape->Contains(this->ToModel(point));
}

}
