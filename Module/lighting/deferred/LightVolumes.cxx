#include "lighting/deferred/LightVolumes.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/common.hpp>

namespace vitrine
{

namespace
{

// Returns the start of a tile in NDC of the viewport. The last tile ends with the viewport.
glm::dvec2 BeginOf(const glm::ivec2& tile, const ClusterGrid& grid)
{
  return glm::min(glm::dvec2(tile) / glm::dvec2(grid.TileScale()) - 1.0, 1.0);
}
}

void MakeLightVolumes(
  const ClusterGrid& grid, const std::vector<LightRectangle>& rectangles, vtkPolyData* volumes)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  for (const LightRectangle& rectangle : rectangles)
  {
    const glm::dvec2 low = BeginOf(rectangle.First, grid);
    const glm::dvec2 high = BeginOf(rectangle.Last + 1, grid);
    const vtkIdType first = points->GetNumberOfPoints();
    const auto number = static_cast<double>(first / 4);
    points->InsertNextPoint(low.x, low.y, number);
    points->InsertNextPoint(high.x, low.y, number);
    points->InsertNextPoint(high.x, high.y, number);
    points->InsertNextPoint(low.x, high.y, number);
    triangles->InsertNextCell({ first, first + 1, first + 2 });
    triangles->InsertNextCell({ first, first + 2, first + 3 });
  }
  volumes->SetPoints(points);
  volumes->SetPolys(triangles);
}

}
