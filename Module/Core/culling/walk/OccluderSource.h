#ifndef VITRINE_CORE_CULLING_WALK_OCCLUDER_SOURCE_H
#define VITRINE_CORE_CULLING_WALK_OCCLUDER_SOURCE_H

#include "Core/culling/mesh/MeshBoxes.h"
#include "Core/culling/mesh/OccluderMesh.h"
#include "Core/culling/screen/DeviceCoordinates.h"

#include <glm/mat4x4.hpp>

#include <cstdint>

namespace vitrine
{

/** What a part hides with. */
struct Occluder
{
  const OccluderMesh* Mesh = nullptr;       ///< null if it hides nothing
  const glm::dmat4* ToWorld = nullptr;      ///< from the mesh's model coordinates
  const DeviceCoordinates* Drawn = nullptr; ///< what a device computes its places from
  bool HasBackFaces = true; ///< whether faces that go around clockwise on the screen are drawn, too
  const MeshBoxes* Boxes =
    nullptr; ///< around the mesh's faces; null if there are none, or if more is drawn of the part than faces
  bool IsOfFacesAlone = false; ///< whether nothing else is drawn of the part than the mesh's faces
};

/** Tells what parts hide with; asked for those that show, and few others, by several threads at once. */
class OccluderSource
{
public:
  virtual ~OccluderSource() = default;
  virtual Occluder OccluderOf(std::uint32_t part) = 0;

  /** The part may be asked for soon: a hint for those that keep what they tell far apart in memory. */
  virtual void PrefetchOccluder(std::uint32_t part) const { static_cast<void>(part); }
};

}

#endif
