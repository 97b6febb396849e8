/** What all ranks must have in common to draw one frame together. */
#ifndef VITRINE_TRANSPARENCY_RANKS_FRAME_FACTS_H
#define VITRINE_TRANSPARENCY_RANKS_FRAME_FACTS_H

#include "Core/ranks/Message.h"
#include "gl/RenderTarget.h"
#include "scene/ViewMatrices.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkRenderer;

namespace vitrine
{

/** The facts of one rank. They are told among ranks as bytes. */
struct FrameFacts
{
  int Width = 0;
  int Height = 0;
  PixelRegion Region;
  int Samples = 0;
  unsigned int ColorFormat = 0;
  unsigned int DepthFormat = 0;
  int ColorStorage = 0;
  int PictureRank = 0;
  double ToleranceSteps = 0.0;
  double ToleranceSlope = 0.0;
  ViewMatrices Matrices{};
  std::uint64_t Look = 0; ///< LookOf() the renderer.
};

/** Returns a number that tells the lights and the colours of the background of renderers apart. */
std::uint64_t LookOf(vtkRenderer* renderer);

/**
 * Compares the facts of all ranks with those of rank 0. Returns what differs first and how to mend it, or an empty
 * string.
 */
std::string FindDifference(const std::vector<Message>& factsOfRanks);

}
#endif
