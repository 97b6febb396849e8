#ifndef VITRINE_CULLING_PART_GEOMETRY_H
#define VITRINE_CULLING_PART_GEOMETRY_H

#include "Core/culling/hidden/HiddenLines.h"
#include "Core/culling/mesh/MeshBoxes.h"
#include "Core/culling/mesh/OccluderMesh.h"
#include "Core/culling/mesh/OrderedRuns.h"
#include "Core/culling/steady/FacePlanes.h"
#include "culling/ReadingHistory.h"

#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <glm/vec3.hpp>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

class vtkPolyData;

namespace vitrine
{

std::vector<glm::dvec3> PointsOf(vtkPolyData* data);

/**
 * Returns the triangles that VTK draws polygons as, three corners each: a fan around the first point. Returns none if a
 * polygon has a point that does not exist.
 */
std::vector<std::uint32_t> TrianglesOf(vtkPolyData* data);

/** Returns true if there are ghost cells or points, which VTK may or may not draw. */
bool HasGhosts(vtkPolyData* data);

/**
 * The modification times of points, of each kind of cells, and of ghosts. A new array in place of an old one changes
 * them, too. VTK draws only from its buffers, which change with these. So other changes of a polydata do not count.
 */
using ShapeTimes = std::array<vtkMTimeType, 7>;
ShapeTimes ShapeTimesOf(vtkPolyData* data);

/**
 * What culling needs to know of a polydata, or of some of its triangles. Parts that show the same polydata share one
 * object.
 */
class PartGeometry
{
public:
  /**
   * Reads the points of `data` as it is now.
   * @param before  the geometry that was shown in its place, if that is known: of these data before they changed, or of
   *                other data
   */
  explicit PartGeometry(vtkPolyData* data, const PartGeometry* before = nullptr);

  /** Describes a run of the triangles of `data`, which must have finite points and nothing but polygons. */
  PartGeometry(vtkPolyData* data, std::shared_ptr<const std::vector<std::uint32_t>> corners,
    const OrderedRun& run);

  /**
   * Returns true if it was made of `data`, as they are now or before a change. Returns false for other data at the
   * address of deleted ones.
   */
  bool WasOf(vtkPolyData* data) const;

  /**
   * Returns true if it describes the points and cells of `data` that a device has now. A device gets them anew when
   * they were modified themselves. The data are looked at once a frame, whoever shares them. Several threads may call
   * this.
   */
  bool IsCurrent(vtkPolyData* data, vtkMTimeType frame);

  /**
   * Returns the time at which `data` was last modified in any way, or 0 for other data. The data are looked at once a
   * frame. Several threads may call this.
   */
  vtkMTimeType TimeOf(vtkPolyData* data, vtkMTimeType frame);

  /**
   * Returns true if the data change so often that their faces are not read in this frame. Then Occluder() has no faces,
   * and Planes() must not be called. Several threads may call this.
   */
  bool IsRestless(vtkMTimeType frame) { return !this->History.AreWorthReading(frame); }

  /** The corners of the box of all points, in model coordinates (MC). Least exceeds Greatest if there are no points. */
  const glm::dvec3& Least() const { return this->Low; }
  const glm::dvec3& Greatest() const { return this->High; }

  /** Returns true if floats can hold all points. */
  bool IsFinite() const { return this->AreAllFinite; }

  /** Returns true if there are vertices or lines, which are drawn wider than they are. */
  bool HasThinCells() const { return this->HasVertsOrLines; }

  /** Returns true if there are polygons, all of which are surely drawn. Otherwise Occluder() has no faces. */
  bool HasSurePolygons() const { return this->HasPolygons && !this->HasGhostCells; }

  /** Returns true if nothing but polygons is drawn. */
  bool IsOfFacesAlone() const { return !this->HasVertsOrLines && !this->HasStrips; }

  /**
   * Returns the planes of its polygons and strips. The first call reads them, in whichever thread. `data` must be
   * current.
   */
  const FacePlanes& Planes(vtkPolyData* data);

  /** Returns the lines of its cells. The first call reads them, in whichever thread. `data` must be current. */
  const std::vector<MeshLine>& Lines(vtkPolyData* data);

  /**
   * Returns its triangles and convex polygons as an occluder. The first call builds it, in whichever thread. `data`
   * must be current.
   */
  const OccluderMesh& Occluder(vtkPolyData* data, vtkMTimeType frame);

  /**
   * Returns boxes around the faces of the occluder, after this was built. Returns null if there are few faces, or if
   * more than faces is drawn.
   */
  const MeshBoxes* Boxes() const { return this->BoxesOfMesh.get(); }

private:
  struct MeshTriangles
  {
    std::vector<glm::dvec3> Points;
    std::vector<std::uint32_t> Corners; ///< three corners of each triangle
  };

  void LookAt(vtkPolyData* data, vtkMTimeType frame);
  void ReadPoints(vtkPolyData* data);
  void BuildMesh(vtkPolyData* data);
  MeshTriangles TrianglesFrom(vtkPolyData* data) const;
  MeshTriangles TrianglesOfRun(vtkPolyData* data) const;

  vtkPolyData* Data;
  ShapeTimes Times;
  std::atomic<vtkMTimeType> Time;          ///< the modification time of the data
  std::atomic<vtkMTimeType> LookedAt{ 0 }; ///< the last frame in which the data were looked at
  std::atomic<bool> IsOutdated{ false };   ///< their points or cells were modified
  ReadingHistory History;                  ///< history of reading the faces
  vtkWeakPointer<vtkPolyData> Living;      ///< the data; null if they are deleted
  glm::dvec3 Low, High;
  bool AreAllFinite = true;
  bool HasPolygons = true;
  bool HasVertsOrLines = false;
  bool HasStrips = false;
  bool HasGhostCells = false; ///< ghosts, which may not be drawn
  /** Corners of all triangles of the data. Null if this describes all of them. */
  std::shared_ptr<const std::vector<std::uint32_t>> Corners;
  std::uint32_t FirstCorner = 0;
  std::uint32_t CornerCount = 0;
  std::once_flag IsMeshBuilt;
  std::unique_ptr<OccluderMesh> Mesh;
  std::unique_ptr<MeshBoxes> BoxesOfMesh;
  std::once_flag ArePlanesBuilt;
  std::unique_ptr<FacePlanes> PlanesOfFaces;
  std::once_flag AreLinesRead;
  std::vector<MeshLine> LinesOfCells;
};

}

#endif
