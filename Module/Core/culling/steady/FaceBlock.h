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
 * The rectangles of up to eight faces of a mesh. Most often the faces are close together, so that what hides one hides
 * all.
 */
class FaceBlock
{
public:
  /**
   * @param projection  must outlive the block
   * @param faces       numbers of faces
   * @param first       index of the first face of the block; up to seven more follow
   */
  FaceBlock(
    const MeshProjection& projection, const std::vector<std::uint32_t>& faces, std::size_t first);

  /**
   * Returns a bit for each face that may have samples.
   * @param growth  by how many columns and lines faces are drawn wider
   */
  unsigned MayHaveAny(const SampleGrid& samples, const glm::vec2& growth) const;

  /** Returns a bit for each face of the block. */
  unsigned All() const { return (1u << this->Count) - 1u; }

  const MeshFace& Face(int lane) const { return *this->Faces[lane]; }

  /** Pointers to eight faces. If the block has fewer, the last one is repeated. */
  const MeshFace* const* Pointers() const { return this->Faces; }

  /** Lets one face be no nearer than `nearest`. */
  void LimitNearest(int lane, float nearest)
  {
    this->Nearest[lane] = std::min(this->Nearest[lane], nearest);
  }

  /** Lets the depths of one face be off by `depth` more. */
  void Unsettle(int lane, float depth)
  {
    this->UnsteadyBy[lane] = depth;
    this->Nearest[lane] += depth;
  }

  /** Returns the depth that was given to Unsettle(), or 0. */
  float Unsteady(int lane) const { return this->UnsteadyBy[lane]; }

  /**
   * Returns the rectangle of one face, margin included, and the nearest depth at which a device may draw it. A face
   * that is not finite may be everywhere, and nothing hides it.
   */
  ScreenRectangle RectangleOf(int lane) const
  {
    return { this->Left[lane], this->Right[lane], this->Bottom[lane], this->Top[lane],
      this->Nearest[lane] };
  }

  /**
   * Returns the rectangle around some faces. It is empty if there are none.
   * @param faces  a bit for each face
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
