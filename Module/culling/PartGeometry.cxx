#include "culling/PartGeometry.h"

#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArrayRange.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine
{

namespace
{

const double LargestFloat = std::numeric_limits<float>::max();

/**
 * Returns the triangles that cells are drawn as, three corners each. Returns none if a cell has a point that does not
 * exist.
 * @param firstOf  returns the place in the cell of the third point of the triangle with points i and i + 1
 */
template <class FirstOf>
std::vector<std::uint32_t> TrianglesOfCells(
  vtkPolyData* data, vtkCellArray* cells, const FirstOf& firstOf)
{
  std::vector<std::uint32_t> corners;
  const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    cell->GetCurrentCell(count, points);
    for (vtkIdType i = 1; i + 1 < count; ++i)
    {
      corners.push_back(static_cast<std::uint32_t>(points[firstOf(i)]));
      corners.push_back(static_cast<std::uint32_t>(points[i]));
      corners.push_back(static_cast<std::uint32_t>(points[i + 1]));
    }
  }
  const vtkIdType points = data->GetNumberOfPoints();
  const bool areThere = std::all_of(
    corners.begin(), corners.end(), [points](std::uint32_t corner) { return corner < points; });
  return areThere ? corners : std::vector<std::uint32_t>();
}

/** Returns the triangles of strips. Their orientation alternates. */
std::vector<std::uint32_t> TrianglesOfStrips(vtkPolyData* data)
{
  return TrianglesOfCells(data, data->GetStrips(), [](vtkIdType i) { return i - 1; });
}

/** Returns a point, or no number if it does not exist. */
glm::dvec3 PointOf(vtkPolyData* data, vtkIdType i)
{
  glm::dvec3 point(std::numeric_limits<double>::quiet_NaN());
  if (i >= 0 && i < data->GetNumberOfPoints())
  {
    data->GetPoints()->GetPoint(i, &point.x);
  }
  return point;
}

/** Returns the lines of cells, from each point to the next one. */
std::vector<MeshLine> LinesOf(vtkPolyData* data)
{
  std::vector<MeshLine> lines;
  const auto cell = vtk::TakeSmartPointer(data->GetLines()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    cell->GetCurrentCell(count, points);
    for (vtkIdType i = 1; i < count; ++i)
    {
      lines.push_back({ PointOf(data, points[i - 1]), PointOf(data, points[i]) });
    }
  }
  return lines;
}
}

std::vector<glm::dvec3> PointsOf(vtkPolyData* data)
{
  std::vector<glm::dvec3> points(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    data->GetPoints()->GetPoint(static_cast<vtkIdType>(i), &points[i].x);
  }
  return points;
}

std::vector<std::uint32_t> TrianglesOf(vtkPolyData* data)
{
  return TrianglesOfCells(data, data->GetPolys(), [](vtkIdType) { return vtkIdType{ 0 }; });
}

bool HasGhosts(vtkPolyData* data)
{
  return data->GetPointGhostArray() || data->GetCellGhostArray();
}

ShapeTimes ShapeTimesOf(vtkPolyData* data)
{
  const auto timeOf = [](vtkObject* object) { return object ? object->GetMTime() : 0; };
  return { timeOf(data->GetPoints() ? data->GetPoints()->GetData() : nullptr),
    timeOf(data->GetVerts()), timeOf(data->GetLines()), timeOf(data->GetPolys()),
    timeOf(data->GetStrips()), timeOf(data->GetPointGhostArray()),
    timeOf(data->GetCellGhostArray()) };
}

PartGeometry::PartGeometry(vtkPolyData* data, const PartGeometry* before)
  : Data(data)
  , Times(ShapeTimesOf(data))
  , Time(data->GetMTime())
  , History(before ? before->History.Changed() : ReadingHistory())
  , Living(data)
  , Low(std::numeric_limits<double>::infinity())
  , High(-std::numeric_limits<double>::infinity())
  , HasPolygons(data->GetNumberOfPolys() > 0)
  , HasVertsOrLines(data->GetNumberOfVerts() > 0 || data->GetNumberOfLines() > 0)
  , HasStrips(data->GetNumberOfStrips() > 0)
  , HasGhostCells(HasGhosts(data))
{
  if (data->GetNumberOfPoints() > 0)
  {
    this->ReadPoints(data);
  }
}

/** Finds the box of the points, and whether floats can hold them. Reads them in the type of their array. */
void PartGeometry::ReadPoints(vtkPolyData* data)
{
  const auto read = [this](auto* array)
  {
    for (const auto point : vtk::DataArrayTupleRange<3>(array))
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const double coordinate = point[axis];
        this->Low[axis] = std::min(this->Low[axis], coordinate);
        this->High[axis] = std::max(this->High[axis], coordinate);
        this->AreAllFinite = this->AreAllFinite && std::abs(coordinate) <= LargestFloat;
      }
    }
  };
  vtkDataArray* const points = data->GetPoints()->GetData();
  using Dispatcher = vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>;
  if (!Dispatcher::Execute(points, read))
  {
    read(points);
  }
}

