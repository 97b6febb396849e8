/**
 * demo:opaque, demo:clipped, demo:alpha-texture and demo:impostors: translucent parts beside opaque ones, and
 * fragments that shaders discard or move.
 */
#include "scene/Plates.h"
#include "scene/failing/FailingScenes.h"
#include "scene/papers/Textures.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

namespace program
{

namespace
{
Part MakePlatePart(const std::string& name, double half, const Color& color, double alpha)
{
  Part part = MakeTranslucentPart(name, MakePlate(half, half), MakeUnlit(color, alpha));
  part.ForceTranslucent = alpha < 1.0;
  return part;
}

void AddPlane(vtkPlaneCollection* planes, double x, double y, double z, double along)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(x, y, z);
  plane->SetOrigin(along * x, along * y, along * z);
  planes->AddItem(plane);
}

vtkSmartPointer<vtkPolyData> WithTextureCoordinates(vtkSmartPointer<vtkPolyData> plate)
{
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (const auto& [u, v] : { std::pair(0.0, 0.0), { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } })
  {
    coordinates->InsertNextTuple2(u, v);
  }
  plate->GetPointData()->SetTCoords(coordinates);
  return plate;
}
}

Scene MakeOpaqueScene(const DemoValues& values)
{
  const int layers = static_cast<int>(values.at("layers"));
  const double alpha = values.at("alpha");
  Random random(static_cast<std::uint64_t>(values.at("seed")));
  const double gap = 1.0 / layers;
  Scene scene;
  for (int i = 0; i < layers; ++i)
  {
    Part plate = MakePlatePart("plate-" + std::to_string(i), 0.9, EightBitColor(random), alpha);
    plate.Transform = TranslateTo(0.0, 0.0, 0.5 - gap * i);
    scene.Parts.push_back(plate);
  }
  const std::pair<std::string, double> places[] = { { "in-front", 0.5 + gap },
    { "between", 0.5 - 0.5 * gap }, { "coplanar", 0.5 - gap * (layers / 2) } };
  const double columns[] = { -0.55, 0.0, 0.55 };
  for (int i = 0; i < 3; ++i)
  {
    Part block = MakePlatePart(places[i].first, 0.22, EightBitColor(random), 1.0);
    block.Transform = TranslateTo(columns[i], columns[i], places[i].second);
    scene.Parts.push_back(block);
  }
  random.Shuffle(scene.Parts);
  scene.Placement.ParallelScale = 1.0;
  return scene;
}

Scene MakeClippedScene(const DemoValues& values)
{
  Scene scene = MakeSpheresScene({ { "layers", values.at("layers") },
    { "alpha", values.at("alpha") }, { "seed", values.at("seed") }, { "resolution", 24 } });
  auto planes = vtkSmartPointer<vtkPlaneCollection>::New();
  AddPlane(planes, -0.6, 0.0, -0.8, -0.35); // takes what is in front, to the right
  AddPlane(planes, 0.0, -1.0, 0.0, -0.6);   // and the top
  for (Part& part : scene.Parts)
  {
    part.ClippingPlanes = planes;
  }
  return scene;
}

Scene MakeAlphaTextureScene(const DemoValues& values)
{
  const int layers = static_cast<int>(values.at("layers"));
  Random random(static_cast<std::uint64_t>(values.at("seed")));
  const std::vector<vtkSmartPointer<vtkTexture>> textures = MakeCloudTextures(layers, random);
  const vtkSmartPointer<vtkPolyData> plate = WithTextureCoordinates(MakePlate(0.95, 0.95));
  Scene scene;
  for (int i = 0; i < layers; ++i)
  {
    vtkNew<vtkTransform> tilted;
    tilted->RotateY(random.Between(-30.0, 30.0));
    tilted->RotateX(random.Between(-30.0, 30.0));
    Part part =
      MakeTranslucentPart("plate-" + std::to_string(i), plate, MakeUnlit({ 1.0, 1.0, 1.0 }, 1.0));
    part.Texture = textures[i];
    part.Transform = ToMatrix(tilted);
    scene.Parts.push_back(part);
  }
  scene.Placement.VisibleRadius = 1.1;
  return scene;
}

Scene MakeImpostorsScene(const DemoValues& values)
{
  const int spheres = static_cast<int>(values.at("spheres"));
  const double alpha = values.at("alpha");
  Random random(static_cast<std::uint64_t>(values.at("seed")));
  Scene scene;
  for (int i = 0; i < spheres; ++i)
  {
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(
      random.Between(-0.5, 0.5), random.Between(-0.5, 0.5), random.Between(-0.5, 0.5));
    vtkNew<vtkCellArray> vertices;
    vertices->InsertNextCell({ 0 });
    auto center = vtkSmartPointer<vtkPolyData>::New();
    center->SetPoints(points);
    center->SetVerts(vertices);
    Part part = MakeTranslucentPart(
      "sphere-" + std::to_string(i), center, MakeLit(EightBitColor(random), alpha));
    part.SphereRadius = 0.45;
    scene.Parts.push_back(part);
  }
  scene.Parts.push_back(MakePlatePart("plate", 0.9, EightBitColor(random), alpha));
  scene.Placement.VisibleRadius = 1.1;
  return scene;
}

}
