#ifndef VITRINE_CORE_CULLING_HIDDEN_BOXES_HIDDEN_H
#define VITRINE_CORE_CULLING_HIDDEN_BOXES_HIDDEN_H

#include "Core/culling/buffer/SBuffer.h"
#include "Core/culling/mesh/MeshBoxes.h"
#include "Core/culling/screen/ScreenProjection.h"

#include <glm/mat4x4.hpp>

namespace vitrine
{

/**
 * Returns true if there are boxes and all of them lie outside of the view or are hidden. Then no face of the mesh
 * shows. Descends into boxes that show, until it finds one without children.
 * @param toWorld  from model (MC) to world coordinates (WC); the sums that lead to world coordinates must not exceed
 *                 the reach of the view
 */
bool AreBoxesHidden(const MeshBoxes& boxes, const SBuffer& lines, const ScreenProjection& view,
  const glm::dmat4& toWorld);

}

#endif
