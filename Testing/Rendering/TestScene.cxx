#include "TestScene.h"

#include "TestMessages.h"
#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSeeThroughPass.h"
#include "vtkSphereSource.h"
#include "vtkTranslucentPass.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace
{

void Paint(vtkActor* actor, const Rgba& color)
{
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetOpacity(color[3]);
}

}

TestScene::TestScene(int width, int height, int multisamples)
{
  this->Window->SetSize(width, height);
  this->Window->SetMultiSamples(multisamples);
  this->Window->SetAlphaBitPlanes(1);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->SetBackground(TestBackground.data());
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

vtkSmartPointer<vtkActor> TestScene::AddPlates(const std::vector<Rgba>& plates, std::uint64_t seed)
{
  std::vector<double> heights;
  for (std::size_t i = 0; i < plates.size(); ++i)
  {
    const double behind = static_cast<double>(i) + 0.5;
    heights.push_back(0.9 - 1.8 * behind / static_cast<double>(plates.size()));
  }
  return this->AddPlates(plates, heights, seed);
}

vtkSmartPointer<vtkActor> TestScene::AddPlates(
  const std::vector<Rgba>& plates, const std::vector<double>& heights, std::uint64_t seed)
{
  std::vector<int> order(plates.size());
  std::iota(order.begin(), order.end(), 0);
  TestRandom random(seed);
  for (std::size_t i = order.size(); i > 1; --i)
  {
    std::swap(order[i - 1], order[random.Next() % i]);
  }

  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  for (const int i : order)
  {
    const double z = heights[i];
    const vtkIdType first = points->InsertNextPoint(-10.0, -10.0, z);
    points->InsertNextPoint(10.0, -10.0, z);
    points->InsertNextPoint(10.0, 10.0, z);
    points->InsertNextPoint(-10.0, 10.0, z);
    quads->InsertNextCell({ first, first + 1, first + 2, first + 3 });
    for (int corner = 0; corner < 4; ++corner)
    {
      for (const double component : plates[i])
      {
        colors->InsertNextValue(static_cast<unsigned char>(std::lround(255.0 * component)));
      }
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(quads);
  data->GetPointData()->SetScalars(colors);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->ForceTranslucentOn();
  this->Renderer->AddActor(actor);
  return actor;
}

vtkSmartPointer<vtkActor> TestScene::AddTriangle(
  const std::array<std::array<double, 3>, 3>& corners, const Rgba& color)
{
  vtkNew<vtkPoints> points;
  for (const std::array<double, 3>& corner : corners)
  {
    points->InsertNextPoint(corner.data());
  }
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(triangles);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  Paint(actor, color);
  actor->GetProperty()->LightingOff();
  this->Renderer->AddActor(actor);
  return actor;
}

vtkSmartPointer<vtkActor> TestScene::AddRectangle(
  double x0, double y0, double x1, double y1, double z, const Rgba& color)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(x0, y0, z);
  plane->SetPoint1(x1, y0, z);
  plane->SetPoint2(x0, y1, z);
  vtkSmartPointer<vtkActor> actor = this->AddSource(plane, color);
  actor->GetProperty()->LightingOff();
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
  return this->AddSource(sphere, color);
}

void TestScene::AddParts()
{
  this->AddSphere(0.3, 0.1, 0.2, 0.5, { 0.9, 0.5, 0.1, 0.4 });
  this->AddSphere(-0.2, -0.1, -0.3, 0.7, { 0.1, 0.5, 0.9, 0.6 });
  this->AddSphere(-0.4, 0.3, 0.3, 0.4, { 0.9, 0.5, 0.9, 1.0 });
}

vtkSmartPointer<vtkActor> TestScene::AddSource(vtkAlgorithm* source, const Rgba& color)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  Paint(actor, color);
  this->Renderer->AddActor(actor);
  return actor;
}

void TestScene::Use(vtkRenderPass* pass)
{
  vtkNew<vtkSeeThroughPass> seeThrough;
  seeThrough->SetTranslucentPass(pass);
  this->Renderer->SetPass(seeThrough);
}

Picture TestScene::RenderAsVTK()
{
  vtkNew<vtkOrderIndependentTranslucentPass> weighted;
  vtkNew<vtkTranslucentPass> translucent;
  weighted->SetTranslucentPass(translucent);
  this->Use(weighted);
  return this->Render();
}

Picture TestScene::Render()
{
  WatchOpenGL(this->Window);
  this->Window->Render();
  return ReadPicture(this->Window);
}

void TestScene::ExpectTheSameAfterReleases(vtkRenderPass* pass)
{
  this->Renderer->SetPass(pass);
  const Picture expected = this->Render();
  pass->ReleaseGraphicsResources(this->Window);
  EXPECT_TRUE(Matches(this->Render(), expected));
  this->Window->ReleaseGraphicsResources(this->Window);
  EXPECT_TRUE(Matches(this->Render(), expected));
  this->Window->Finalize();
  EXPECT_TRUE(Matches(this->Render(), expected));
  // A context of which the pass was not told that it went.
  this->Renderer->SetPass(nullptr);
  this->Window->Finalize();
  this->Render();
  this->Renderer->SetPass(pass);
  EXPECT_TRUE(Matches(this->Render(), expected));
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

void ExpectColor(const Rgba& color, const Rgba& expected, double tolerance)
{
  for (int c = 0; c < 4; ++c)
  {
    EXPECT_NEAR(255.0 * color[c], 255.0 * expected[c], tolerance) << "channel " << c;
  }
}

Rgba RoundedTo8Bits(const Rgba& color)
{
  Rgba rounded;
  std::transform(color.begin(), color.end(), rounded.begin(),
    [](double component) { return static_cast<double>(std::lround(255.0 * component)) / 255.0; });
  return rounded;
}

std::vector<Rgba> RandomPlates(int count, double alpha, std::uint64_t seed)
{
  TestRandom random(seed);
  std::vector<Rgba> plates;
  for (int i = 0; i < count; ++i)
  {
    const double red = random.Unit();
    const double green = random.Unit();
    plates.push_back(RoundedTo8Bits({ red, green, random.Unit(), alpha }));
  }
  return plates;
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
