#ifndef VITRINE_CORE_CULLING_WALK_OCCLUDER_SOURCE_H
#define VITRINE_CORE_CULLING_WALK_OCCLUDER_SOURCE_H

#include "Core/culling/mesh/MeshBoxes.h"
#include "Core/culling/mesh/OccluderMesh.h"
#include "Core/culling/screen/DeviceCoordinates.h"

#include <glm/mat4x4.hpp>

#include <cstdint>

namespace vitrine
{

/** The mesh by which a part hides others. */
struct Occluder
{
  const OccluderMesh* Mesh = nullptr;       ///< null if the part hides nothing
  const glm::dmat4* ToWorld = nullptr;      ///< from model (MC) to world coordinates (WC)
  const DeviceCoordinates* Drawn = nullptr; ///< the coordinates that a device reads
  /** True if faces that are clockwise on the screen are drawn, too. */
  bool HasBackFaces = true;
  /** Boxes around the faces of the mesh. Null if there are none, or if more than the faces is drawn of the part. */
  const MeshBoxes* Boxes = nullptr;
  /** True if nothing but the faces of the mesh is drawn of the part. */
  bool IsOfFacesAlone = false;
};

/** Returns the occluders of parts. It is asked for parts that show and few others, by several threads at a time. */
class OccluderSource
{
public:
  virtual ~OccluderSource() = default;
  virtual Occluder OccluderOf(std::uint32_t part) = 0;

  /**
   * A hint that OccluderOf() may be called for the part soon. Sources that keep their data far apart in memory prefetch
   * it.
   */
  virtual void PrefetchOccluder(std::uint32_t part) const { static_cast<void>(part); }
};

}

#endif
