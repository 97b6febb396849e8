#ifndef VITRINE_CORE_CULLING_COVER_FEW_FACETS_COVERAGE_H
#define VITRINE_CORE_CULLING_COVER_FEW_FACETS_COVERAGE_H

#include "Core/culling/buffer/SBuffer.h"
#include "Core/culling/mesh/FewFacets.h"
#include "Core/culling/screen/MeshProjection.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace vitrine
{

/**
 * Inserts what a mesh of few facets covers into an s-buffer of samples: all facets and edges of its outline at once, and samples eight at a time.
 *
 * What lies inside of all edges of an outline is covered: seen from there each edge goes around counter-clockwise, so all together do so once at the least. That is how often triangles go around
 * it, signs counted, so one that faces the eye does. Where it also lies off all that edges pass over while a device moves their ends, that stays so. Of a convex mesh that is all of it.
 * There it is nowhere farther than the farthest of the facets that reach there, of each of which the plane is known; of a convex mesh that is the one that is seen.
 */
class FewFacetsCoverage
{
public:
  /**
   * @param projection  of a mesh that has few facets, all of it behind the near plane
   * @param facing      of the facets that count
   * @param part        whose they are
   * @param unsteady    by how much more than others the depths of each facet may be off, as of those that a device cuts (CutFaces)
   * @returns           how many pieces of facets and edges were looked at; none if their outline does not tell what is covered, as where sides are seen from their edge to the last bit of
   *                    floats: then nothing is inserted
   */
  static std::optional<std::size_t> Insert(SBuffer& buffer, const FewFacets& facets,
    const MeshProjection& projection, MeshProjection::Facing facing, std::uint32_t part,
    const FacetDepths& unsteady = {});
};

}

#endif
