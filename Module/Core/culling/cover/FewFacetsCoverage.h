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
 * Inserts what a mesh of few facets covers into an s-buffer of samples. It handles all facets and all edges of the
 * outline at once, and eight samples at a time.
 *
 * A place inside of all outline edges is covered. Seen from there each edge turns counter-clockwise, so all edges
 * together turn around it at least once. The triangles turn around it as often, counted with signs, so at least one
 * that faces the eye covers it. This stays so while a device moves the ends of edges, if the place is off all that the
 * edges sweep. For a convex mesh, this is all that it covers.
 *
 * The depth at the place is no farther than the farthest facet that reaches there. The planes of these facets are
 * known. For a convex mesh this facet is the one that is seen.
 */
class FewFacetsCoverage
{
public:
  /**
   * Inserts the facets of one facing.
   * @param projection  the projection of a mesh of few facets, all of it behind the near plane
   * @param facing      the facets that count
   * @param part        the number of the part, which samples keep
   * @param unsteady    by how much more the depths of each facet may be off, if a device cuts it (CutFaces)
   * @returns           the number of pieces of facets and edges, as a cost. Returns nothing if the outline does not
   *                    tell what is covered, as for sides that are exactly edge-on in floats. Then nothing is inserted.
   */
  static std::optional<std::size_t> Insert(SBuffer& buffer, const FewFacets& facets,
    const MeshProjection& projection, MeshProjection::Facing facing, std::uint32_t part,
    const FacetDepths& unsteady = {});
};

}

#endif
