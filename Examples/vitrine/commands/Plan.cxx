#include "commands/Commands.h"

#include "Median.h"
#include "Progress.h"
#include "commands/Options.h"
#include "methods/VitrineMethods.h"
#include "report/PlanReport.h"
#include "scene/Viewpoint.h"

#include "vtkErrorBudgetTransparencyPass.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace program
{

namespace
{
struct PlanOptions
{
  SceneOptions Scene;
  std::optional<std::string> ErrorBudget;
  int Frames = 9;
  double Orbit = 30.0;
  bool Verifies = false;
  std::optional<std::string> Json;
};

/** A stage in which the method automatic draws. */
class PlannedStage
{
public:
  PlannedStage(const Scene& scene, double budget, PictureSize size, int multisamples)
    : Pass(vtkSmartPointer<vtkErrorBudgetTransparencyPass>::New())
    , Window(scene, std::make_unique<AutomaticMethod>(this->Pass), size, multisamples)
  {
    this->Pass->SetErrorBudget(budget);
  }

  vtkSmartPointer<vtkErrorBudgetTransparencyPass> Pass;
  Stage Window;
};

void TakePlan(PlannedStage& stage, PlanTable& table)
{
  vtkErrorBudgetTransparencyPass* const pass = stage.Pass;
  table.Facts = stage.Window.GetMethod().Statistics();
  table.WrongGuesses = pass->GetNumberOfWrongGuesses();
  table.Problem = pass->GetFallbackReason();
  if (table.Problem.empty() && pass->GetNumberOfPlannedMethods() > 0)
  {
    table.Problem = pass->GetBudgetProblem();
  }
  for (int i = 0; i < pass->GetNumberOfPlannedMethods(); ++i)
  {
    table.Rows.push_back({ pass->GetPlannedMethod(i), pass->GetPlannedError(i),
      pass->GetPlannedPasses(i), pass->GetPlannedBytes(i), pass->GetPlannedReason(i) });
  }
}

/** Compare a picture with truth and with the bounds of its pixels. */
void JudgeBounds(
  const vitrine::Image& shown, const vitrine::Image& truth, vtkImageData* bounds, PlanCheck& check)
{
  // Truth holds the background in single precision.
  const double single = 1e-6;
  std::vector<double> tightness;
  for (vtkIdType pixel = 0; pixel < bounds->GetNumberOfPoints(); ++pixel)
  {
    double error = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const std::size_t at = 3 * static_cast<std::size_t>(pixel) + static_cast<std::size_t>(c);
      error = std::max(error, std::abs(double(shown.Rgb[at]) - double(truth.Rgb[at])));
    }
    const double bound = static_cast<const float*>(bounds->GetScalarPointer())[pixel];
    check.LargestError = std::max(check.LargestError, error);
    check.LargestBound = std::max(check.LargestBound, bound);
    check.PixelsBeyondBound += error > bound + single ? 1 : 0;
    if (error > 0.25 / 255.0)
    {
      tightness.push_back(bound / error);
    }
  }
  if (!tightness.empty())
  {
    check.MedianTightness = Median(tightness);
  }
}

PlanCheck Verify(const Scene& scene, PlannedStage& stage, vtkCamera* camera,
  const ComparisonSettings& asked, const std::vector<PlannedRow>& rows, Progress& progress)
{
  PlanCheck check;
  ComparisonSettings settings = asked;
  for (const PlannedRow& row : rows)
  {
    settings.Methods.push_back(row.Method);
  }
  check.Comparison = CompareMethods(scene, settings, progress);
  progress.Show("checking bounds");
  stage.Pass->KeepErrorBoundsOn();
  stage.Window.Draw(camera);
  const vitrine::Image shown = ToImage(stage.Window.ReadPixels(), settings.Size);
  vtkNew<vtkImageData> bounds;
  TruthStage truth(scene, settings.Size, settings.Multisamples);
  const std::unique_ptr<vitrine::Image> exact = truth.Draw(camera);
  if (exact && stage.Pass->GetErrorBound(bounds))
  {
    JudgeBounds(shown, *exact, bounds, check);
  }
  return check;
}

void Plan(const PlanOptions& options)
{
  vtkHeadlessRenderWindow::InstallOverride();
  CheckJsonPath(options.Json);
  CheckIsNoInput(options.Json, options.Scene.Inputs);
  ComparisonSettings settings;
  settings.Methods = { AutomaticName };
  settings.ErrorBudget =
    options.ErrorBudget ? ParseErrorBudget(*options.ErrorBudget) : DefaultErrorBudget;
  settings.Size = ParseSize(options.Scene.Size);
  settings.Multisamples = options.Scene.Multisamples;
  settings.Frames = options.Frames;
  settings.Orbit = options.Orbit;
  Progress progress;
  progress.Show("reading the scene");
  const Scene scene = LoadScene(options.Scene);
  settings.From = ChooseView(options.Scene, scene);
  PrintOmissions(scene);

  PlanTable table;
  table.Scene = scene.Name;
  table.Size = settings.Size;
  table.Budget = *settings.ErrorBudget;
  table.Parts = static_cast<std::int64_t>(scene.Parts.size());
  for (const Part& part : scene.Parts)
  {
    table.Triangles += CountTriangles(part.Geometry);
  }
  const vtkSmartPointer<vtkCamera> start =
    PlaceCamera(scene, settings.From, settings.Size.Aspect());
  PlannedStage stage(scene, table.Budget, settings.Size, settings.Multisamples);
  for (int frame = 0; frame < settings.Frames; ++frame)
  {
    progress.Show("drawing");
    const int steps = std::max(settings.Frames - 1, 1);
    stage.Window.Draw(Orbit(start, settings.Orbit * (frame - settings.Frames + 1) / steps));
  }
  TakePlan(stage, table);
  if (options.Verifies && !table.Rows.empty())
  {
    table.Check = Verify(scene, stage, start, settings, table.Rows, progress);
  }
  progress.Hide();
  WriteReport(options.Json, ToText(table), ToJson(table));
}
}

void AddPlanCommand(CLI::App& app)
{
  auto options = std::make_shared<PlanOptions>();
  CLI::App* command =
    app.add_subcommand("plan", "Tell the cheapest method that keeps an error budget, and why");
  AddSceneOptions(*command, options->Scene, "512x512");
  AddErrorBudgetOption(*command, options->ErrorBudget)->default_str("1/255");
  AddFramesOption(*command, options->Frames);
  AddOrbitOption(*command, options->Orbit,
    "degrees that the camera goes to the view, from the first frame to the last");
  command->add_flag("--verify", options->Verifies,
    "also measure: each method's time and error, and the bound of each pixel against truth");
  AddJsonOption(*command, options->Json);
  command->callback([options] { Plan(*options); });
}

}
