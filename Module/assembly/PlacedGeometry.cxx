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

/** Whether a place leaves boxes boxes: no axis of the world depends on two axes of the model. */
bool KeepsBoxes(const glm::dmat4& matrix)
{
  for (int row = 0; row < 3; ++row)
  {
    int axes = 0;
    for (int column = 0; column < 3; ++column)
    {
      axes += matrix[column][row] != 0.0 ? 1 : 0;
    }
    if (axes > 1)
    {
      return false;
    }
  }
  return true;
}

/** Lowest and highest of placed points, of which one that is not a number counts nowhere. */
struct Reach
{
  glm::dvec3 Low{ std::numeric_limits<double>::infinity() };
  glm::dvec3 High{ -std::numeric_limits<double>::infinity() };

  void Add(const glm::dvec3& point)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = point[axis] < this->Low[axis] ? point[axis] : this->Low[axis];
      this->High[axis] = point[axis] > this->High[axis] ? point[axis] : this->High[axis];
    }
  }
};

template <class Number>
Reach ReachOf(const Number* values, vtkIdType count, const glm::dmat4& matrix)
{
  Reach reach;
  for (const Number* const end = values + 3 * count; values != end; values += 3)
  {
    reach.Add(glm::dvec3(matrix * glm::dvec4(values[0], values[1], values[2], 1.0)));
  }
  return reach;
}

Reach ReachOf(const vtkBoundingBox& box, const glm::dmat4& matrix)
{
  Reach reach;
  for (int corner = 0; corner < 8; ++corner)
  {
    double point[3];
    box.GetCorner(corner, point);
    reach.Add(glm::dvec3(matrix * glm::dvec4(point[0], point[1], point[2], 1.0)));
  }
  return reach;
}

Reach ReachOf(vtkPoints* points, const glm::dmat4& matrix)
{
  const vtkIdType count = points->GetNumberOfPoints();
  if (auto* const floats = vtkFloatArray::FastDownCast(points->GetData()))
  {
    return ReachOf(floats->GetPointer(0), count, matrix);
  }
  vtkNew<vtkDoubleArray> doubles;
  doubles->DeepCopy(points->GetData());
  return ReachOf(doubles->GetPointer(0), count, matrix);
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

vtkBoundingBox PlacedBox(vtkPolyData* geometry, vtkMatrix4x4* place)
{
  const vtkBoundingBox box(geometry->GetBounds());
  if (!place || !box.IsValid())
  {
    return box;
  }
  const glm::dmat4 matrix = MatrixOf(place);
  const Reach reach =
    KeepsBoxes(matrix) ? ReachOf(box, matrix) : ReachOf(geometry->GetPoints(), matrix);
  return { reach.Low.x, reach.High.x, reach.Low.y, reach.High.y, reach.Low.z, reach.High.z };
}

}
