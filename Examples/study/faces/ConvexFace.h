#ifndef VITRINE_STUDY_FACES_CONVEX_FACE_H
#define VITRINE_STUDY_FACES_CONVEX_FACE_H

#include "Core/culling/screen/MeshProjection.h"
#include "study/faces/FaceNeighbours.h"

#include <cstddef>
#include <cstdint>

namespace vitrine
{

/** A convex polygon on the screen. Its corners go around in either direction. */
struct ConvexFace
{
  const ScreenPoint* Corners;
  std::size_t Count;
  std::uint32_t Number; ///< Number of the face among all inserted faces.
  /** The face across each side, from corner i to the next, or null if unknown. */
  const std::uint32_t* Neighbours = nullptr;
};

}

#endif
