#include "CullerScene.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkCullerCollection.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace
{

constexpr double Distance = 3.6;
constexpr double ViewAngle = 40.0;
constexpr double ParallelScale = 1.25;

template <class Polygon>
vtkSmartPointer<vtkPolyData> MeshOfPolygons(const std::vector<Polygon>& polygons)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Polygon& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<int>(polygon.size()));
    for (const Point3& point : polygon)
    {
      cells->InsertCellPoint(points->InsertNextPoint(point.data()));
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

}

std::vector<CullerSetting> CullerSettings()
{
  return {
    { "Perspective", 0, false, 270, 101, 75 },
    { "ParallelInThickLines", 0, true, 19, 89, 73 },
    { "PerspectiveInThickLinesOf4Samples", 4, false, 17, 113, 75 },
    { "ParallelOf4Samples", 4, true, 270, 83, 77 },
  };
}

std::vector<CullerSetting> CullerSettingsOfOneSample()
{
  std::vector<CullerSetting> settings = CullerSettings();
  settings.erase(std::remove_if(settings.begin(), settings.end(),
                   [](const CullerSetting& setting) { return setting.Samples > 0; }),
    settings.end());
  return settings;
}

vtkSmartPointer<vtkPolyData> MeshOfTriangles(const std::vector<Triangle>& triangles)
{
  return MeshOfPolygons(triangles);
}

vtkSmartPointer<vtkPolyData> MeshOf(const std::vector<Quad>& quads)
{
  return MeshOfPolygons(quads);
}

vtkSmartPointer<vtkPolyData> TexturedWall()
{
  const vtkSmartPointer<vtkPolyData> wall = MeshOf({ Rectangle(-2.5, -2.5, 2.5, 2.5, 0.0) });
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (const double u : { 0.0, 1.0, 1.0, 0.0 })
  {
    coordinates->InsertNextTuple2(u, coordinates->GetNumberOfTuples() / 2);
  }
  wall->GetPointData()->SetTCoords(coordinates);
  return wall;
}

vtkSmartPointer<vtkImageData> PlainImage(int components, double value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  image->GetPointData()->GetScalars()->Fill(value);
  return image;
}

void MovePointsInPlace(vtkPolyData* mesh, const Point3& by)
{
  vtkPoints* const points = mesh->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double point[3];
    points->GetPoint(i, point);
    points->SetPoint(i, point[0] + by[0], point[1] + by[1], point[2] + by[2]);
  }
}

Quad Rectangle(double x0, double y0, double x1, double y1, double z)
{
  return { { { x0, y0, z }, { x1, y0, z }, { x1, y1, z }, { x0, y1, z } } };
}

std::vector<Quad> StripsBetweenSlits(double width, std::uint64_t seed)
{
  TestRandom random(seed);
  std::vector<Quad> strips;
  double bottomLeft = -1.5, topLeft = -1.5;
  while (bottomLeft < 1.5)
  {
    const double bottomRight = bottomLeft + 0.35 + 0.1 * random.Unit();
    const double topRight = topLeft + 0.35 + 0.1 * random.Unit();
    strips.push_back({ { { bottomLeft, -1.5, 0.0 }, { bottomRight, -1.5, 0.0 },
      { topRight, 1.5, 0.0 }, { topLeft, 1.5, 0.0 } } });
    bottomLeft = bottomRight + width;
    topLeft = topRight + width;
  }
  return strips;
}

CullerScene::CullerScene(const CullerSetting& setting)
  : TestScene(setting.Width, setting.Height, setting.Samples)
  , Setting(setting)
{
  this->Culler->SetBufferLines(setting.BufferLines);
  this->Renderer->GetCullers()->RemoveAllItems();
  this->Renderer->AddCuller(this->Culler);
  vtkNew<vtkCubeSource> cube;
  this->BoxMapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  this->BoxMapper->SetInputConnection(cube->GetOutputPort());
  this->LookAhead();
}

std::vector<vtkSmartPointer<vtkActor>> CullerScene::AddHidden(double z)
{
  std::vector<vtkSmartPointer<vtkActor>> boxes;
  for (int row = -3; row <= 3; ++row)
  {
    for (int column = -4; column <= 4; ++column)
    {
      boxes.push_back(this->AddBox({ 0.2 * column, 0.24 * row, z }, { 0.11, 0.1, 0.04 }));
    }
  }
  return boxes;
}

void CullerScene::Clear()
{
  this->Renderer->RemoveAllViewProps();
}

vtkSmartPointer<vtkActor> CullerScene::AddWall(double z)
{
  return this->AddMesh(MeshOf({ Rectangle(-2.5, -2.5, 2.5, 2.5, z) }));
}

vtkSmartPointer<vtkActor> CullerScene::AddBox(const Point3& middle, const Point3& size)
{
  const vtkSmartPointer<vtkActor> box = this->MakeBox(middle, size);
  this->Renderer->AddActor(box);
  return box;
}

