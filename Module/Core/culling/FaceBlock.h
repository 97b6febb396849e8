#ifndef VITRINE_CORE_CULLING_FACE_BLOCK_H
#define VITRINE_CORE_CULLING_FACE_BLOCK_H

#include "Core/culling/Lanes.h"
#include "Core/culling/MeshProjection.h"
#include "Core/culling/SBuffer.h"

#include <cstddef>

namespace vitrine
{

/**
 * Where up to eight faces of a mesh that follow one another are on the screen: most often close together, so that what hides one hides all of them.
 */
class FaceBlock
{
public:
  /** Of the face `first` of those that a projection has, which stay there as long as this does, and those behind it. */
  FaceBlock(const MeshProjection& projection, std::size_t first);

  /** A bit for each face that looks one way, as the projection knows of all. */
  unsigned Facing(const MeshProjection& projection, MeshProjection::Facing facing) const;

  /** A bit for each face. */
  unsigned All() const { return (1u << this->Count) - 1u; }

  const MeshFace& Face(int lane) const { return *this->Faces[lane]; }

  /**
   * Around one of the faces, margin included, and the nearest depth at which a device may draw it. It is everywhere and hidden by nothing if it is not finite.
   */
  ScreenRectangle At(int lane) const
  {
    return { this->Left[lane], this->Right[lane], this->Bottom[lane], this->Top[lane],
      this->Nearest[lane] };
  }

  /**
   * Around all of some of them, and nowhere if there are none.
   * @param faces  a bit for each
   */
  ScreenRectangle Around(unsigned faces) const;

private:
  void Find(const MeshProjection& projection);

  float Left[LaneCount], Right[LaneCount], Bottom[LaneCount], Top[LaneCount], Nearest[LaneCount];
  const MeshFace* Faces[LaneCount];
  std::size_t First;
  int Count;
};

}

#endif
