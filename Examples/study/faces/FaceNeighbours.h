#ifndef VITRINE_STUDY_FACES_FACE_NEIGHBOURS_H
#define VITRINE_STUDY_FACES_FACE_NEIGHBOURS_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** What is across a side that has no other face. */
constexpr std::uint32_t NoNeighbour = 0xffffffffu;

/**
 * Which face is across each side of a mesh's faces, by OpenMesh. Faces that do not make a surface with those before them (a third one
 * at a side, one that goes around the other way, one with fewer than three corners or a corner twice or that there is not)
 * have no neighbours.
 * @param points   how many there are
 * @param corners  points of one face after the other
 * @param ends     where in `corners` each face ends
 * @returns for each of `corners` the face across the side that goes from there to the face's next corner, or NoNeighbour
 */
std::vector<std::uint32_t> FindFaceNeighbours(std::size_t points,
  const std::vector<std::uint32_t>& corners, const std::vector<std::uint32_t>& ends);

}

#endif
