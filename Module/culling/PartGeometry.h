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

/** The triangles that VTK draws polygons as, three corners each: a fan around the first point. None if a polygon has points that are not there. */
std::vector<std::uint32_t> TrianglesOf(vtkPolyData* data);

/** Whether there are ghost cells or points, which may or may not be drawn. */
bool HasGhosts(vtkPolyData* data);

/** When points, each kind of cells, and ghosts were modified, or others came in their place. As VTK's buffers, which alone are drawn, these tell nothing of a polydata that was modified in any other way. */
using ShapeTimes = std::array<vtkMTimeType, 7>;
ShapeTimes ShapeTimesOf(vtkPolyData* data);

/** What culling needs to know of a polydata, or of some of its triangles; parts that show the same one share it. */
class PartGeometry
{
public:
  /**
   * Reads the points of `data` as it is now.
   * @param before  what was shown in place of it, if that is known: these data before they changed, or others
   */
  explicit PartGeometry(vtkPolyData* data, const PartGeometry* before = nullptr);

  /** Knows a run of the triangles of `data`, which has finite points and polygons alone. */
  PartGeometry(vtkPolyData* data, std::shared_ptr<const std::vector<std::uint32_t>> corners,
    const OrderedRun& run);

  /** Whether it was of `data`, as they are now or before they changed: others may have come to be at the address of data that are gone. */
  bool WasOf(vtkPolyData* data) const;

  /**
   * Whether it is of what `data` has drawn now: the points and cells that a device has, which it is given when those themselves were modified. Looked at once a frame, whoever shares it.
   * Several threads may ask.
   */
  bool IsCurrent(vtkPolyData* data, vtkMTimeType frame);

  /** When `data`, if it is of those, was modified in any way; likewise. */
  vtkMTimeType TimeOf(vtkPolyData* data, vtkMTimeType frame);

  /** Whether its data change so often that its faces are not read in a frame: then Occluder() has none, and Planes() are not to be asked for. Several threads may ask. */
  bool IsRestless(vtkMTimeType frame) { return !this->History.AreWorthReading(frame); }

  /** Of all points, in model coordinates (MC); Least exceeds Greatest if there are none. */
  const glm::dvec3& Least() const { return this->Low; }
  const glm::dvec3& Greatest() const { return this->High; }

  /** Whether all points are numbers that floats can hold. */
  bool IsFinite() const { return this->AreAllFinite; }

  /** Whether there are vertices or lines, which are drawn wider than they are. */
  bool HasThinCells() const { return this->HasVertsOrLines; }

  /** Whether there are polygons, all of which are sure to be drawn. Otherwise Occluder() has none. */
  bool HasSurePolygons() const { return this->HasPolygons && !this->HasGhostCells; }

  /** Whether nothing but polygons is drawn. */
  bool IsOfFacesAlone() const { return !this->HasVertsOrLines && !this->HasStrips; }

  /** The planes of its polygons and strips; read when first asked for, by whichever of several threads. `data` is current. */
  const FacePlanes& Planes(vtkPolyData* data);

  /** The lines of its cells; likewise. */
  const std::vector<MeshLine>& Lines(vtkPolyData* data);

  /** Its triangles and convex polygons as an occluder; built when first asked for, by whichever of several threads. `data` is current. */
  const OccluderMesh& Occluder(vtkPolyData* data, vtkMTimeType frame);

  /** Around the faces of the occluder, once that is built; null if they are few, or if more is drawn than them. */
  const MeshBoxes* Boxes() const { return this->BoxesOfMesh.get(); }

private:
  struct MeshTriangles
  {
    std::vector<glm::dvec3> Points;
    std::vector<std::uint32_t> Corners; ///< three of each
  };

  void LookAt(vtkPolyData* data, vtkMTimeType frame);
  void ReadPoints(vtkPolyData* data);
  void BuildMesh(vtkPolyData* data);
  MeshTriangles TrianglesFrom(vtkPolyData* data) const;
  MeshTriangles TrianglesOfRun(vtkPolyData* data) const;

  vtkPolyData* Data;
  ShapeTimes Times;
  std::atomic<vtkMTimeType> Time;          ///< of all of the data
  std::atomic<vtkMTimeType> LookedAt{ 0 }; ///< the last frame in which it was
  std::atomic<bool> IsOutdated{ false };   ///< whether their points or cells were modified
  ReadingHistory History;                  ///< of its faces
  vtkWeakPointer<vtkPolyData> Living;      ///< the data; null once they are gone
  glm::dvec3 Low, High;
  bool AreAllFinite = true;
  bool HasPolygons = true;
  bool HasVertsOrLines = false;
  bool HasStrips = false;
  bool HasGhostCells = false; ///< which may not be drawn
  std::shared_ptr<const std::vector<std::uint32_t>>
    Corners; ///< of all triangles; null if it knows all of them
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
