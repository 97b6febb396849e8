/**
 * demo:paper-masks and demo:paper-lists: scenes like those that stencil masks and linked lists were first
 * measured with: textured triangles, a transparent model, which stands among them, and an opaque one
 * inside it.
 *
 * The pixel with most layers has exactly as many as are asked for, and lies at the middle of the scene's own
 * view: those of the transparent model, and one of each textured sheet. With as many as the model has by
 * itself, or fewer, there are only sheets; with none, the opaque model alone.
 */
#include "scene/DemoScene.h"
#include "scene/Plates.h"
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
  int Stations; ///< of the transparent model
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

/** Lying across the view. */
Part MakeTransparentModel(const PaperScene& settings)
{
  vtkNew<vtkTransform> transform;
  transform->RotateZ(7.0);
  Part shell;
  shell.Name = "shell";
  shell.Geometry = MakeShell(settings.Stations, settings.Sides);
  shell.Material = MakeMaterial(0.45, 0.6, 0.75, 0.2);
  shell.Transform = ToMatrix(transform);
  return shell;
}

/** Upright, and beside the middle, so that it hides a part of the sheets. */
Part MakeOpaqueModel()
{
  vtkNew<vtkTransform> transform;
  transform->Translate(-0.75, 0.0, 0.0);
  transform->RotateX(-90.0);
  Part vase;
  vase.Name = "vase";
  vase.Geometry = MakeVase();
  vase.Material = MakeMaterial(0.75, 0.45, 0.12, 1.0);
  vase.Transform = ToMatrix(transform);
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
  if (layers > ShellLayers)
  {
    scene.Parts.push_back(MakeTransparentModel(settings));
    sheets.Count -= ShellLayers;
  }
  std::vector<Part> textured = MakeSheets(sheets, random);
  std::move(textured.begin(), textured.end(), std::back_inserter(scene.Parts));
  scene.Placement.VisibleRadius = VisibleHalfHeight;
  return scene;
}
}

Scene MakePaperMasksScene(const DemoValues& values)
{
  return MakePaperScene({ 384, 325, 670 }, values); // 4 * 325 * 670 = 871,000
}

Scene MakePaperListsScene(const DemoValues& values)
{
  return MakePaperScene({ 2048, 225, 290 }, values); // 4 * 225 * 290 = 261,000
}

}
