#ifndef VITRINE_CORE_CULLING_STEADY_FACE_BLOCK_H
#define VITRINE_CORE_CULLING_STEADY_FACE_BLOCK_H

#include "Core/culling/screen/MeshProjection.h"
#include "Core/geometry/Lanes.h"
#include "Core/geometry/ScreenRectangle.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Where up to eight faces of a mesh are on the screen: most often close together, so that what hides one hides all of them.
 */
class FaceBlock
{
public:
  /**
   * @param projection  has the faces, which stay there as long as this does
   * @param faces       the numbers of some
   * @param first       of those it takes this one, and up to seven behind it
   */
  FaceBlock(
    const MeshProjection& projection, const std::vector<std::uint32_t>& faces, std::size_t first);

  /** A bit for each face that may have samples, where faces are drawn farther by so much. */
  unsigned MayHaveAny(const SampleGrid& samples, const glm::vec2& growth) const;

  /** A bit for each face. */
  unsigned All() const { return (1u << this->Count) - 1u; }

  const MeshFace& Face(int lane) const { return *this->Faces[lane]; }

  /** To eight faces: where the block has fewer, to the last one again. */
  const MeshFace* const* Pointers() const { return this->Faces; }

  /** Has one of the faces be no nearer than that. */
  void LimitNearest(int lane, float nearest)
  {
    this->Nearest[lane] = std::min(this->Nearest[lane], nearest);
  }

  /** Has depths of one of the faces be off by more. */
  void Unsettle(int lane, float depth)
  {
    this->UnsteadyBy[lane] = depth;
    this->Nearest[lane] += depth;
  }

  /** That. */
  float Unsteady(int lane) const { return this->UnsteadyBy[lane]; }

  /**
   * Around one of the faces, margin included, and the nearest depth at which a device may draw it. It is everywhere and hidden by nothing if it is not finite.
   */
  ScreenRectangle RectangleOf(int lane) const
  {
    return { this->Left[lane], this->Right[lane], this->Bottom[lane], this->Top[lane],
      this->Nearest[lane] };
  }

  /**
   * Around all of some of them, and nowhere if there are none.
   * @param faces  a bit for each
   */
  ScreenRectangle RectangleAround(unsigned faces) const;

private:
  void Find(const MeshProjection& projection);

  float Left[LaneCount], Right[LaneCount], Bottom[LaneCount], Top[LaneCount], Nearest[LaneCount];
  float UnsteadyBy[LaneCount] = {};
  const MeshFace* Faces[LaneCount];
  int Count;
};

}

#endif
