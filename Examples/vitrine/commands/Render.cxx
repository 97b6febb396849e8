#include "commands/Commands.h"

#include "Errors.h"
#include "OutputPicture.h"
#include "Progress.h"
#include "commands/Options.h"
#include "scene/Viewpoint.h"

#include "vtkHeadlessRenderWindow.h"

#include <memory>

namespace program
{

namespace
{
struct RenderOptions
{
  SceneOptions Scene;
  std::string Output;
  std::optional<std::string> Method;
  std::optional<std::string> ErrorBudget;
  std::optional<std::string> Coincidence;
};

void Render(const RenderOptions& options)
{
  vtkHeadlessRenderWindow::InstallOverride();
  Progress progress;
  CheckPicturePath(options.Output);
  CheckIsNoInput(options.Output, options.Scene.Inputs);
  const PictureSize size = ParseSize(options.Scene.Size);
  std::unique_ptr<Method> method = MakeMethod(options.Method, options.ErrorBudget);
  const std::string problem = method->SetCoincidence(ParseCoincidence(options.Coincidence));
  if (!problem.empty())
  {
    throw InputError("--coincidence", "not by method '" + *options.Method + "': " + problem);
  }
  progress.Show("reading the scene");
  const Scene scene = LoadScene(options.Scene);

  PrintOmissions(scene);
  progress.Show("drawing");
  Stage stage(scene, std::move(method), size, options.Scene.Multisamples);
  stage.Draw(PlaceCamera(scene, ChooseView(options.Scene, scene), size.Aspect()));
  WritePicture(options.Output, stage.ReadPixels(), size);
  progress.Hide();
  PrintBudgetProblem(stage.GetMethod().Statistics());
}
}

void AddRenderCommand(CLI::App& app)
{
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Draw a scene into a picture");
  AddSceneOptions(*command, options->Scene, "1024x768");
  AddScalarBarOption(*command, options->Scene);
  command->add_option("-o,--output", options->Output, "the picture")
    ->type_name("FILE.png")
    ->required();
  command
    ->add_option("--method", options->Method,
      "how translucent geometry is drawn; linked-list, or automatic with --error")
    ->type_name("M");
  AddErrorBudgetOption(*command, options->ErrorBudget);
  AddCoincidenceOption(*command, options->Coincidence);
  command->footer("Methods:\n" + DescribeMethods());
  command->callback([options] { Render(*options); });
}

}
