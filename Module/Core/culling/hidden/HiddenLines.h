#ifndef VITRINE_CORE_CULLING_HIDDEN_HIDDEN_LINES_H
#define VITRINE_CORE_CULLING_HIDDEN_HIDDEN_LINES_H

#include "Core/culling/buffer/SBuffer.h"
#include "Core/culling/screen/ScreenProjection.h"

#include <glm/vec3.hpp>

#include <vector>

namespace vitrine
{

/** A line that is drawn of a part, by its ends in model coordinates (MC). */
struct MeshLine
{
  glm::dvec3 From;
  glm::dvec3 To;
};

/**
 * Returns true if all lines are hidden wherever a device draws them. A device draws lines wider than they are, and
 * beyond their ends. There the depth goes on as it does between the ends, so it may be nearer than either. Returns
 * false if a line is seen from its end, as its depth is not known then.
 * @param toScreen  from model coordinates (MC) to the screen
 * @param growth    by how many columns and lines a line may be drawn beside itself
 */
bool AreLinesHidden(const std::vector<MeshLine>& lines, const ScreenMatrix& toScreen,
  const glm::vec2& growth, const SBuffer& buffer);

}

#endif
