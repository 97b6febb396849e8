#include "scene/files/GridCheck.h"

#include "scene/files/GeometryCheck.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <map>

namespace program
{

namespace
{
/** Whether a cell with some number of points along its edges has so many in all. */
template <class CountPoints>
bool IsOfSomeOrder(vtkIdType points, const CountPoints& countPoints)
{
  vtkIdType edge = 2;
  while (countPoints(edge) < points)
  {
    ++edge;
  }
  return countPoints(edge) == points;
}

vtkIdType TrianglePoints(vtkIdType n)
{
  return n * (n + 1) / 2;
}

/** Whether a cell of a kind may have so many corners, where the kind leaves it open. */
bool MayHaveCorners(int type, vtkIdType corners)
{
  switch (type)
  {
    case VTK_EMPTY_CELL:
      return corners == 0;
    case VTK_POLY_VERTEX:
      return corners >= 1;
    case VTK_POLY_LINE:
      return corners >= 2;
    case VTK_TRIANGLE_STRIP:
    case VTK_POLYGON:
      return corners >= 3;
    case VTK_QUADRATIC_POLYGON:
      return corners >= 6 && corners % 2 == 0;
    case VTK_CONVEX_POINT_SET:
    case VTK_POLYHEDRON:
      return corners >= 4;
    case VTK_LAGRANGE_CURVE:
    case VTK_BEZIER_CURVE:
      return corners >= 2;
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_BEZIER_TRIANGLE:
      return IsOfSomeOrder(corners, TrianglePoints);
    case VTK_LAGRANGE_QUADRILATERAL:
    case VTK_BEZIER_QUADRILATERAL:
      return IsOfSomeOrder(corners, [](vtkIdType n) { return n * n; });
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_BEZIER_TETRAHEDRON:
      return IsOfSomeOrder(corners, [](vtkIdType n) { return n * (n + 1) * (n + 2) / 6; });
    case VTK_LAGRANGE_HEXAHEDRON:
    case VTK_BEZIER_HEXAHEDRON:
      return IsOfSomeOrder(corners, [](vtkIdType n) { return n * n * n; });
    case VTK_LAGRANGE_WEDGE:
    case VTK_BEZIER_WEDGE:
      return IsOfSomeOrder(corners, [](vtkIdType n) { return n * TrianglePoints(n); });
    default:
      return false;
  }
}

/** The corners that each cell of a kind has, or 0 where the kind leaves it open or VTK draws no such cell. */
class FixedCorners
{
public:
  vtkIdType Of(int type)
  {
    const auto [found, isNew] = this->Known.try_emplace(type, 0);
    const bool isFixed = (type >= VTK_VERTEX && type <= VTK_HEXAGONAL_PRISM) ||
      (type >= VTK_QUADRATIC_EDGE && type <= LastQuadraticKind);
    const bool isOpen = type == VTK_POLY_VERTEX || type == VTK_POLY_LINE ||
      type == VTK_TRIANGLE_STRIP || type == VTK_POLYGON || type == VTK_QUADRATIC_POLYGON;
    if (isNew && isFixed && !isOpen)
    {
      vtkSmartPointer<vtkCell> cell;
      cell.TakeReference(vtkGenericCell::InstantiateCell(type));
      found->second = cell ? cell->GetNumberOfPoints() : 0;
    }
    return found->second;
  }

private:
  static const int LastQuadraticKind = 37; // VTK 9.1 has no name for VTK_TRIQUADRATIC_PYRAMID
  std::map<int, vtkIdType> Known;
};

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
vtkIdType CountKinds(vtkUnstructuredGrid* grid)
{
  vtkDataArray* const kinds = grid->GetCellTypes();
  return kinds ? kinds->GetNumberOfTuples() : 0;
}
#else
vtkIdType CountKinds(vtkUnstructuredGrid* grid)
{
  vtkUnsignedCharArray* const kinds = grid->GetCellTypesArray();
  return kinds ? kinds->GetNumberOfValues() : 0;
}
#endif

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
bool HasValidFaces(vtkUnstructuredGrid* grid)
{
  vtkCellArray* const faces = grid->GetPolyhedronFaces();
  vtkCellArray* const cells = grid->GetPolyhedronFaceLocations();
  return faces && cells && cells->GetNumberOfCells() == grid->GetNumberOfCells() &&
    HasValidCorners(faces, grid->GetNumberOfPoints()) &&
    HasValidCorners(cells, faces->GetNumberOfCells());
}
#else
/** A cell's faces are a stream: their number, then of each face the number of corners and the corners. */
bool HasValidFaces(vtkIdTypeArray* stream, vtkIdType begin, vtkIdType pointCount)
{
  const vtkIdType end = stream->GetNumberOfValues();
  if (begin < 0 || begin >= end)
  {
    return false;
  }
  vtkIdType at = begin + 1;
  for (vtkIdType face = 0; face < stream->GetValue(begin); ++face)
  {
    const vtkIdType corners = at < end ? stream->GetValue(at++) : -1;
    if (corners < 0 || corners > end - at)
    {
      return false;
    }
    for (const vtkIdType last = at + corners; at < last; ++at)
    {
      if (stream->GetValue(at) < 0 || stream->GetValue(at) >= pointCount)
      {
        return false;
      }
    }
  }
  return true;
}

bool HasValidFaces(vtkUnstructuredGrid* grid)
{
  vtkIdTypeArray* const stream = grid->GetFaces();
  vtkIdTypeArray* const begins = grid->GetFaceLocations();
  if (!stream || !begins || begins->GetNumberOfValues() != grid->GetNumberOfCells())
  {
    return false;
  }
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    if (grid->GetCellType(i) == VTK_POLYHEDRON &&
      !HasValidFaces(stream, begins->GetValue(i), grid->GetNumberOfPoints()))
    {
      return false;
    }
  }
  return true;
}
#endif

std::string FindCellProblem(vtkUnstructuredGrid* grid)
{
  vtkCellArray* const cells = grid->GetCells();
  const vtkIdType count = cells ? cells->GetNumberOfCells() : 0;
  if (count == 0)
  {
    return "";
  }
  if (CountKinds(grid) != count)
  {
    return "has more or fewer kinds of cells than cells";
  }
  if (!HasValidCorners(cells, grid->GetNumberOfPoints()))
  {
    return "has cells whose corners are not among its " +
      std::to_string(grid->GetNumberOfPoints()) + " points";
  }
  FixedCorners fixed;
  bool hasPolyhedra = false;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const int type = grid->GetCellType(i);
    const vtkIdType corners = cells->GetCellSize(i);
    const vtkIdType fixedCorners = fixed.Of(type);
    if (fixedCorners > 0 ? corners != fixedCorners : !MayHaveCorners(type, corners))
    {
      return "has a cell of kind " + std::to_string(type) + " with " + std::to_string(corners) +
        " corners";
    }
    hasPolyhedra |= type == VTK_POLYHEDRON;
  }
  return hasPolyhedra && !HasValidFaces(grid) ? "has polyhedra whose faces are not whole" : "";
}

