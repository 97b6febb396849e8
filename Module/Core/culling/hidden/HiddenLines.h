#ifndef VITRINE_CORE_CULLING_HIDDEN_HIDDEN_LINES_H
#define VITRINE_CORE_CULLING_HIDDEN_HIDDEN_LINES_H

#include "Core/culling/buffer/SBuffer.h"
#include "Core/culling/screen/ScreenProjection.h"

#include <glm/vec3.hpp>

#include <vector>

namespace vitrine
{

/** A line that is drawn of a part: its ends, in model coordinates (MC). */
struct MeshLine
{
  glm::dvec3 From;
  glm::dvec3 To;
};

/**
 * Whether all lines are hidden wherever a device draws them. They are drawn wider than they are, and beyond their ends, too: there their depth goes on as it does between them, so that it may be
 * nearer than either. Of lines that are seen from their end nothing is known.
 * @param toScreen  of their model coordinates
 * @param growth    by how many columns and lines of the screen they may be drawn beside themselves
 */
bool AreLinesHidden(const std::vector<MeshLine>& lines, const ScreenMatrix& toScreen,
  const glm::vec2& growth, const SBuffer& buffer);

}

#endif
