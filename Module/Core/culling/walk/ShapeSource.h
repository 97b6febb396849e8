#ifndef VITRINE_CORE_CULLING_WALK_SHAPE_SOURCE_H
#define VITRINE_CORE_CULLING_WALK_SHAPE_SOURCE_H

#include "Core/culling/hidden/HiddenLines.h"
#include "Core/culling/steady/FacePlanes.h"
#include "Core/culling/walk/OccluderSource.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <vector>

namespace vitrine
{

/** The planes of the faces of a part, in model coordinates (MC). */
struct PartPlanes
{
  const FacePlanes* Planes;
  const glm::dmat4* ToWorld;
  const DeviceCoordinates* Drawn; ///< the coordinates that a device reads
  const glm::dmat4* FromWorld;
};

/** Returns the geometry of parts, whether they hide others or not. It is asked by several threads at a time. */
class ShapeSource : public OccluderSource
{
public:
  /** Returns the planes of all faces that are drawn of the part, even if OccluderOf() returns no mesh. */
  virtual PartPlanes PlanesOf(std::uint32_t part) = 0;

  /**
   * Returns true if a device draws the part at one place of a pixel but tests it against the depth at another one.
   * Passes do so that blend translucent parts at the centres of pixels with several samples, against the depth of any
   * sample.
   */
  virtual bool IsDrawnApart(std::uint32_t part) const = 0;

  /** Returns the lines that are drawn of the part. */
  virtual const std::vector<MeshLine>& LinesOf(std::uint32_t part) = 0;
};

}

#endif
