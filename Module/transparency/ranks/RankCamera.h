/** One camera for all ranks. */
#ifndef VITRINE_TRANSPARENCY_RANKS_RANK_CAMERA_H
#define VITRINE_TRANSPARENCY_RANKS_RANK_CAMERA_H

#include <array>

class vtkRenderer;

namespace vitrine
{

class RankExchange;

/** Bounds in world coordinates, as VTK has them. */
using Bounds = std::array<double, 6>;

/** Returns the bounds of the visible props of all ranks' renderers. Collective. */
Bounds BoundsOfRanks(RankExchange& ranks, vtkRenderer* renderer);

/** Gives the camera of rank 0 to the renderers of all ranks, with a clipping range that holds `bounds`. Collective. */
void ShareCamera(RankExchange& ranks, vtkRenderer* renderer, const Bounds& bounds);

}
#endif
