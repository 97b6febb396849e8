#include "Core/lighting/MovedLights.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace vitrine
{

namespace
{

/** Tolerance of the elements of a rotation matrix. It is far below the tolerance of the tests with floats. */
constexpr double RotationSlack = 1e-9;

/** Returns true if a matrix preserves lengths and angles. It is false for NaN. */
bool KeepsShapes(const glm::dmat3& matrix)
{
  const glm::dmat3 difference = glm::transpose(matrix) * matrix - glm::dmat3(1.0);
  bool isSmall = true;
  for (int i = 0; i < 9; ++i)
  {
    isSmall &= std::abs(difference[i / 3][i % 3]) < RotationSlack;
  }
  return isSmall;
}

/** Returns an upper bound of the factor by which a vector gets longer. */
double LongestOf(const glm::dmat3& matrix)
{
  return std::sqrt(glm::dot(matrix[0], matrix[0]) + glm::dot(matrix[1], matrix[1]) +
    glm::dot(matrix[2], matrix[2]));
}
}

void MoveLights(const std::vector<LightVolume>& volumes, const glm::dmat4& matrix,
  std::vector<LightVolume>& moved)
{
  const glm::dmat3 linear(matrix);
  const bool keepsShapes = KeepsShapes(linear);
  const double longest = keepsShapes ? 1.0 : LongestOf(linear);
  moved.resize(volumes.size());
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    const LightVolume& volume = volumes[i];
    LightVolume& to = moved[i];
    to.Position = glm::vec3(matrix * glm::dvec4(volume.Position, 1.0));
    to.Range = static_cast<float>(volume.Range * longest);
    to.Axis = glm::vec3(linear * glm::dvec3(volume.Axis));
    to.ConeAngle = keepsShapes ? volume.ConeAngle : LightVolume().ConeAngle;
  }
}

}
