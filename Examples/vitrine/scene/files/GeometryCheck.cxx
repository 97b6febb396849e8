#include "scene/files/GeometryCheck.h"

#include "scene/Scene.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <cmath>

namespace program
{

namespace
{
template <typename T>
bool AllFinite(const T* values, vtkIdType count)
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (!std::isfinite(values[i]))
    {
      return false;
    }
  }
  return true;
}

/** Checks a cell array in its 32-bit or 64-bit storage. */
struct CornerCheck
{
  template <typename CellState>
  bool operator()(CellState& state, vtkIdType pointCount) const
  {
    const auto* offsets = state.GetOffsets();
    const auto* corners = state.GetConnectivity();
    const vtkIdType offsetCount = offsets->GetNumberOfValues();
    for (vtkIdType i = 0; i < offsetCount; ++i)
    {
      const vtkIdType low = i == 0 ? 0 : offsets->GetValue(i - 1);
      if (offsets->GetValue(i) < low || (i == 0 && offsets->GetValue(i) != 0) ||
        offsets->GetValue(i) > corners->GetNumberOfValues())
      {
        return false;
      }
    }
    for (vtkIdType i = 0; i < corners->GetNumberOfValues(); ++i)
    {
      if (corners->GetValue(i) < 0 || corners->GetValue(i) >= pointCount)
      {
        return false;
      }
    }
    return true;
  }
};
}

bool HasValidCorners(vtkCellArray* cells, vtkIdType pointCount)
{
  return cells->Visit(CornerCheck(), pointCount);
}

bool HasMatchingArrays(vtkDataSetAttributes* data, vtkIdType count)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const vtkAbstractArray* array = data->GetAbstractArray(i);
    if (array && array->GetNumberOfTuples() != count)
    {
      return false;
    }
  }
  return true;
}

std::string FindGeometryProblem(vtkPolyData* geometry)
{
  const vtkIdType pointCount = geometry->GetNumberOfPoints();
  for (vtkCellArray* cells :
    { geometry->GetVerts(), geometry->GetLines(), geometry->GetPolys(), geometry->GetStrips() })
  {
    if (!HasValidCorners(cells, pointCount))
    {
      return "has cells whose corners are not among its " + std::to_string(pointCount) + " points";
    }
  }
  if (!HasFinitePoints(geometry))
  {
    return "has coordinates that are not finite numbers";
  }
  if (!HasMatchingArrays(geometry->GetPointData(), pointCount))
  {
    return "has more or fewer values at its points than points";
  }
  if (!HasMatchingArrays(geometry->GetCellData(), geometry->GetNumberOfCells()))
  {
    return "has more or fewer values at its cells than cells";
  }
  return "";
}

bool HasFinitePoints(vtkPolyData* geometry)
{
  vtkPoints* const points = geometry->GetPoints();
  const vtkIdType count = 3 * geometry->GetNumberOfPoints();
  switch (count > 0 ? points->GetDataType() : VTK_VOID)
  {
    case VTK_FLOAT:
      return AllFinite(static_cast<const float*>(points->GetVoidPointer(0)), count);
    case VTK_DOUBLE:
      return AllFinite(static_cast<const double*>(points->GetVoidPointer(0)), count);
    default:
      return true; // integers, or none
  }
}

bool HasDrawableCells(vtkPolyData* geometry)
{
  return CountTriangles(geometry) > 0 || geometry->GetNumberOfLines() > 0 ||
    geometry->GetNumberOfVerts() > 0;
}

}
