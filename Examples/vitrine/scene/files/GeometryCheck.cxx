#include "scene/files/GeometryCheck.h"

#include "scene/Scene.h"

#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArrayRange.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
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

/** Checks where cells begin, and their corners, in arrays of any kind. */
struct CornerCheck
{
  template <typename OffsetArray, typename CornerArray>
  void operator()(OffsetArray* offsetArray, CornerArray* cornerArray, vtkIdType pointCount)
  {
    const auto offsets = vtk::DataArrayValueRange<1>(offsetArray);
    const auto corners = vtk::DataArrayValueRange<1>(cornerArray);
    vtkIdType low = 0;
    bool isFirst = true;
    for (const auto value : offsets)
    {
      const auto offset = static_cast<vtkIdType>(value);
      if (offset < low || (isFirst && offset != 0) || offset > corners.size())
      {
        return;
      }
      low = offset;
      isFirst = false;
    }
    this->IsValid = std::all_of(corners.begin(), corners.end(),
      [pointCount](auto value)
      {
        const auto corner = static_cast<vtkIdType>(value);
        return corner >= 0 && corner < pointCount;
      });
  }

  bool IsValid = false;
};
}

bool HasValidCorners(vtkCellArray* cells, vtkIdType pointCount)
{
  vtkDataArray* const offsets = cells->GetOffsetsArray();
  vtkDataArray* const corners = cells->GetConnectivityArray();
  CornerCheck check;
  if (!vtkArrayDispatch::Dispatch2BySameValueType<vtkArrayDispatch::Integrals>::Execute(
        offsets, corners, check, pointCount))
  {
    check(offsets, corners, pointCount);
  }
  return check.IsValid;
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
