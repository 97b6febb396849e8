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

/** The planes of a part's faces, in its model coordinates. */
struct PartPlanes
{
  const FacePlanes* Planes;
  const glm::dmat4* ToWorld;
  const DeviceCoordinates* Drawn; ///< what a device computes the part's places from
  const glm::dmat4* FromWorld;
};

/** Tells what parts are, whatever they hide; asked by several threads at once. */
class ShapeSource : public OccluderSource
{
public:
  /** Of all faces that are drawn of it, be they of a mesh that OccluderOf() does not tell. */
  virtual PartPlanes PlanesOf(std::uint32_t part) = 0;

  /**
   * Whether a device draws the part at one place of a pixel, and holds it to the depth of others at another: as passes do that blend what is translucent at the centres of pixels that
   * have several samples, by the depth of any one of those.
   */
  virtual bool IsDrawnApart(std::uint32_t part) const = 0;

  /** The lines that are drawn of it. */
  virtual const std::vector<MeshLine>& LinesOf(std::uint32_t part) = 0;
};

}

#endif
