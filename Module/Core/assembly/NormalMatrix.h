#ifndef VITRINE_CORE_ASSEMBLY_NORMAL_MATRIX_H
#define VITRINE_CORE_ASSEMBLY_NORMAL_MATRIX_H

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace vitrine
{

/**
 * Returns the matrix by which normals turn where points turn by `m`: the cofactors, which are the inverse transpose but
 * for a positive factor, and are defined for flat parts too.
 */
inline glm::dmat3 NormalMatrix(const glm::dmat3& m)
{
  const glm::dmat3 cofactors(
    glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  return glm::dot(m[0], cofactors[0]) < 0.0 ? -cofactors : cofactors;
}

}

#endif
