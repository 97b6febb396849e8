#include "study/faces/ScreenFaces.h"

#include "Core/culling/screen/ScreenProjection.h"
#include "study/faces/BenchmarkMeshes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <random>

namespace vitrine
{

void ScreenFaces::Project(int columns, int lines)
{
  glm::dvec3 low(1e300), high(-1e300);
  for (const glm::dvec3& point : this->Points)
  {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  const glm::dvec3 middle = 0.5 * (low + high);
  const double radius = 0.5 * glm::length(high - low);
  const glm::dmat4 look =
    glm::lookAt(middle + radius * glm::dvec3(1.4, 1.0, 1.7), middle, glm::dvec3(0.0, 1.0, 0.0));
  const double aspect = static_cast<double>(columns) / lines;
  const ScreenProjection view(
    glm::perspective(glm::radians(40.0), aspect, radius, 6 * radius) * look, columns, lines,
    glm::max(glm::abs(low), glm::abs(high)), {});
  this->OnScreen.clear();
  for (const std::uint32_t corner : this->Corners)
  {
    const glm::dvec4 place = view.ToScreen(this->Points[corner]);
    this->OnScreen.push_back({ static_cast<float>(place.x / place.w),
      static_cast<float>(place.y / place.w), static_cast<float>(place.z / place.w) });
  }
  this->Sequence.clear();
  for (std::uint32_t i = 0; i < this->Corners.size() / this->CornersPerFace; ++i)
  {
    const ScreenPoint* p = this->Face(i).Corners;
    const float turn = (p[1].Column - p[0].Column) * (p[2].Line - p[0].Line) -
      (p[2].Column - p[0].Column) * (p[1].Line - p[0].Line);
    if (turn > 0.0f)
    {
      this->Sequence.push_back(i);
    }
  }
}

void ScreenFaces::SortFrontToBack()
{
  const auto depthOf = [&](std::uint32_t i) { return this->Face(i).Corners[0].Depth; };
  std::stable_sort(this->Sequence.begin(), this->Sequence.end(),
    [&](std::uint32_t a, std::uint32_t b) { return depthOf(a) > depthOf(b); });
}

std::vector<std::uint32_t> ScreenFaces::Ends() const
{
  std::vector<std::uint32_t> ends(this->Corners.size() / this->CornersPerFace);
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    ends[i] = static_cast<std::uint32_t>((i + 1) * this->CornersPerFace);
  }
  return ends;
}

ScreenFaces TurnedBoxes()
{
  std::mt19937 random(1);
  const auto uniform = [&] { return random() / 4294967296.0; };
  const auto vector = [&]
  {
    const double x = uniform();
    const double y = uniform();
    return glm::dvec3(x, y, uniform());
  };
  ScreenFaces faces;
  faces.CornersPerFace = 4;
  for (std::uint32_t i = 0; i < 4000; ++i)
  {
    const glm::dvec3 centre = vector();
    const glm::dvec3 halfSize = 0.03 * (vector() + 0.3);
    const glm::dvec3 axis = glm::normalize(vector() - 0.5);
    const glm::dmat4 toWorld = glm::scale(
      glm::rotate(glm::translate(glm::dmat4(1.0), centre), 6.28 * uniform(), axis), halfSize);
    for (int j = 0; j < 8; ++j)
    {
      faces.Points.emplace_back(
        toWorld * glm::dvec4(j & 1 ? 1 : -1, j & 2 ? 1 : -1, j & 4 ? 1 : -1, 1));
    }
    for (const std::uint32_t corner :
      { 0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6 })
    {
      faces.Corners.push_back(8 * i + corner);
    }
  }
  return faces;
}

ScreenFaces CrossingSpheres()
{
  const BenchmarkMesh mesh(BenchmarkMesh::Kinds::Spheres, 20000);
  ScreenFaces faces;
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    faces.Points.emplace_back(mesh.Points[i], mesh.Points[i + 1], mesh.Points[i + 2]);
  }
  faces.Corners = mesh.Corners;
  // The spheres' faces are clockwise from outside.
  for (std::size_t i = 0; i < faces.Corners.size(); i += 3)
  {
    std::swap(faces.Corners[i], faces.Corners[i + 1]);
  }
  return faces;
}

}
