#ifndef VITRINE_STUDY_FACES_CONVEX_FACE_H
#define VITRINE_STUDY_FACES_CONVEX_FACE_H

#include "Core/culling/screen/MeshProjection.h"
#include "study/faces/FaceNeighbours.h"

#include <cstddef>
#include <cstdint>

namespace vitrine
{

/** A convex polygon on the screen; its corners go around in either direction. */
struct ConvexFace
{
  const ScreenPoint* Corners;
  std::size_t Count;
  std::uint32_t Number; ///< its own among all that are inserted
  const std::uint32_t* Neighbours =
    nullptr; ///< the face across each side, from corner i to the next, where it is known
};

}

#endif
