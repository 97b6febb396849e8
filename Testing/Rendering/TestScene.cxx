#include "TestScene.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSeeThroughPass.h"
#include "vtkSphereSource.h"
#include "vtkTransparencyPass.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdlib>

namespace
{

// Before the first window is made.
const bool headless = (vtkHeadlessRenderWindow::InstallOverride(), true);

void Paint(vtkActor* actor, const Rgba& color)
{
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetOpacity(color[3]);
}

}

Rgba Picture::At(int x, int y) const
{
  const unsigned char* p = this->Bytes.data() + 4 * (static_cast<std::size_t>(y) * this->Width + x);
  return { p[0] / 255.0, p[1] / 255.0, p[2] / 255.0, p[3] / 255.0 };
}

Picture ReadPicture(vtkRenderWindow* window)
{
  Picture picture;
  picture.Width = window->GetSize()[0];
  picture.Height = window->GetSize()[1];
  vtkNew<vtkUnsignedCharArray> data;
  window->GetRGBACharPixelData(0, 0, picture.Width - 1, picture.Height - 1, 0, data);
  picture.Bytes.assign(data->GetPointer(0), data->GetPointer(0) + data->GetNumberOfValues());
  return picture;
}

int LargestDifference(const Picture& a, const Picture& b)
{
  if (a.Bytes.size() != b.Bytes.size())
  {
    return 256;
  }
  int largest = 0;
  for (std::size_t i = 0; i < a.Bytes.size(); ++i)
  {
    largest = std::max(largest, std::abs(int(a.Bytes[i]) - int(b.Bytes[i])));
  }
  return largest;
}

TestScene::TestScene(int width, int height, int multisamples)
{
  (void)headless;
  this->Window->SetSize(width, height);
  this->Window->SetMultiSamples(multisamples);
  this->Window->SetAlphaBitPlanes(1);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->SetBackground(0.2, 0.3, 0.4);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.0);
  camera->SetPosition(0.0, 0.0, 2.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetClippingRange(1.0, 3.0);
}

vtkSmartPointer<vtkActor> TestScene::AddPlate(double z, const Rgba& color)
{
  return this->AddRectangle(-10.0, -10.0, 10.0, 10.0, z, color);
}

vtkSmartPointer<vtkActor> TestScene::AddRectangle(
  double x0, double y0, double x1, double y1, double z, const Rgba& color)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(x0, y0, z);
  plane->SetPoint1(x1, y0, z);
  plane->SetPoint2(x0, y1, z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  Paint(actor, color);
  actor->GetProperty()->LightingOff();
  this->Renderer->AddActor(actor);
  return actor;
}

vtkSmartPointer<vtkActor> TestScene::AddSphere(
  double x, double y, double z, double radius, const Rgba& color, int resolution)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(x, y, z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  Paint(actor, color);
  this->Renderer->AddActor(actor);
  return actor;
}

void TestScene::Use(vtkTransparencyPass* pass)
{
  vtkNew<vtkSeeThroughPass> seeThrough;
  seeThrough->SetTranslucentPass(pass);
  this->Renderer->SetPass(seeThrough);
}

Picture TestScene::Render()
{
  this->Window->Render();
  return ReadPicture(this->Window);
}

Rgba CompositePlates(const std::vector<Rgba>& plates, const Rgba& background)
{
  Rgba result = { 0.0, 0.0, 0.0, 0.0 };
  double transmittance = 1.0;
  for (const Rgba& plate : plates)
  {
    for (int c = 0; c < 3; ++c)
    {
      result[c] += transmittance * plate[3] * plate[c];
    }
    transmittance *= 1.0 - plate[3];
  }
  for (int c = 0; c < 3; ++c)
  {
    result[c] += transmittance * background[c];
  }
  result[3] = 1.0 - transmittance + transmittance * background[3];
  return result;
}

std::uint64_t TestRandom::Next()
{
  this->State += 0x9e3779b97f4a7c15u;
  std::uint64_t z = this->State;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

double TestRandom::Unit()
{
  return static_cast<double>(this->Next() >> 11) * 0x1.0p-53;
}