bool Fills(const int dimensions[3], vtkIdType points)
{
  return static_cast<double>(dimensions[0]) * dimensions[1] * dimensions[2] == points;
}

bool FillsAxis(vtkDataArray* coordinates, int count)
{
  return coordinates && coordinates->GetNumberOfTuples() == count;
}

std::string FindDimensionProblem(vtkDataSet* grid)
{
  bool isWhole = true;
  int dimensions[3] = { 0, 0, 0 };
  if (auto* structured = vtkStructuredGrid::SafeDownCast(grid))
  {
    structured->GetDimensions(dimensions);
    isWhole =
      Fills(dimensions, structured->GetPoints() ? structured->GetPoints()->GetNumberOfPoints() : 0);
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(grid))
  {
    rectilinear->GetDimensions(dimensions);
    isWhole = FillsAxis(rectilinear->GetXCoordinates(), dimensions[0]) &&
      FillsAxis(rectilinear->GetYCoordinates(), dimensions[1]) &&
      FillsAxis(rectilinear->GetZCoordinates(), dimensions[2]);
  }
  else if (!grid->IsA("vtkImageData"))
  {
    return std::string("is a ") + grid->GetClassName() + ", which is not drawn";
  }
  return isWhole ? "" : "has more or fewer points than its dimensions say";
}
}

std::string FindGridProblem(vtkDataSet* grid)
{
  auto* const cells = vtkUnstructuredGrid::SafeDownCast(grid);
  const std::string problem = cells ? FindCellProblem(cells) : FindDimensionProblem(grid);
  if (!problem.empty())
  {
    return problem;
  }
  if (!HasMatchingArrays(grid->GetPointData(), grid->GetNumberOfPoints()))
  {
    return "has more or fewer values at its points than points";
  }
  if (!HasMatchingArrays(grid->GetCellData(), grid->GetNumberOfCells()))
  {
    return "has more or fewer values at its cells than cells";
  }
  return "";
}

bool HasVolumeCells(vtkDataSet* grid)
{
  auto* const unstructured = vtkUnstructuredGrid::SafeDownCast(grid);
  if (!unstructured)
  {
    return grid->GetNumberOfCells() > 0 && grid->GetCell(0)->GetCellDimension() == 3;
  }
  std::map<int, bool> isVolume;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    const auto [found, isNew] = isVolume.try_emplace(grid->GetCellType(i), false);
    if (isNew)
    {
      vtkSmartPointer<vtkCell> cell;
      cell.TakeReference(vtkGenericCell::InstantiateCell(found->first));
      found->second = cell && cell->GetCellDimension() == 3;
    }
  }
  return std::any_of(
    isVolume.begin(), isVolume.end(), [](const auto& kind) { return kind.second; });
}

}
