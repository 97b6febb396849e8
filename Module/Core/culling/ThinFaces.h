#ifndef VITRINE_CORE_CULLING_THIN_FACES_H
#define VITRINE_CORE_CULLING_THIN_FACES_H

#include "Core/culling/MeshProjection.h"
#include "Core/culling/SampleGrid.h"

#include <cstddef>

namespace vitrine
{

/**
 * Which of up to eight faces a device may draw as slivers, at depths that they do not have: what it moves points by may be as much as such a face is thick, and there may be samples in the
 * rectangle around it. A face with a corner that is no number counts.
 * @param first    of those that the projection has
 * @param margin   of the rectangle
 * @returns        a bit for each
 */
unsigned FindThinFaces(const MeshProjection& projection, std::size_t first,
  const SampleGrid& samples, const ScreenMargin& margin);

/** How near a device may draw a face that is no thinner than that for it, in columns and lines: its depth changes by no more there than between its corners. */
float NearestOfThickness(const MeshProjection& projection, const MeshFace& face, float thickness);

}

#endif
