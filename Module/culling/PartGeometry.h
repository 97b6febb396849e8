#ifndef VITRINE_CULLING_PART_GEOMETRY_H
#define VITRINE_CULLING_PART_GEOMETRY_H

#include "Core/culling/OccluderMesh.h"

#include "vtkType.h"

#include <glm/vec3.hpp>

#include <memory>

class vtkPolyData;

namespace vitrine
{

/** What culling needs to know of a polydata; parts that show the same one share it. */
class PartGeometry
{
public:
  /** Reads the points of `data` as it is now. */
  explicit PartGeometry(vtkPolyData* data);

  /** Whether it is of `data` as it is now; looked at once a frame, whoever shares it. */
  bool IsCurrent(vtkPolyData* data, vtkMTimeType frame);

  /** Of all points, in model coordinates (MC); Least exceeds Greatest if there are none. */
  const glm::dvec3& Least() const { return this->Low; }
  const glm::dvec3& Greatest() const { return this->High; }

  /** Whether all points are numbers that floats can hold. */
  bool IsFinite() const { return this->AreAllFinite; }

  /** Whether there are vertices or lines, which are drawn wider than they are. */
  bool HasThinCells() const { return this->HasVertsOrLines; }

  /** Its triangles and convex polygons as an occluder; built when first asked for. `data` is current. */
  const OccluderMesh& Occluder(vtkPolyData* data);

private:
  vtkPolyData* Data;
  vtkMTimeType Time;
  vtkMTimeType LookedAt = 0; ///< the frame in which it was found to be current
  glm::dvec3 Low, High;
  bool AreAllFinite = true;
  bool HasVertsOrLines = false;
  std::unique_ptr<OccluderMesh> Mesh;
};

}

#endif
