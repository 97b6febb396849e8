/** Conversion of VTK's matrices to GLM. */
#ifndef VITRINE_SCENE_MATRICES_H
#define VITRINE_SCENE_MATRICES_H

#include "vtkMatrix4x4.h"

#include <glm/mat4x4.hpp>

namespace vitrine
{

/** Convert a matrix of VTK, stored by rows, to GLM, which stores by columns. Both multiply column vectors. */
inline glm::dmat4 MatrixOf(const double elements[16])
{
  glm::dmat4 matrix;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      matrix[column][row] = elements[4 * row + column];
    }
  }
  return matrix;
}

inline glm::dmat4 MatrixOf(vtkMatrix4x4* matrix)
{
  return MatrixOf(matrix->GetData());
}

/** Returns true if the matrix keeps parallels parallel. Only matrices set by users may fail this. */
inline bool IsAffine(const glm::dmat4& m)
{
  return m[0][3] == 0.0 && m[1][3] == 0.0 && m[2][3] == 0.0 && m[3][3] == 1.0;
}

}

#endif
