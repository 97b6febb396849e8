#include "assembly/PlacedGeometry.h"

#include "Core/assembly/NormalMatrix.h"
#include "assembly/PartPoints.h"
#include "vtkBoundingBox.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
glm::dmat4 MatrixOf(vtkMatrix4x4* matrix)
{
  return glm::transpose(glm::make_mat4(matrix->GetData()));
}

/** Applies a function to each vector of an array, whose components after the third are kept. */
template <class Array = vtkFloatArray, class Change>
vtkSmartPointer<Array> ChangeVectors(vtkDataArray* array, const Change& change)
{
  using Number = typename Array::ValueType;
  auto changed = vtkSmartPointer<Array>::New();
  changed->DeepCopy(array);
  const int components = changed->GetNumberOfComponents();
  Number* vector = changed->GetPointer(0);
  for (vtkIdType i = 0; i < changed->GetNumberOfTuples(); ++i, vector += components)
  {
    const glm::dvec3 to = change(glm::dvec3(vector[0], vector[1], vector[2]));
    std::copy_n(glm::value_ptr(glm::vec<3, Number>(to)), 3, vector);
  }
  return changed;
}

glm::dvec3 Normalized(const glm::dvec3& vector)
{
  const double length = glm::length(vector);
  return length > 0.0 ? vector / length : vector;
}

void PlaceVectors(const glm::dmat3& linear, vtkPointData* data)
{
  if (vtkDataArray* const normals = data->GetNormals())
  {
    const glm::dmat3 turn = vitrine::NormalMatrix(linear);
    data->SetNormals(
      ChangeVectors(normals, [&](const glm::dvec3& normal) { return Normalized(turn * normal); }));
  }
  if (vtkDataArray* const tangents = data->GetTangents())
  {
    data->SetTangents(ChangeVectors(
      tangents, [&](const glm::dvec3& tangent) { return Normalized(linear * tangent); }));
  }
}

bool IsMirrored(const glm::dmat4& matrix)
{
  return glm::determinant(glm::dmat3(matrix)) < 0.0;
}

vtkSmartPointer<vtkPolyData> ReverseCells(vtkPolyData* geometry)
{
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputData(geometry);
  reverse->ReverseCellsOn();
  reverse->ReverseNormalsOff();
  reverse->Update();
  return reverse->GetOutput();
}
}

namespace vitrine
{

bool IsFarForItsSize(vtkPolyData* geometry, vtkMatrix4x4* place)
{
  const double finest = 1e-4; // of the part's size
  if (!place)
  {
    return false;
  }
  const vtkBoundingBox box(geometry->GetBounds());
  double center[4] = { 0.0, 0.0, 0.0, 1.0 };
  box.GetCenter(center);
  double world[4];
  place->MultiplyPoint(center, world);
  const double farthest = std::max({ std::abs(world[0]), std::abs(world[1]), std::abs(world[2]) });
  const double size = std::cbrt(std::abs(place->Determinant())) * box.GetDiagonalLength();
  return size > 0.0 && farthest * std::numeric_limits<float>::epsilon() > finest * size;
}

vtkSmartPointer<vtkPolyData> PlaceGeometry(vtkPolyData* geometry, vtkMatrix4x4* place)
{
  auto placed = vtkSmartPointer<vtkPolyData>::New();
  placed->ShallowCopy(geometry);
  if (!place)
  {
    return placed;
  }
  const glm::dmat4 matrix = MatrixOf(place);
  const auto placePoint = [&matrix](const glm::dvec3& point)
  { return glm::dvec3(matrix * glm::dvec4(point, 1.0)); };
  vtkDataArray* const from = geometry->GetPoints()->GetData();
  vtkNew<PartPoints> points;
  if (IsFarForItsSize(geometry, place))
  {
    points->SetData(ChangeVectors<vtkDoubleArray>(from, placePoint));
  }
  else
  {
    points->SetData(ChangeVectors(from, placePoint));
  }
  placed->SetPoints(points);
  PlaceVectors(glm::dmat3(matrix), placed->GetPointData());
  return IsMirrored(matrix) ? ReverseCells(placed) : placed;
}

}
