#include "lighting/forward/ViewGrid.h"

#include "Core/lighting/UsedClusters.h"
#include "scene/LitProps.h"
#include "scene/ViewMatrices.h"
#include "vtkOpenGLRenderer.h"
#include "vtkShaderProgram.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <array>

namespace vitrine
{

namespace
{

// Returns the matrix from view to clip coordinates.
glm::dmat4 ToClipOf(vtkRenderer* renderer)
{
  return glm::transpose(
    glm::make_mat4(ViewMatricesOf(renderer).data() + 16)); // VTK stores matrices by row
}

std::array<int, 2> SizeOf(vtkRenderer* renderer)
{
  std::array<int, 2> size = { 1, 1 };
  renderer->GetTiledSize(&size[0], &size[1]);
  return size;
}

UsedClusters UsedBy(const LitProps& lit, const ClusterGrid& grid)
{
  UsedClusters used(grid);
  if (!lit.Boxes)
  {
    used.AddAll();
    return used;
  }
  for (const LitBox& box : *lit.Boxes)
  {
    used.AddBox(box.InView);
  }
  return used;
}
}

ViewGrid::ViewGrid(vtkOpenGLRenderer* renderer, const ClusterSettings& settings)
  : ViewGrid(ToClipOf(renderer), renderer, settings)
{
}

ViewGrid::ViewGrid(
  const glm::dmat4& toClip, vtkOpenGLRenderer* renderer, const ClusterSettings& settings)
  : ToClip(toClip)
  , Grid(toClip, SizeOf(renderer)[0], SizeOf(renderer)[1], settings)
{
}

std::uint32_t ViewGrid::Assign(LightAssigner& assigner, const LitProps& lit,
  const std::vector<LightVolume>& volumes, LightLists& lists) const
{
  const UsedClusters used = UsedBy(lit, this->Grid);
  assigner.Assign(this->Grid, volumes, lists, &used.All());
  return used.Count();
}

void ViewGrid::SetUniforms(vtkShaderProgram* program) const
{
  program->SetUniformMatrix4x4("vitrineToClip", const_cast<float*>(glm::value_ptr(this->ToClip)));
  const float clusters[3] = { static_cast<float>(this->Grid.Columns()),
    static_cast<float>(this->Grid.Rows()), static_cast<float>(this->Grid.Slices()) };
  program->SetUniform3f("vitrineClusters", clusters);
  const float scale[2] = { this->Grid.TileScale().x, this->Grid.TileScale().y };
  program->SetUniform2f("vitrineTileScale", scale);
  const float terms[3] = { this->Grid.SliceTerms().x, this->Grid.SliceTerms().y,
    static_cast<float>(this->Grid.Law()) };
  program->SetUniform3f("vitrineSliceTerms", terms);
}

}
