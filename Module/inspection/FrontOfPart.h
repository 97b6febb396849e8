/** Captures what is in front of parts, in each of their pixels. */
#ifndef VITRINE_INSPECTION_FRONT_OF_PART_H
#define VITRINE_INSPECTION_FRONT_OF_PART_H

#include "Core/geometry/PixelRegion.h"
#include "Core/reveal/FrontStacks.h"
#include "Core/reveal/NearStacks.h"
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

/** What is in front, and what may come together there. */
struct Fronts
{
  FrontStacks Stacks;
  std::size_t Pixels = 0;     ///< in which the parts are drawn
  NearStacks* Near = nullptr; ///< null if that does not matter
};

/**
 * Adds a stack for each sample of a rectangle's pixels in which one of `parts` is drawn: all layers of other parts that
 * are not behind its nearest layer. Opaque layers count like others, and layers of equal depth count as in front.
 */
void AddFronts(const std::vector<LayerFragment>& fragments, const PixelRegion& region,
  const PartSet& parts, Fronts& fronts);

/** Captures a rectangle in bands, and adds its stacks. Returns why it cannot, or an empty string. */
std::string CaptureFronts(LayerCapture& capture, const FrameOfRenderer& frame,
  const PixelRegion& region, const PartSet& parts, Fronts& fronts);

}

#endif
