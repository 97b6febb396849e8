#ifndef VITRINE_CORE_MEASURE_PART_MESH_H
#define VITRINE_CORE_MEASURE_PART_MESH_H

#include "Core/measure/RayCrossing.h"
#include "Core/octree/Octree.h"
#include "Core/octree/Triangle.h"
#include "Core/octree/TriangleBoxes.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace vitrine
{

/** A ray's crossing of a triangle of a mesh. */
struct MeshCrossing
{
  double Distance; ///< in lengths of the ray's direction
  std::uint32_t Triangle;
  bool FromBehind;
};

/** The point of a mesh nearest to a point. */
struct NearPoint
{
  double Distance;
  std::uint32_t Triangle;
  glm::dvec3 Place;
};

/** A point inside a closed mesh. */
struct InnerPoint
{
  glm::dvec3 Place;
  double Clearance; ///< its distance from the surface
};

/**
 * The triangles of a part in model coordinates, which parts of the same geometry share. Points of one place are one.
 * Triangles with two equal corners, and those with a coordinate that is not finite, are left out.
 *
 * The octree and all else that takes time is made when it is first asked for, also in several threads.
 *
 * The mesh is *closed* if it has triangles, and each edge has an even number of them. Then it has a solid: the points
 * from which a ray crosses the surface an odd number of times.
 */
class PartMesh
{
public:
  /** What a mesh is made of, and all that is needed to make it again. */
  struct Arrays
  {
    std::vector<glm::dvec3> Points;
    std::vector<std::uint32_t> Corners; ///< three for each triangle
    std::vector<std::uint32_t> Sources; ///< one for each triangle
  };

  /** @param corners  three numbers of points for each triangle; numbers out of range leave the triangle out */
  PartMesh(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& corners);

  /** Makes a mesh again. @param content  that of another mesh */
  explicit PartMesh(Arrays content);

  const Arrays& Content() const { return this->Made; }

  std::uint32_t TriangleCount() const
  {
    return static_cast<std::uint32_t>(this->Made.Sources.size());
  }
  const std::vector<glm::dvec3>& Points() const { return this->Made.Points; }

  /** Returns the numbers of a triangle's points. */
  const std::uint32_t* CornersOf(std::uint32_t triangle) const
  {
    return this->Made.Corners.data() + 3 * std::size_t{ triangle };
  }

  Triangle TriangleAt(std::uint32_t triangle) const;

  /** Returns the number that a triangle had where the mesh was made. */
  std::uint32_t SourceOf(std::uint32_t triangle) const { return this->Made.Sources[triangle]; }

  bool IsClosed() const { return this->Details().Closed; }

  /** Returns one triangle of each set of triangles that are joined by common points. */
  const std::vector<std::uint32_t>& Pieces() const { return this->Details().Pieces; }

  /** Returns the place in Pieces() of each point's set. */
  const std::vector<std::uint32_t>& PiecesOfPoints() const { return this->Details().OfPoints; }

  /** Returns a few points inside a closed mesh, the one farthest from the surface first. */
  const std::vector<InnerPoint>& InnerPoints() const;

  const Octree& Tree() const;
  TriangleBoxes<double, std::uint32_t> Boxes() const;

  /** Returns all crossings of a ray with the surface, in order. On an edge, each of its triangles may have one. */
  std::vector<MeshCrossing> Crossings(const Ray& ray) const;

  /** Returns the nearest point that is at most so far away. */
  std::optional<NearPoint> Nearest(
    const glm::dvec3& point, double within = std::numeric_limits<double>::infinity()) const;

  /** Returns true if a point of the surface is at most so far away. */
  bool HasWithin(const glm::dvec3& point, double radius) const;

  /**
   * Returns true if a point is in the solid of a closed mesh. Rays are tried until one is clear of all edges. If there
   * is none, most of them decide. For a point on the surface the result may be either.
   */
  bool Contains(const glm::dvec3& point) const;

private:
  struct Detail
  {
    bool Closed = false;
    std::vector<std::uint32_t> Pieces;
    std::vector<std::uint32_t> OfPoints;
  };
  const Detail& Details() const;
  Detail FindDetails() const;
  std::vector<InnerPoint> FindInnerPoints() const;

  Arrays Made;
  mutable std::once_flag HasTree, HasDetails, HasInnerPoints;
  mutable Octree Space;
  mutable Detail Found;
  mutable std::vector<InnerPoint> Inner;
};

}

#endif
