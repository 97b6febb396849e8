#ifndef VITRINE_STUDY_FACES_FACE_NEIGHBOURS_H
#define VITRINE_STUDY_FACES_FACE_NEIGHBOURS_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** The neighbour across a side that has no other face. */
constexpr std::uint32_t NoNeighbour = 0xffffffffu;

/**
 * Finds the face across each side of a mesh's faces with OpenMesh. A face has no neighbours if it forms no surface with
 * the earlier faces: it is a third face at a side, or its winding is opposite. The same holds for a face with fewer
 * than three corners, with a repeated corner, or with a corner that does not exist.
 * @param points   number of points
 * @param corners  point indices, face by face
 * @param ends     end of each face in `corners`
 * @returns        for each of `corners`, the face across the side from there to the face's next corner, or NoNeighbour
 */
std::vector<std::uint32_t> FindFaceNeighbours(std::size_t points,
  const std::vector<std::uint32_t>& corners, const std::vector<std::uint32_t>& ends);

}

#endif
