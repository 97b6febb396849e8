#include "scene/PartTriangles.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace vitrine
{

namespace
{

std::uint32_t PointNumber(vtkIdType point)
{
  const bool fits = point >= 0 && point < static_cast<vtkIdType>(VTK_UNSIGNED_INT_MAX);
  return fits ? static_cast<std::uint32_t>(point) : VTK_UNSIGNED_INT_MAX;
}

// Several threads may read the same cells by a list of each.
template <class Visit>
void ForEachCell(vtkCellArray* cells, const Visit& visit)
{
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cells && cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, points);
    visit(points->GetNumberOfIds(), points->GetPointer(0));
  }
}

}

PartTriangles ReadTriangles(vtkPolyData* geometry)
{
  PartTriangles triangles;
  vtkPoints* const points = geometry->GetPoints();
  const vtkIdType count = points ? points->GetNumberOfPoints() : 0;
  triangles.Points.resize(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->GetPoint(i, &triangles.Points[static_cast<std::size_t>(i)].x);
  }
  vtkIdType cell = geometry->GetNumberOfVerts() + geometry->GetNumberOfLines();
  const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c)
  {
    triangles.Corners.insert(
      triangles.Corners.end(), { PointNumber(a), PointNumber(b), PointNumber(c) });
    triangles.Cells.push_back(cell);
  };
  ForEachCell(geometry->GetPolys(),
    [&](vtkIdType size, const vtkIdType* ids)
    {
      for (vtkIdType i = 2; i < size; ++i)
      {
        add(ids[0], ids[i - 1], ids[i]);
      }
      ++cell;
    });
  ForEachCell(geometry->GetStrips(),
    [&](vtkIdType size, const vtkIdType* ids)
    {
      for (vtkIdType i = 2; i < size; ++i)
      {
        add(ids[i - 2], ids[i % 2 == 0 ? i - 1 : i], ids[i % 2 == 0 ? i : i - 1]);
      }
      ++cell;
    });
  return triangles;
}

}
