#ifndef VITRINE_CORE_CULLING_STEADY_SLIVER_DEPTH_H
#define VITRINE_CORE_CULLING_STEADY_SLIVER_DEPTH_H

#include "Core/culling/screen/MeshProjection.h"

namespace vitrine
{

/**
 * Returns the nearest depth at which a device may draw a face in the view, found in doubles. Floats tell nothing of
 * slivers. All of the mesh has to lie behind the near plane. Returns more than any depth if the face is not in the
 * view, or if nothing is known.
 */
float NearestInDoubles(const MeshProjection& projection, const MeshFace& face);

}

#endif
