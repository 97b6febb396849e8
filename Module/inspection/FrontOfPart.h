/** Captures what is in front of parts, in each of their pixels. */
#ifndef VITRINE_INSPECTION_FRONT_OF_PART_H
#define VITRINE_INSPECTION_FRONT_OF_PART_H

#include "Core/geometry/PixelRegion.h"
#include "Core/reveal/FrontStacks.h"
#include "inspection/FrameOfRenderer.h"
#include "inspection/LayerCapture.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_set>
#include <vector>

namespace vitrine
{

/** Numbers of parts. */
using PartSet = std::unordered_set<std::uint32_t>;

/**
 * Adds a stack for each pixel of a rectangle in which one of `parts` is drawn: all layers of other parts that are not
 * behind its nearest layer. Opaque layers count like others, and layers of equal depth count as in front. In a
 * multisampled pixel, those layers count that cover a sample of the part.
 */
void AddFronts(const std::vector<LayerFragment>& fragments, std::size_t pixels,
  const PartSet& parts, FrontStacks& stacks);

/** Captures a rectangle in bands, and adds its stacks. Returns why it cannot, or an empty string. */
std::string CaptureFronts(LayerCapture& capture, const FrameOfRenderer& frame,
  const PixelRegion& region, const PartSet& parts, FrontStacks& stacks);

}

#endif
