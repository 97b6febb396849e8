#ifndef VITRINE_CORE_CULLING_HIDDEN_SAMPLED_FACES_H
#define VITRINE_CORE_CULLING_HIDDEN_SAMPLED_FACES_H

#include "Core/culling/screen/MeshProjection.h"
#include "Core/geometry/Lanes.h"
#include "Core/geometry/SampleGrid.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Finds the faces of a mesh that may have samples. Most faces of a part with many faces lie between samples, so that
 * nothing is drawn of them.
 *
 * The columns and lines of samples before each point are counted once, wherever a device draws the point. Then a face
 * takes three look-ups.
 */
class SampledFaces
{
public:
  /**
   * @param projection  must not change while faces are added
   * @param growth      by how many columns and lines faces are drawn wider
   */
  void Begin(const MeshProjection& projection, const SampleGrid& samples, const glm::vec2& growth);

  /** Appends the faces that may have samples to a list, among the faces from `first` up to before `end`. */
  void Add(std::size_t first, std::size_t end, std::vector<std::uint32_t>& to) const;

  /** Appends those of some faces that may have samples to a list. */
  void Add(const std::vector<std::uint32_t>& faces, std::vector<std::uint32_t>& to) const;

private:
  /**
   * Four counts: the columns of samples before the leftmost place of a point, the negative of the number before its
   * rightmost place, and the same for lines.
   */
  struct Counts
  {
    HalfMask All;
  };

  VITRINE_INLINE bool MayHaveAny(const MeshFace& face) const;

  const MeshProjection* Projection = nullptr;
  std::vector<Counts> Points;
};

}

#endif
