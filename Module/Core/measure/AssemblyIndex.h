#ifndef VITRINE_CORE_MEASURE_ASSEMBLY_INDEX_H
#define VITRINE_CORE_MEASURE_ASSEMBLY_INDEX_H

#include "Core/measure/MeshStore.h"
#include "Core/measure/PlacedPart.h"
#include "Core/measure/SurfaceGap.h"
#include "Core/octree/Octree.h"

#include <glm/mat4x4.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace vitrine
{

/** How two parts are to each other. */
enum class ClashKinds
{
  Interfering, ///< deeper in one another than the tolerance
  Touching,    ///< not that, and at most the tolerance from each other
  Near         ///< neither, and at most the clearance from each other
};

/** Which part of a pair lies wholly in the other's solid, without meeting its surface. */
enum class Enclosures
{
  None,
  FirstInSecond,
  SecondInFirst
};

struct Clash
{
  std::uint32_t First; ///< lower than Second
  std::uint32_t Second;
  ClashKinds Kind;
  Enclosures Enclosure;
  double Depth;     ///< PenetrationDepth.h's, if deeper than the tolerance; otherwise 0
  double Distance;  ///< of the surfaces
  glm::dvec3 Place; ///< the deepest point, or the middle between the nearest points
};

struct ClashLimits
{
  double Clearance = 0;
  double Tolerance = 0;
};

/** A ray's passage through the surface of a part. */
struct PartCrossing
{
  std::uint32_t Part;
  double Distance; ///< in world units
  std::uint32_t Triangle;
  bool IsEntering; ///< into a closed part; for an open one, through the front of the triangle
};

/** A stretch of a ray in the solid of a closed part. */
struct Wall
{
  std::uint32_t Part;
  double Start; ///< in world units; 0 where the ray begins inside
  double End;
};

/** The point of all parts that is nearest to a point. */
struct NearPart
{
  std::uint32_t Part;
  NearPoint Point;
};

/**
 * Parts of an assembly in two levels: an octree over the boxes of parts, and one over the triangles of each geometry,
 * which parts share and which is made when a query first needs it.
 * Meshes beyond a budget of memory are in a file.
 */
class AssemblyIndex
{
public:
  /** Sets how many bytes meshes may take in memory. Queries read others from a file. Throws as MeshStore does. */
  void SetMemoryBudget(std::size_t bytes) { this->Meshes.SetBudget(bytes); }
  const MeshStore& Store() const { return this->Meshes; }

  /** Keeps a mesh for parts, and returns its number. Throws as MeshStore does. */
  std::uint32_t AddMesh(std::shared_ptr<const PartMesh> mesh);

  /** Adds a part of a mesh that was added before, and returns its number. Throws as MeshStore does. */
  std::uint32_t Add(std::uint32_t mesh, const glm::dmat4& place);

  /** Adds a part of a mesh of its own, and returns its number. Throws as MeshStore does. */
  std::uint32_t Add(std::shared_ptr<const PartMesh> mesh, const glm::dmat4& place);

  std::uint32_t Count() const { return static_cast<std::uint32_t>(this->Parts.size()); }

  /** Returns a part, which keeps its mesh in memory while it is there. Throws as MeshStore does, as do all queries. */
  PlacedPart At(std::uint32_t part) const;

  /** Returns the box around all parts. */
  const WideBox& Bounds() const { return this->Extent; }

  /** Makes the octree over parts. Queries may run in several threads after that, until a part is added. */
  void Build();

  /**
   * Returns what a ray passes through, in order. Crossings of one part at one place, as on an edge of two triangles,
   * are one. The direction has length 1.
   */
  std::vector<PartCrossing> Crossings(const Ray& ray) const;

  /**
   * Returns the stretches of a ray in the solids of closed parts, in the order in which they begin. A part whose
   * crossings do not pair up has none.
   */
  std::vector<Wall> Walls(const Ray& ray) const;

  std::optional<NearPart> Nearest(const glm::dvec3& point) const;

  /** Return the parts whose surface shares a point with a box or a ball, in ascending order. */
  std::vector<std::uint32_t> PartsTouching(const WideBox& box) const;
  std::vector<std::uint32_t> PartsTouching(const glm::dvec3& centre, double radius) const;

  /** Return the parts that lie in a box or a ball, in ascending order. */
  std::vector<std::uint32_t> PartsWithin(const WideBox& box) const;
  std::vector<std::uint32_t> PartsWithin(const glm::dvec3& centre, double radius) const;

  /** Returns the least distance of two parts' surfaces, or nothing if one has no triangles. */
  std::optional<Gap> Distance(std::uint32_t first, std::uint32_t second) const;

  /** Returns pairs of parts whose boxes are at most so far from each other, in ascending order. */
  std::vector<std::pair<std::uint32_t, std::uint32_t>> NearBoxes(double within) const;

  /** Returns how two parts are to each other, or nothing if they are farther away than both limits. */
  std::optional<Clash> Compare(
    std::uint32_t first, std::uint32_t second, const ClashLimits& limits) const;

  /**
   * Returns all pairs that Compare() has a result for, in ascending order. Works in threads.
   * @param goesOn  is called now and then in this thread with the share that is done; false ends the work, and the
   *                result is then what was found
   */
  std::vector<Clash> Clashes(
    const ClashLimits& limits, const std::function<bool(double)>& goesOn) const;

  /**
   * Returns false only if other parts stand between two parts so that each segment between their boxes meets a surface.
   * @param blocks  whether a part blocks views
   */
  bool MaySee(std::uint32_t first, std::uint32_t second,
    const std::function<bool(std::uint32_t)>& blocks) const;

private:
  std::vector<PartCrossing> CrossingsOf(
    std::uint32_t number, const PlacedPart& part, const Ray& ray) const;
  std::vector<std::uint32_t> PartsNear(const WideBox& box) const;

  MeshStore Meshes;
  std::vector<PlacedPart> Parts; ///< without their meshes
  std::vector<std::uint32_t> MeshNumbers;
  std::vector<Box> Boxes;
  Octree Tree;
  WideBox Extent;
};

}

#endif
