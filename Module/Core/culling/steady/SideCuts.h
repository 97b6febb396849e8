#ifndef VITRINE_CORE_CULLING_STEADY_SIDE_CUTS_H
#define VITRINE_CORE_CULLING_STEADY_SIDE_CUTS_H

#include "Core/culling/screen/MeshProjection.h"
#include "Core/culling/steady/FaceBlock.h"
#include "Core/culling/steady/FaceSlopes.h"
#include "Core/culling/steady/ViewCuts.h"
#include "Core/geometry/Lanes.h"

#include <array>

namespace vitrine
{

/**
 * How far off their planes a device may draw faces that one side of the view cuts, eight at a time: what CutFaces finds of each, or more, in a fraction of the time. What is left of such a face has four corners
 * or three, and each triangle of those a share of its area, which where the side cuts two of its edges tells.
 */
class SideCuts
{
public:
  /** Of a mesh that is projected, and stays so while faces of it are asked for. */
  explicit SideCuts(const MeshProjection& projection)
    : Projection(projection)
    , OfCuts(RoundingWhereCut(projection.View()))
  {
  }

  /** Of each face of a block; AnyDepth where this does not tell it: of those that are cut elsewhere, too, and those with a corner close to the side. */
  std::array<float, LaneCount> UnsteadyOf(const FaceBlock& faces) const;

private:
  const MeshProjection& Projection;
  ScreenRounding OfCuts;
};

}

#endif