vtkSmartPointer<vtkActor> CullerScene::MakeBox(const Point3& middle, const Point3& size)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(this->BoxMapper);
  actor->SetPosition(middle[0], middle[1], middle[2]);
  actor->SetScale(size[0], size[1], size[2]);
  actor->GetProperty()->SetColor(this->NextColor().data());
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkActor> CullerScene::AddMesh(vtkPolyData* mesh, const Rgba& color)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetOpacity(color[3]);
  actor->GetProperty()->LightingOff();
  this->Renderer->AddActor(actor);
  return actor;
}

vtkSmartPointer<vtkActor> CullerScene::AddLine(
  const Point3& from, const Point3& to, const Rgba& color)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(from.data());
  points->InsertNextPoint(to.data());
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetLines(lines);
  return this->AddMesh(mesh, color);
}

/** A colour that is neither a wall's nor the background's. */
std::array<double, 3> CullerScene::NextColor()
{
  const double red = 0.6 + 0.4 * this->Colors.Unit();
  return { red, 0.4 * this->Colors.Unit(), 0.2 * this->Colors.Unit() };
}

void CullerScene::LookAhead()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetParallelProjection(this->Setting.IsParallel);
  camera->SetParallelScale(ParallelScale);
  camera->SetViewAngle(ViewAngle);
  camera->SetPosition(0.0, 0.0, Distance);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetClippingRange(1.0, 8.0);
}

void CullerScene::PutSampleInMiddle()
{
  const double halves = this->Setting.Samples > 0 ? 2.0 / 8.0 : 0.0; // of a pixel
  this->Renderer->GetActiveCamera()->SetWindowCenter(
    halves / this->Setting.Width, halves / this->Setting.Height);
}

void CullerScene::LookFromAnywhere(TestRandom& random)
{
  const auto between = [&](double low, double high) { return low + (high - low) * random.Unit(); };
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double away = between(Distance, 1.15 * Distance);
  camera->SetPosition(between(-0.4, 0.4) * away, between(-0.4, 0.4) * away, away);
  camera->SetFocalPoint(between(-0.03, 0.03), between(-0.03, 0.03), between(-0.4, -0.2));
  camera->SetViewUp(between(-0.5, 0.5), 1.0, 0.0);
  camera->SetParallelScale(between(ParallelScale, 1.1 * ParallelScale));
}

Picture CullerScene::Render()
{
  if (this->Culler->GetCulling())
  {
    this->Culler->Forget();
  }
  return this->TestScene::Render();
}

bool CullerScene::ShowsUnculled(const std::vector<vtkSmartPointer<vtkActor>>& parts)
{
  this->Culler->CullingOff();
  Picture pictures[2];
  for (const int isDrawn : { 0, 1 })
  {
    for (const vtkSmartPointer<vtkActor>& part : parts)
    {
      part->SetVisibility(isDrawn);
    }
    pictures[isDrawn] = this->Render();
  }
  return !(pictures[0] == pictures[1]);
}

void CullerScene::ExpectSamePictures(const Picture& culled, const Picture& plain)
{
  EXPECT_TRUE(Matches(culled, plain, 0, 0.0, { "culled", "plain" }))
    << this->Culler->DescribeLeftOut(FirstDifference(culled, plain));
}

int CullerScene::ExpectSame()
{
  this->Culler->CullingOn();
  const Picture culled = this->Render();
  const int leftOut = this->Culler->GetNumberOfCulledParts();
  EXPECT_TRUE(leftOut == 0 || this->Culler->HasLeftOut()) << leftOut << " parts are only counted";
  this->Culler->CullingOff();
  this->ExpectSamePictures(culled, this->Render());
  return leftOut;
}

int CullerScene::ExpectSameAround(std::uint64_t seed, int poses)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  this->LookAhead();
  int most = this->ExpectSame();
  TestRandom random(seed);
  for (int pose = 0; pose < poses; ++pose)
  {
    SCOPED_TRACE("pose " + std::to_string(pose));
    this->LookFromAnywhere(random);
    most = std::max(most, this->ExpectSame());
  }
  return most;
}

void CullerScene::ExpectHidden(std::uint64_t seed, int poses)
{
  EXPECT_GT(this->ExpectSameAround(seed, poses), 0);
}

void CullerScene::ExpectNothingHidden(std::uint64_t seed, int poses)
{
  EXPECT_EQ(this->ExpectSameAround(seed, poses), 0);
}

double CullerScene::PixelSize() const
{
  const double half =
    this->Setting.IsParallel ? ParallelScale : Distance * std::tan(ViewAngle * 3.14159265 / 360.0);
  return 2.0 * half / this->Setting.Height;
}

void PrintTo(const CullerSetting& setting, std::ostream* os)
{
  *os << setting.Name;
}
