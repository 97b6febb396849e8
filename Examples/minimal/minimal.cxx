// A translucent sphere around an opaque one, seen through exactly, written to minimal.png (or to the
// file that is named). It needs no display. The lines that make the difference are marked.
#include "vtkActor.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSeeThroughPass.h" // (1)
#include "vtkSphereSource.h"
#include "vtkWindowToImageFilter.h"

namespace
{
void AddSphere(vtkRenderer* renderer, double radius, double red, double opacity)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(48);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(red, 0.4, 1.0 - red);
  actor->GetProperty()->SetOpacity(opacity);
  renderer->AddActor(actor);
}
}

int main(int argc, char* argv[])
{
  vtkHeadlessRenderWindow::InstallOverride(); // render without a display
  vtkNew<vtkRenderer> renderer;
  AddSphere(renderer, 0.5, 1.0, 1.0);
  AddSphere(renderer, 1.0, 0.0, 0.3);

  vtkNew<vtkSeeThroughPass> seeThrough; // (2)
  renderer->SetPass(seeThrough);        // (3)

  vtkNew<vtkRenderWindow> window;
  window->SetSize(400, 300);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : "minimal.png");
  writer->Write();
  return writer->GetErrorCode() == 0 ? 0 : 1;
}
