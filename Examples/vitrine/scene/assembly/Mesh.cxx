#include "scene/assembly/Mesh.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyDataNormals.h"

#include <glm/vec4.hpp>

namespace program
{

namespace
{
const double SharpEdge = 40.0; // degrees

void AddCap(Mesh& mesh, int firstPoint, int count)
{
  Point middle(0.0);
  for (int i = 0; i < count; ++i)
  {
    middle += mesh.Points[firstPoint + i];
  }
  const int center = static_cast<int>(mesh.Points.size());
  mesh.Points.push_back(middle / static_cast<double>(count));
  for (int i = 0; i < count; ++i)
  {
    mesh.Triangles.push_back({ center, firstPoint + i, firstPoint + (i + 1) % count });
  }
}

void AddBand(Mesh& mesh, int loopA, int loopB, int count)
{
  for (int i = 0; i < count; ++i)
  {
    const int next = (i + 1) % count;
    mesh.Triangles.push_back({ loopA + i, loopA + next, loopB + i });
    mesh.Triangles.push_back({ loopB + i, loopA + next, loopB + next });
  }
}
}

Mesh Loft(const std::vector<Loop>& loops, Ends ends)
{
  Mesh mesh;
  for (const Loop& loop : loops)
  {
    mesh.Points.insert(mesh.Points.end(), loop.begin(), loop.end());
  }
  const int count = static_cast<int>(loops.front().size());
  const int last = static_cast<int>(loops.size()) - 1;
  for (int i = 0; i < last; ++i)
  {
    AddBand(mesh, i * count, (i + 1) * count, count);
  }
  if (ends == Ends::JOINED)
  {
    AddBand(mesh, last * count, 0, count);
  }
  else if (ends == Ends::CAPPED)
  {
    AddCap(mesh, 0, count);
    AddCap(mesh, last * count, count);
  }
  return mesh;
}

Mesh Transformed(Mesh mesh, const glm::dmat4& place)
{
  for (Point& point : mesh.Points)
  {
    point = Point(place * glm::dvec4(point, 1.0));
  }
  return mesh;
}

Mesh Joined(const std::vector<Mesh>& meshes)
{
  Mesh joined;
  for (const Mesh& mesh : meshes)
  {
    const int offset = static_cast<int>(joined.Points.size());
    joined.Points.insert(joined.Points.end(), mesh.Points.begin(), mesh.Points.end());
    for (const auto& [a, b, c] : mesh.Triangles)
    {
      joined.Triangles.push_back({ offset + a, offset + b, offset + c });
    }
  }
  return joined;
}

vtkSmartPointer<vtkPolyData> ToPolyData(const Mesh& mesh)
{
  vtkNew<vtkPoints> points;
  for (const Point& point : mesh.Points)
  {
    points->InsertNextPoint(point.x, point.y, point.z);
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& [a, b, c] : mesh.Triangles)
  {
    triangles->InsertNextCell({ a, b, c });
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->SetFeatureAngle(SharpEdge);
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

}
