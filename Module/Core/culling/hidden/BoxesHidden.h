#ifndef VITRINE_CORE_CULLING_HIDDEN_BOXES_HIDDEN_H
#define VITRINE_CORE_CULLING_HIDDEN_BOXES_HIDDEN_H

#include "Core/culling/buffer/SBuffer.h"
#include "Core/culling/mesh/MeshBoxes.h"
#include "Core/culling/screen/ScreenProjection.h"

#include <glm/mat4x4.hpp>

namespace vitrine
{

/**
 * Whether there are boxes, and all lie outside of the view or are hidden: then no face of their mesh shows. Looks into boxes that
 * show, until one shows that has none in it.
 * @param toWorld  of the mesh's model coordinates; the sums that lead to the world from there are no larger than the view's reach
 */
bool AreBoxesHidden(const MeshBoxes& boxes, const SBuffer& lines, const ScreenProjection& view,
  const glm::dmat4& toWorld);

}

#endif
