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
 * Which faces of a mesh on the screen may have samples: of parts of many faces most lie between them, and nothing is drawn of those. Between which columns and lines of samples each
 * point is, wherever a device draws it, is found once for all of its faces; then a face takes three looks.
 */
class SampledFaces
{
public:
  /**
   * @param projection  stays as it is as long as faces are asked for
   * @param growth      by which faces are drawn wider
   */
  void Begin(const MeshProjection& projection, const SampleGrid& samples, const glm::vec2& growth);

  /** Adds the numbers of those to a list that may have samples, of all faces from `first` up to before `end`. */
  void Add(std::size_t first, std::size_t end, std::vector<std::uint32_t>& to) const;

  /** The same of faces whose numbers are in a list. */
  void Add(const std::vector<std::uint32_t>& faces, std::vector<std::uint32_t>& to) const;

private:
  /** How many columns and lines of samples come before a point, each followed by the negative of how many do if it is drawn as far beyond it as it may be. */
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
