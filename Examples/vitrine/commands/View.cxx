#include "commands/Commands.h"

#include "Errors.h"
#include "commands/Options.h"
#include "scene/ColorBy.h"
#include "scene/Viewpoint.h"
#include "view/Inspector.h"
#include "view/InspectorStyle.h"
#include "view/Keys.h"

#include "vtkRenderWindowInteractor.h"
#include "vtkSeeThroughPass.h"

#include <cstdlib>
#include <memory>

namespace program
{

namespace
{
struct ViewOptions
{
  SceneOptions Scene;
  std::optional<std::string> Method;
  std::optional<std::string> ErrorBudget;
  std::optional<double> FrameTime; ///< in milliseconds
  std::optional<std::string> Coincidence;
  std::optional<double> Levels; ///< pixels that points may move by
};

/** A window in which a scene is inspected. */
class Viewer
{
public:
  Viewer(const Scene& scene, const ViewOptions& all, const std::string& firstMethod,
    const Coincidence& tolerance, const AutomaticLimits& limits)
  {
    const SceneOptions& options = all.Scene;
    const PictureSize size = ParseSize(options.Size);
    this->Window->SetSize(size.Width, size.Height);
    this->Window->SetMultiSamples(options.Multisamples);
    this->Window->SetWindowName(("vitrine: " + scene.Name).c_str());
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetBackground(Background, Background, Background);
    this->Renderer->SetActiveCamera(PlaceCamera(scene, ChooseView(options, scene), size.Aspect()));
    AddScalarBar(scene, this->Renderer);
    this->Interactor->SetRenderWindow(this->Window);
    this->Interactor->SetInteractorStyle(this->Style);
    this->Interactor->Initialize(); // from here on no key is missed
    this->View = std::make_unique<Inspector>(
      scene, this->Renderer, ParseMethodList(firstMethod + ",all"), tolerance, limits);
    if (all.Levels)
    {
      this->View->DrawByLevels(*all.Levels);
    }
    this->Style->SetInspector(this->View.get());
  }

  /** Show the window until it is closed. */
  void Run() { this->Interactor->Start(); }

private:
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<InspectorStyle> Style;
  std::unique_ptr<Inspector> View;
};

AutomaticLimits LimitsOf(const ViewOptions& options)
{
  AutomaticLimits limits;
  limits.FrameTime = options.FrameTime.value_or(0.0);
  if (options.ErrorBudget)
  {
    limits.ErrorBudget = ParseErrorBudget(*options.ErrorBudget);
  }
  else if (options.FrameTime)
  {
    limits.ErrorBudget = vtkSeeThroughPass::GetLargestTimedBudget();
  }
  return limits;
}

void ShowScene(const ViewOptions& options)
{
  const Coincidence tolerance = ParseCoincidence(options.Coincidence);
  const AutomaticLimits limits = LimitsOf(options);
  const bool isAutomatic = options.ErrorBudget || options.FrameTime;
  const std::string method = options.Method.value_or(isAutomatic ? AutomaticName : "linked-list");
  const char* display = std::getenv("DISPLAY");
  if (!display || !*display)
  {
    throw RuntimeError("view needs a display, and DISPLAY is not set; render needs none");
  }
  const Scene scene = LoadScene(options.Scene);
  RequireFewLights(scene, MostLightsOfVTK);
  Viewer(scene, options, method, tolerance, limits).Run();
}
}

void AddViewCommand(CLI::App& app)
{
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command =
    app.add_subcommand("view", "Inspect a scene in a window, by the mouse and keys");
  AddSceneOptions(*command, options->Scene, "1024x768");
  AddScalarBarOption(*command, options->Scene);
  command
    ->add_option("--method", options->Method,
      "the method to begin with; linked-list, or automatic with --error or --frame-ms")
    ->type_name("M");
  AddErrorBudgetOption(*command, options->ErrorBudget);
  command
    ->add_option("--frame-ms", options->FrameTime,
      "milliseconds of a frame: automatic takes the least error with which frames take no longer, "
      "up to --error")
    ->type_name("MS")
    ->check(NumberWithin(0.001, 60000.0));
  AddCoincidenceOption(*command, options->Coincidence);
  command
    ->add_option("--levels", options->Levels,
      "draw many parts at levels of detail while the camera moves; no point moves by more pixels")
    ->type_name("PIXELS")
    ->check(NumberWithin(0.001, 64.0));
  command->footer("Keys and the mouse:\n" + DescribeKeys() + "\n\nMethods:\n" + DescribeMethods());
  command->callback([options] { ShowScene(*options); });
}

}