PartGeometry::PartGeometry(vtkPolyData* data,
  std::shared_ptr<const std::vector<std::uint32_t>> corners, const OrderedRun& run)
  : Data(data)
  , Times(ShapeTimesOf(data))
  , Time(data->GetMTime())
  , Low(run.Bounds.Min)
  , High(run.Bounds.Max)
  , Corners(std::move(corners))
  , FirstCorner(3 * run.First)
  , CornerCount(3 * run.Count)
{
}

bool PartGeometry::WasOf(vtkPolyData* data) const
{
  return this->Living == data;
}

bool PartGeometry::IsCurrent(vtkPolyData* data, vtkMTimeType frame)
{
  this->LookAt(data, frame);
  return data == this->Data && !this->IsOutdated;
}

vtkMTimeType PartGeometry::TimeOf(vtkPolyData* data, vtkMTimeType frame)
{
  this->LookAt(data, frame);
  return data == this->Data ? this->Time.load() : 0;
}

/**
 * Looks at the data once a frame. The time is written last: a thread that finds the new time finds IsOutdated up to
 * date, too.
 */
void PartGeometry::LookAt(vtkPolyData* data, vtkMTimeType frame)
{
  if (data != this->Data || this->LookedAt == frame)
  {
    return;
  }
  const vtkMTimeType time = data->GetMTime();
  if (time != this->Time)
  {
    this->IsOutdated = this->IsOutdated || ShapeTimesOf(data) != this->Times;
    this->Time = time;
  }
  this->LookedAt = frame;
}

const OccluderMesh& PartGeometry::Occluder(vtkPolyData* data, vtkMTimeType frame)
{
  if (this->IsRestless(frame))
  {
    static const OccluderMesh nothing({}, {});
    return nothing;
  }
  std::call_once(this->IsMeshBuilt, [&] { this->BuildMesh(data); });
  return *this->Mesh;
}

void PartGeometry::BuildMesh(vtkPolyData* data)
{
  this->History.MarkRead();
  const MeshTriangles triangles =
    this->HasSurePolygons() ? this->TrianglesFrom(data) : MeshTriangles();
  this->Mesh = std::make_unique<OccluderMesh>(triangles.Points, triangles.Corners);
  const bool hasMany = this->Mesh->PointCount() > FewPointsOfAMesh;
  if (hasMany && this->IsOfFacesAlone())
  {
    this->BoxesOfMesh = std::make_unique<MeshBoxes>(*this->Mesh);
  }
}

const FacePlanes& PartGeometry::Planes(vtkPolyData* data)
{
  std::call_once(this->ArePlanesBuilt,
    [&]
    {
      this->History.MarkRead();
      MeshTriangles triangles = this->TrianglesFrom(data);
      const std::vector<std::uint32_t> strips =
        this->HasStrips ? TrianglesOfStrips(data) : std::vector<std::uint32_t>();
      triangles.Corners.insert(triangles.Corners.end(), strips.begin(), strips.end());
      this->PlanesOfFaces = std::make_unique<FacePlanes>(triangles.Points, triangles.Corners);
    });
  return *this->PlanesOfFaces;
}

const std::vector<MeshLine>& PartGeometry::Lines(vtkPolyData* data)
{
  if (this->HasVertsOrLines)
  {
    std::call_once(this->AreLinesRead, [&] { this->LinesOfCells = LinesOf(data); });
  }
  return this->LinesOfCells;
}

PartGeometry::MeshTriangles PartGeometry::TrianglesFrom(vtkPolyData* data) const
{
  return this->Corners ? this->TrianglesOfRun(data)
                       : MeshTriangles{ PointsOf(data), TrianglesOf(data) };
}

PartGeometry::MeshTriangles PartGeometry::TrianglesOfRun(vtkPolyData* data) const
{
  const auto first = this->Corners->begin() + this->FirstCorner;
  std::vector<std::uint32_t> used(first, first + this->CornerCount);
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  MeshTriangles triangles;
  triangles.Points.resize(used.size());
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    data->GetPoints()->GetPoint(static_cast<vtkIdType>(used[i]), &triangles.Points[i].x);
  }
  for (auto corner = first; corner != first + this->CornerCount; ++corner)
  {
    triangles.Corners.push_back(static_cast<std::uint32_t>(
      std::lower_bound(used.begin(), used.end(), *corner) - used.begin()));
  }
  return triangles;
}

}
