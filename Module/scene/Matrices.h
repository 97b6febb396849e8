#ifndef VITRINE_SCENE_MATRICES_H
#define VITRINE_SCENE_MATRICES_H

#include "vtkMatrix4x4.h"

#include <glm/mat4x4.hpp>

namespace vitrine
{

/** VTK's matrices are kept row by row, GLM's column by column. Both multiply column vectors. */
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

/** Whether the matrix keeps parallels parallel, as all but those of users' making do. */
inline bool IsAffine(const glm::dmat4& m)
{
  return m[0][3] == 0.0 && m[1][3] == 0.0 && m[2][3] == 0.0 && m[3][3] == 1.0;
}

}

#endif
