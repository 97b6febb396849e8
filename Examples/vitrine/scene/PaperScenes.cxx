/**
 * demo:paper-masks and demo:paper-lists: scenes like those that stencil masks and linked lists were first
 * measured with: textured triangles, a transparent model, which stands among them, and an opaque one.
 *
 * From the scene's own view the pixel with most layers has exactly as many as are asked for, beginning
 * with one: those of the transparent model where it crosses itself, and one of each textured sheet.
 * With as many as the model has by itself, or fewer, there are only sheets; with none, the opaque model alone.
 */
#include "scene/DemoScene.h"
#include "scene/Random.h"
#include "scene/papers/Models.h"
#include "scene/papers/Sheets.h"

#include "vtkNew.h"
#include "vtkTransform.h"

#include <iterator>

namespace program
{

namespace
{
const double VisibleHalfHeight = 1.3;
const double SheetHalfHeight = 1.25;
const double SheetHalfWidth = 2.0; // for the windows of 16 to 10 of the papers
const double SheetHalfDepth = 1.0;

/** What tells the two scenes apart. */
struct PaperScene
{
  int TexturedTriangles;
  int Rings; ///< of the transparent model
  int Sides;
};

/** With colours whose highlights stay below 1, beyond which VTK's methods differ by clamping. */
vtkSmartPointer<vtkProperty> MakeMaterial(double red, double green, double blue, double opacity)
{
  auto material = vtkSmartPointer<vtkProperty>::New();
  material->SetColor(red, green, blue);
  material->SetOpacity(opacity);
  material->SetSpecular(0.25);
  material->SetSpecularPower(30.0);
  return material;
}

Part MakeTransparentModel(const PaperScene& settings)
{
  Part model;
  model.Name = "figure-eight";
  model.Geometry = MakeFigureEight(settings.Rings, settings.Sides);
  model.Material = MakeMaterial(0.75, 0.45, 0.12, 0.4);
  return model;
}

/** Upright in a hole of the transparent model, so that it hides a part of the sheets. */
Part MakeOpaqueModel()
{
  vtkNew<vtkTransform> transform;
  transform->Translate(-FigureEightHole, 0.0, 0.0);
  transform->RotateX(-90.0);
  Part vase;
  vase.Name = "vase";
  vase.Geometry = MakeVase();
  vase.Material = MakeMaterial(0.25, 0.45, 0.75, 1.0);
  vase.Transform = vtkSmartPointer<vtkMatrix4x4>::New();
  transform->GetMatrix(vase.Transform);
  return vase;
}

Scene MakePaperScene(const PaperScene& settings, const DemoValues& values)
{
  const int layers = static_cast<int>(values.at("layers"));
  Random random(static_cast<std::uint64_t>(values.at("seed")));
  SheetSettings sheets{ layers, settings.TexturedTriangles, SheetHalfWidth, SheetHalfHeight,
    SheetHalfDepth };
  Scene scene;
  scene.Parts.push_back(MakeOpaqueModel());
  if (layers > FigureEightLayers)
  {
    scene.Parts.push_back(MakeTransparentModel(settings));
    sheets.Count -= FigureEightLayers;
  }
  std::vector<Part> textured = MakeSheets(sheets, random);
  std::move(textured.begin(), textured.end(), std::back_inserter(scene.Parts));
  scene.Placement.VisibleRadius = VisibleHalfHeight;
  return scene;
}
}

Scene MakePaperMasksScene(const DemoValues& values)
{
  return MakePaperScene({ 384, 1340, 325 }, values); // 2 * 1340 * 325 = 871,000
}

Scene MakePaperListsScene(const DemoValues& values)
{
  return MakePaperScene({ 2048, 725, 180 }, values); // 2 * 725 * 180 = 261,000
}

}
