#include "commands/Commands.h"

#include "Progress.h"
#include "commands/Options.h"
#include "commands/PartIndex.h"
#include "report/InfoReport.h"
#include "scene/Viewpoint.h"

#include "vtkCellArray.h"
#include "vtkHeadlessRenderWindow.h"

#include <memory>

namespace program
{

namespace
{
struct InfoOptions
{
  SceneOptions Scene;
  std::optional<std::string> Json;
  bool ListsParts = false;
};

SceneInfo CountScene(const Scene& scene)
{
  SceneInfo info;
  info.Name = scene.Name;
  info.Parts = scene.Parts.size();
  info.Lights = scene.Lights.size();
  info.Materials = CountMaterials(scene);
  info.Bounds = SceneBounds(scene);
  info.Expectation = scene.Expectation;
  info.Skipped = scene.Skipped;
  info.LengthUnit = scene.LengthUnit;
  info.Notes = scene.Notes;
  info.Arrays = ListDataArrays(scene);
  for (const Part& part : scene.Parts)
  {
    info.TranslucentParts += IsTranslucent(part);
    info.Triangles += CountTriangles(part.Geometry);
    info.Lines += part.Geometry->GetNumberOfLines();
    info.Points += part.Geometry->GetNumberOfVerts();
  }
  return info;
}

/** The tree of all parts, under the names and with the closedness that `clash` and `query` tell. */
std::vector<PartInfo> ListParts(const Scene& scene)
{
  const vtkSmartPointer<vtkAssemblyIndex> index = MakePartIndex(scene);
  std::vector<PartInfo> parts;
  for (const Part& part : scene.Parts)
  {
    const int number = static_cast<int>(parts.size());
    parts.push_back({ index->GetPartName(number), part.MaterialName, CountTriangles(part.Geometry),
      part.Material->GetOpacity(), IsTranslucent(part), index->GetPartIsClosed(number),
      PartBounds(part) });
  }
  return parts;
}

/** Without the scene's lights, which make no layers, and of which VTK's shaders take few. */
void CountLayers(SceneInfo& info, Scene scene, const SceneOptions& options)
{
  scene.Lights.clear();
  info.Size = ParseSize(options.Size);
  TruthStage truth(scene, info.Size, options.Multisamples);
  truth.Draw(PlaceCamera(scene, ChooseView(options, scene), info.Size.Aspect()));
  info.Layers = truth.Statistics();
  info.WhyNoLayers = truth.WhyNotRun();
}

void Info(const InfoOptions& options)
{
  vtkHeadlessRenderWindow::InstallOverride();
  CheckJsonPath(options.Json);
  CheckIsNoInput(options.Json, options.Scene.Inputs);
  Progress progress;
  progress.Show("reading the scene");
  const Scene scene = LoadScene(options.Scene);
  SceneInfo info = CountScene(scene);
  if (options.ListsParts)
  {
    progress.Show("listing parts");
    info.Tree = ListParts(scene);
  }
  progress.Show("counting layers");
  CountLayers(info, scene, options.Scene);

  WriteReport(options.Json, ToText(info), ToJson(info));
}
}

void AddInfoCommand(CLI::App& app)
{
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command =
    app.add_subcommand("info", "Tell what is in a scene and what is not shown of it");
  AddSceneOptions(*command, options->Scene, "512x512");
  command->add_flag("--parts", options->ListsParts,
    "also list the tree of parts: names, triangles, materials, bounds, and which are closed");
  AddJsonOption(*command, options->Json);
  command->callback([options] { Info(*options); });
}

}
