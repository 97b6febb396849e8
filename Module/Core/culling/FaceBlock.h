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
  /** Of the face `first` of those that a projection has, which stay there as long as this does, and those behind it. Their facings are known. */
  FaceBlock(const MeshProjection& projection, std::size_t first);

  /** A bit for each face that looks one way. */
  unsigned Facing(MeshProjection::Facing facing) const
  {
    return this->Facings[static_cast<int>(facing)];
  }

  /** A bit for each face. */
  unsigned All() const { return this->Facings[0] | this->Facings[1] | this->Facings[2]; }

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
  unsigned Facings[3] = {};
};

}

#endif
