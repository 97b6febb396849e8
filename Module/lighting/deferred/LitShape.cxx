#include "lighting/deferred/LitShape.h"

#include "vtkCellArray.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"

namespace vitrine
{

LitShape::LitShape(Shading shading, vtkPolyData* shape)
{
  vtkNew<vtkOpenGLPolyDataMapper> mapper;
  mapper->SetInputData(shape);
  mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  this->Actor->SetMapper(mapper);
  shading == Shading::Phong ? this->Actor->GetProperty()->SetInterpolationToPhong()
                            : this->Actor->GetProperty()->SetInterpolationToPBR();
}

void LitShape::Draw(vtkRenderer* renderer)
{
  vtkRenderState state(renderer);
  vtkProp* prop = this->Actor;
  state.SetPropArrayAndCount(&prop, 1);
  this->Hook->Render(&state);
}

void LitShape::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Actor->ReleaseGraphicsResources(window);
}

vtkSmartPointer<vtkPolyData> MakeCover()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-1.0, -1.0, 0.0);
  points->InsertNextPoint(3.0, -1.0, 0.0);
  points->InsertNextPoint(-1.0, 3.0, 0.0);
  vtkNew<vtkCellArray> triangle;
  triangle->InsertNextCell({ 0, 1, 2 });
  auto cover = vtkSmartPointer<vtkPolyData>::New();
  cover->SetPoints(points);
  cover->SetPolys(triangle);
  return cover;
}

}
