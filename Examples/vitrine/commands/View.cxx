#include "commands/Commands.h"

#include "Errors.h"
#include "commands/Options.h"
#include "scene/ColorBy.h"
#include "scene/Viewpoint.h"

#include "vtkCallbackCommand.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkRenderPass.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <cstdlib>
#include <memory>

namespace program
{

namespace
{
/** A window in which number keys switch methods. */
class Viewer
{
public:
  Viewer(const Scene& scene, const SceneOptions& options, const std::string& firstMethod,
    const Coincidence& tolerance)
    : Names(ParseMethodList(firstMethod + ",all"))
    , Tolerance(tolerance)
  {
    const PictureSize size = ParseSize(options.Size);
    this->Window->SetSize(size.Width, size.Height);
    this->Window->SetMultiSamples(options.Multisamples);
    this->Window->SetWindowName(("vitrine: " + scene.Name).c_str());
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetBackground(Background, Background, Background);
    const std::vector<vtkSmartPointer<vtkActor>> actors = AddActors(scene, this->Renderer);
    CutSections(scene, actors, this->Renderer);
    ShowLooks(scene, actors, this->Renderer);
    AddScalarBar(scene, this->Renderer);
    SetLights(scene.Lights, this->Renderer);
    this->Renderer->SetActiveCamera(PlaceCamera(scene, ChooseView(options, scene), size.Aspect()));
    this->Renderer->ResetCameraClippingRange();
    this->Label->GetTextProperty()->SetColor(0.1, 0.1, 0.1);
    this->Label->GetTextProperty()->SetFontSize(16);
    this->Label->SetPosition(10, 10);
    this->Renderer->AddActor2D(this->Label);
  }

  /** Show the window until it is closed. */
  void Run()
  {
    vtkNew<vtkInteractorStyleTrackballCamera> style;
    vtkNew<vtkRenderWindowInteractor> interactor;
    interactor->SetRenderWindow(this->Window);
    interactor->SetInteractorStyle(style);
    this->Keys->SetClientData(this);
    this->Keys->SetCallback(OnKey);
    interactor->AddObserver(vtkCommand::CharEvent, this->Keys, /* priority= */ 1.0f);
    this->Use(0);
    this->Window->Render();
    interactor->Start();
  }

private:
  static void OnKey(vtkObject* caller, unsigned long, void* viewer, void*)
  {
    const char key = static_cast<vtkRenderWindowInteractor*>(caller)->GetKeyCode();
    auto* self = static_cast<Viewer*>(viewer);
    const std::size_t index = static_cast<std::size_t>(key - '1');
    if (key >= '1' && index < self->Names.size())
    {
      self->Keys->AbortFlagOn(); // VTK's own meaning of the key, as stereo of 3
      self->Use(index);
      self->Window->Render();
    }
  }

  void Use(std::size_t index)
  {
    if (vtkRenderPass* former = this->Renderer->GetPass())
    {
      former->ReleaseGraphicsResources(this->Window);
    }
    std::unique_ptr<Method> method = MakeMethod(this->Names[index]);
    const std::string problem = method->SetCoincidence(this->Tolerance);
    method->Attach(this->Renderer);
    this->Current = std::move(method);
    std::string text = this->Names[index] + (problem.empty() ? "" : ", " + problem) + "   (keys:";
    for (std::size_t i = 0; i < this->Names.size(); ++i)
    {
      text += " " + std::to_string(i + 1) + " " + this->Names[i];
    }
    this->Label->SetInput((text + ", q ends)").c_str());
  }

  std::vector<std::string> Names;
  Coincidence Tolerance;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkTextActor> Label;
  vtkNew<vtkCallbackCommand> Keys;
  std::unique_ptr<Method> Current;
};

struct ViewOptions
{
  SceneOptions Scene;
  std::string Method = "linked-list";
  std::optional<std::string> Coincidence;
};

void ShowScene(const ViewOptions& options)
{
  const Coincidence tolerance = ParseCoincidence(options.Coincidence);
  const char* display = std::getenv("DISPLAY");
  if (!display || !*display)
  {
    throw RuntimeError("view needs a display, and DISPLAY is not set; render needs none");
  }
  const Scene scene = LoadScene(options.Scene);
  RequireFewLights(scene, MostLightsOfVTK);
  Viewer(scene, options.Scene, options.Method, tolerance).Run();
}
}

void AddViewCommand(CLI::App& app)
{
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command = app.add_subcommand("view", "Show a scene in a window; keys switch methods");
  AddSceneOptions(*command, options->Scene, "1024x768");
  AddScalarBarOption(*command, options->Scene);
  command->add_option("--method", options->Method, "the method to begin with")
    ->type_name("M")
    ->capture_default_str();
  AddCoincidenceOption(*command, options->Coincidence);
  command->footer("Methods:\n" + DescribeMethods());
  command->callback([options] { ShowScene(*options); });
}

}
