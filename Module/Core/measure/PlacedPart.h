#ifndef VITRINE_CORE_MEASURE_PLACED_PART_H
#define VITRINE_CORE_MEASURE_PLACED_PART_H

#include "Core/geometry/Box.h"
#include "Core/measure/PartMesh.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace vitrine
{

/** A box of doubles. It is empty if a Low exceeds its High. */
struct WideBox
{
  glm::dvec3 Low{ std::numeric_limits<double>::infinity() };
  glm::dvec3 High{ -std::numeric_limits<double>::infinity() };

  void Add(const glm::dvec3& point);
  void Add(const WideBox& other);
  bool IsEmpty() const { return !(Low.x <= High.x && Low.y <= High.y && Low.z <= High.z); }
  WideBox GrownBy(double margin) const;
  WideBox ClippedTo(const WideBox& other) const;
  bool Contains(const glm::dvec3& point) const;
  bool Touches(const WideBox& other) const;

  /** Returns the largest coordinate without its sign, or 0 if the box is empty. */
  double Reach() const;
};

/** Returns the distance between two boxes that are not empty. */
double DistanceBetween(const WideBox& a, const WideBox& b);

/** A triangle in world coordinates, with its box and its number in the part's mesh. */
struct PlacedTriangle
{
  Triangle Corners;
  WideBox Extent;
  std::uint32_t Item;
};

/**
 * A mesh at a place. Places that turn, move, mirror or scale evenly leave the mesh shared. Others have a mesh of their
 * own in world coordinates. A place with a number that is not finite leaves no triangles.
 */
class PlacedPart
{
public:
  PlacedPart(std::shared_ptr<const PartMesh> mesh, const glm::dmat4& place);

  /** Returns the mesh, which is then no longer the part's. Until With() only Bounds() may be asked. */
  std::shared_ptr<const PartMesh> TakeMesh() { return std::move(this->Shape); }

  /** Returns the part with its mesh, after TakeMesh(). */
  PlacedPart With(std::shared_ptr<const PartMesh> mesh) const;

  const PartMesh& Mesh() const { return *this->Shape; }
  const WideBox& Bounds() const { return this->Extent; }
  bool IsClosed() const { return this->Shape->IsClosed(); }

  glm::dvec3 ToWorld(const glm::dvec3& point) const;
  glm::dvec3 ToModel(const glm::dvec3& point) const;
  Triangle TriangleAt(std::uint32_t triangle) const;

  /** Returns how many units of the world are one of the mesh. */
  double Scale() const { return this->Ratio; }

  /** Returns the triangles whose boxes share a point with a box of the world. */
  std::vector<PlacedTriangle> TrianglesTouching(const WideBox& region) const;

  /** Return the same as PartMesh's functions, in world coordinates and lengths. */
  std::vector<MeshCrossing> Crossings(const Ray& ray) const;
  std::optional<NearPoint> Nearest(
    const glm::dvec3& point, double within = std::numeric_limits<double>::infinity()) const;
  bool HasWithin(const glm::dvec3& point, double radius) const;
  bool Contains(const glm::dvec3& point) const;

private:
  WideBox ModelBoxAround(const WideBox& region) const;

  std::shared_ptr<const PartMesh> Shape;
  glm::dmat4 Place;
  glm::dmat4 Inverse;
  double Ratio = 1.0;
  bool IsMirrored = false;
  WideBox Extent;
};

}

#endif
