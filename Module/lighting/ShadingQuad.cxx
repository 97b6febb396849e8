#include "lighting/ShadingQuad.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"

namespace vitrine
{

namespace
{

// One triangle, in coordinates of the viewport.
vtkSmartPointer<vtkPolyData> MakeCover()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-1.0, -1.0, 0.0);
  points->InsertNextPoint(3.0, -1.0, 0.0);
  points->InsertNextPoint(-1.0, 3.0, 0.0);
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  auto cover = vtkSmartPointer<vtkPolyData>::New();
  cover->SetPoints(points);
  cover->SetPolys(triangles);
  return cover;
}
}

ShadingQuad::ShadingQuad(Shading shading)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeCover());
  this->Actor->SetMapper(mapper);
  shading == Shading::Phong ? this->Actor->GetProperty()->SetInterpolationToPhong()
                            : this->Actor->GetProperty()->SetInterpolationToPBR();
}

void ShadingQuad::Draw(vtkRenderer* renderer)
{
  vtkRenderState state(renderer);
  vtkProp* prop = this->Actor;
  state.SetPropArrayAndCount(&prop, 1);
  this->Hook->Render(&state);
}

void ShadingQuad::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Actor->ReleaseGraphicsResources(window);
}

}
