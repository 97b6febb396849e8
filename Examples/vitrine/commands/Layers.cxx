#include "commands/Commands.h"

#include "Errors.h"
#include "Progress.h"
#include "commands/Options.h"
#include "report/LayersReport.h"
#include "scene/Viewpoint.h"

#include "vtkHeadlessRenderWindow.h"
#include "vtkLayerPicker.h"
#include "vtkNew.h"

#include <algorithm>
#include <charconv>
#include <memory>

namespace program
{

namespace
{
struct LayersOptions
{
  SceneOptions Scene;
  std::string At;
  bool All = false;
  std::optional<std::string> Json;
};

/** "X,Y", whole numbers within a picture. Throws InputError for anything else. */
std::array<int, 2> ParsePixel(const std::string& text, PictureSize size)
{
  std::array<int, 2> pixel{};
  const char* const end = text.data() + text.size();
  const auto [comma, problem] = std::from_chars(text.data(), end, pixel[0]);
  const bool hasComma = problem == std::errc() && comma != end && *comma == ',';
  const auto rest = hasComma ? std::from_chars(comma + 1, end, pixel[1])
                             : std::from_chars_result{ comma, std::errc::invalid_argument };
  if (rest.ec != std::errc() || rest.ptr != end)
  {
    throw InputError("--at", "'" + text + "' is not X,Y, two whole numbers of pixels");
  }
  if (pixel[0] < 0 || pixel[1] < 0 || pixel[0] >= size.Width || pixel[1] >= size.Height)
  {
    throw InputError("--at",
      "pixel " + text + " is outside of the picture, which has " + std::to_string(size.Width) +
        "x" + std::to_string(size.Height) + " pixels");
  }
  return pixel;
}

std::vector<LayerRow> ReadLayers(vtkLayerPicker* picker, const Scene& scene, const Stage& stage)
{
  const std::vector<std::string> paths = PartPaths(scene);
  std::vector<LayerRow> rows;
  for (vtkIdType i = 0; i < picker->GetNumberOfLayers(); ++i)
  {
    LayerRow row;
    const std::optional<std::size_t> part = stage.PartOf(picker->GetProp(i));
    row.Part = part ? paths[*part] : "";
    row.Depth = picker->GetWindowDepth(i);
    row.Distance = picker->GetDistance(i);
    std::copy_n(picker->GetWorldPosition(i), 3, row.Position.begin());
    std::copy_n(picker->GetColor(i), 3, row.Color.begin());
    row.Opacity = picker->GetOpacity(i);
    row.Share = picker->GetShare(i);
    row.IsFront = picker->GetFrontFace(i);
    row.IsOpaque = picker->GetOpaque(i);
    rows.push_back(row);
  }
  return rows;
}

void Layers(const LayersOptions& options)
{
  vtkHeadlessRenderWindow::InstallOverride();
  CheckJsonPath(options.Json);
  CheckIsNoInput(options.Json, options.Scene.Inputs);
  const PictureSize size = ParseSize(options.Scene.Size);
  LayersTable table;
  table.Size = { size.Width, size.Height };
  table.Pixel = ParsePixel(options.At, size);
  Progress progress;
  progress.Show("reading the scene");
  const Scene scene = LoadScene(options.Scene);
  table.Scene = scene.Name;
  progress.Show("drawing");
  Stage stage(scene, MakeMethod("linked-list"), size, options.Scene.Multisamples);
  stage.Draw(PlaceCamera(scene, ChooseView(options.Scene, scene), size.Aspect()));
  vtkNew<vtkLayerPicker> picker;
  picker->SetRenderer(stage.GetRenderer());
  picker->SetPosition(table.Pixel[0], table.Pixel[1]);
  picker->SetBehindOpaque(options.All);
  if (!picker->Pick())
  {
    throw RuntimeError(picker->GetProblem());
  }
  table.Layers = ReadLayers(picker, scene, stage);
  progress.Hide();
  PrintOmissions(scene);
  WriteReport(options.Json, ToText(table), ToJson(table));
}
}

void AddLayersCommand(CLI::App& app)
{
  auto options = std::make_shared<LayersOptions>();
  CLI::App* command = app.add_subcommand("layers", "Tell all layers of a pixel, with their parts");
  AddSceneOptions(*command, options->Scene, "1024x768");
  command->add_option("--at", options->At, "the pixel, from the lower left corner of the picture")
    ->type_name("X,Y")
    ->required();
  command->add_flag("--all", options->All, "also tell layers behind the nearest opaque one");
  AddJsonOption(*command, options->Json);
  command->callback([options] { Layers(*options); });
}

}
