#include "lighting/forward/WorldCells.h"

#include "Core/lighting/MovedLights.h"
#include "scene/LitProps.h"
#include "scene/Matrices.h"
#include "vtkCamera.h"
#include "vtkOpenGLRenderer.h"
#include "vtkShaderProgram.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace vitrine
{

namespace
{

/** Replaces the slice law in the shader's uniform: slices follow the third axis. */
constexpr float AlongThirdAxis = 3.0f;

glm::dmat4 FromViewOf(vtkRenderer* renderer)
{
  return glm::inverse(MatrixOf(renderer->GetActiveCamera()->GetModelViewTransformMatrix()));
}

WorldGrid CubesAround(const LitProps& lit, std::uint32_t count)
{
  if (!lit.Boxes)
  {
    return { Box::Everything(), glm::ivec3(1) };
  }
  Box all;
  for (const LitBox& box : *lit.Boxes)
  {
    all.Add(box.InWorld);
  }
  const Box inView = lit.Region.Bounds();
  const float farthest = glm::length(glm::max(glm::abs(inView.Min), glm::abs(inView.Max)));
  return { all, CubesIn(all, count), farthest };
}
}

WorldCells::WorldCells(vtkOpenGLRenderer* renderer, const LitProps& lit, std::uint32_t count)
  : ToWorld(FromViewOf(renderer))
  , Grid(CubesAround(lit, count))
{
}

std::uint32_t WorldCells::Assign(LightAssigner& assigner, const LitProps& lit,
  const std::vector<LightVolume>& volumes, LightLists& lists) const
{
  std::vector<std::uint8_t> used(this->Grid.Count(), lit.Boxes ? 0 : 1);
  if (lit.Boxes)
  {
    for (const LitBox& box : *lit.Boxes)
    {
      this->Grid.AddBox(box.InWorld, used);
    }
  }
  std::vector<LightVolume> inWorld;
  MoveLights(volumes, this->ToWorld, inWorld);
  assigner.Assign(this->Grid, inWorld, lists, &used);
  return static_cast<std::uint32_t>(std::count(used.begin(), used.end(), 1));
}

int WorldCells::ClusterOf(const glm::dvec3& place) const
{
  return this->Grid.ClusterOf(glm::dvec3(this->ToWorld * glm::dvec4(place, 1.0)));
}

void WorldCells::SetUniforms(vtkShaderProgram* program) const
{
  glm::mat4 toUnit(this->Grid.ToUnit() * this->ToWorld);
  program->SetUniformMatrix4x4("vitrineToClip", glm::value_ptr(toUnit));
  const glm::vec3 cells(this->Grid.Columns(), this->Grid.Rows(), this->Grid.Slices());
  program->SetUniform3f("vitrineClusters", glm::value_ptr(cells));
  const glm::vec2 scale = 0.5f * glm::vec2(cells);
  program->SetUniform2f("vitrineTileScale", glm::value_ptr(scale));
  const glm::vec3 terms(1.0f, 0.5f * cells.z, AlongThirdAxis);
  program->SetUniform3f("vitrineSliceTerms", glm::value_ptr(terms));
}

}
