#include "section/CapActor.h"

#include "Core/section/CutPolygon.h"
#include "scene/CutProps.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkProperty.h"

#include <algorithm>

namespace vitrine
{

vtkStandardNewMacro(CapActor);

CapActor::CapActor()
{
  this->Drawing->SetInputData(this->Polygon);
  this->Drawing->ScalarVisibilityOff();
  this->SetMapper(this->Drawing);
  this->GetProperty()->SetSpecular(0.0);
  this->UseBoundsOff();
  MarkAsCap(this);
  this->VisibilityOff();
}

void CapActor::SetForTranslucent(bool isForTranslucent)
{
  this->IsForTranslucent = isForTranslucent;
  this->SetForceTranslucent(isForTranslucent);
  this->SetForceOpaque(!isForTranslucent);
}

void CapActor::Place(const CutPlane& plane, const glm::dvec3& min, const glm::dvec3& max)
{
  if (plane.Equation() == this->Placed.Equation() && min == this->PlacedMin &&
    max == this->PlacedMax)
  {
    return;
  }
  this->Placed = plane;
  this->PlacedMin = min;
  this->PlacedMax = max;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetName("Normals");
  vtkNew<vtkCellArray> polygons;
  std::vector<glm::dvec3> corners = CutPolygon(plane, min, max);
  std::reverse(corners.begin(), corners.end()); // the front faces what the plane removes
  for (const glm::dvec3& corner : corners)
  {
    points->InsertNextPoint(&corner.x);
    const glm::dvec3 normal = -glm::normalize(plane.Normal);
    normals->InsertNextTuple(&normal.x);
  }
  if (!corners.empty())
  {
    polygons->InsertNextCell(static_cast<int>(corners.size()));
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      polygons->InsertCellPoint(static_cast<vtkIdType>(i));
    }
  }
  this->Polygon->SetPoints(points);
  this->Polygon->SetPolys(polygons);
  this->Polygon->GetPointData()->SetNormals(normals);
}

void CapActor::Render(vtkRenderer* renderer, vtkMapper* mapper)
{
  if (this->Begin && this->Begin(renderer))
  {
    this->Superclass::Render(renderer, mapper);
    this->End();
  }
}

void CapActor::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Release)
  {
    this->Release(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

}
