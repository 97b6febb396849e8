#ifndef VITRINE_CORE_CULLING_STEADY_SLIVER_DEPTH_H
#define VITRINE_CORE_CULLING_STEADY_SLIVER_DEPTH_H

#include "Core/culling/screen/MeshProjection.h"

namespace vitrine
{

/**
 * How near a device may draw a face that lies in the view, whatever our floats round of it: of slivers these tell nothing that are known in doubles. All of the mesh has to lie behind the near plane.
 * More than any depth where nothing is known.
 */
float NearestInDoubles(const MeshProjection& projection, const MeshFace& face);

}

#endif
