#include "culling/mappers/LeafParts.h"

#include "Core/culling/mesh/OrderedRuns.h"
#include "culling/PartGeometry.h"

#include "vtkActor.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <glm/common.hpp>

#include <algorithm>

namespace vitrine
{

namespace
{

/** Returns true if VTK draws the polygons of the actor as triangles of one buffer, and nothing else. */
bool IsPlainSurface(vtkActor* actor, vtkPolyDataMapper* mapper)
{
  vtkProperty* property = actor->GetProperty();
  return property->GetRepresentation() == VTK_SURFACE && !property->GetEdgeVisibility() &&
    !property->GetVertexVisibility() && !mapper->GetSelection();
}

bool HasPolygonsAlone(vtkPolyData* data)
{
  return data->GetNumberOfPolys() > 0 && data->GetNumberOfVerts() == 0 &&
    data->GetNumberOfLines() == 0 && data->GetNumberOfStrips() == 0 && !HasGhosts(data);
}

/** Three points, in the order in which VTK compares them. */
struct CornerPoints
{
  glm::dvec3 A, B, C;

  bool AreApart() const { return this->A != this->B && this->B != this->C && this->C != this->A; }

  Box Around() const
  {
    return Box::Around(
      glm::min(this->A, glm::min(this->B, this->C)), glm::max(this->A, glm::max(this->B, this->C)));
  }
};

/** Reads the triangles of a polydata. */
class TriangleReader
{
public:
  TriangleReader(vtkPolyData* data, const std::vector<std::uint32_t>& corners)
    : Points(PointsOf(data))
    , Corners(corners)
  {
  }

  std::size_t Count() const { return this->Corners.size() / 3; }

  CornerPoints operator[](std::size_t i) const
  {
    return { this->Points[this->Corners[3 * i]], this->Points[this->Corners[3 * i + 1]],
      this->Points[this->Corners[3 * i + 2]] };
  }

private:
  std::vector<glm::dvec3> Points;
  const std::vector<std::uint32_t>& Corners;
};

std::vector<OrderedRun> RunsOf(const TriangleReader& triangles)
{
  std::vector<Box> boxes(triangles.Count());
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    boxes[i] = triangles[i].Around();
  }
  return CutIntoRuns(boxes);
}

/** Returns the leaves of a polydata of polygons, or null if it has too few polygons. */
std::shared_ptr<const Leaves> LeavesOf(vtkPolyData* data)
{
  const PartGeometry whole(data);
  if (!whole.IsFinite())
  {
    return nullptr;
  }
  const auto corners = std::make_shared<const std::vector<std::uint32_t>>(TrianglesOf(data));
  const TriangleReader triangles(data, *corners);
  const std::vector<OrderedRun> runs = RunsOf(triangles);
  if (runs.size() < 2)
  {
    return nullptr;
  }
  auto leaves = std::make_shared<Leaves>();
  leaves->Farthest = glm::max(glm::abs(whole.Least()), glm::abs(whole.Greatest()));
  for (const OrderedRun& run : runs)
  {
    std::uint32_t drawn = 0;
    for (std::uint32_t i = run.First; i < run.First + run.Count; ++i)
    {
      drawn += triangles[i].AreApart();
    }
    leaves->FirstOfAll.push_back(run.First + run.Count);
    leaves->FirstOfDrawn.push_back(leaves->FirstOfDrawn.back() + drawn);
    leaves->Parts.push_back({ data, std::make_shared<PartGeometry>(data, corners, run), true });
  }
  return leaves;
}
}

/** Notes that there are other data, or that the data have changed. */
void LeafParts::LookAt(vtkPolyData* data)
{
  const ShapeTimes times = ShapeTimesOf(data);
  if (data != this->Data || times != this->Times)
  {
    this->History = this->History.Changed();
    this->Runs.reset();
  }
  else if (this->Runs)
  {
    // A new object tells callers of a change: colours may have changed.
    this->Runs = std::make_shared<const Leaves>(*this->Runs);
  }
  this->Data = data;
  this->Time = data->GetMTime();
  this->Times = times;
}

std::shared_ptr<const MapperParts> LeafParts::PartsFor(vtkActor* actor, vtkMTimeType frame)
{
  vtkPolyData* data = this->Mapper->GetInput();
  if (!data || !IsPlainSurface(actor, this->Mapper))
  {
    return nullptr;
  }
  if (data != this->Data || data->GetMTime() != this->Time)
  {
    this->LookAt(data);
  }
  if (!this->History.IsRead() && this->History.AreWorthReading(frame))
  {
    this->History.MarkRead();
    this->Runs = HasPolygonsAlone(data) ? LeavesOf(data) : nullptr;
  }
  return this->Runs;
}

}
