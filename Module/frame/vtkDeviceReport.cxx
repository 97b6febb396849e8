#include "vtkDeviceReport.h"

#include "gl/Capabilities.h"
#include "gl/VitrineOpenGL.h"
#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDeferredLightsPass.h"
#include "vtkErrorBudgetTransparencyPass.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSeeThroughPass.h"
#include "vtkSmartPointer.h"
#include "vtkTransparencyPass.h"
#include "vtkVersion.h"

#include <iomanip>
#include <sstream>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkDeviceReport);

namespace
{

/** Suppresses VTK's messages while it lives. The report contains what they say. */
class ScopedSilence
{
public:
  ScopedSilence() { vtkObject::GlobalWarningDisplayOff(); }
  ~ScopedSilence() { vtkObject::SetGlobalWarningDisplay(this->Before); }
  ScopedSilence(const ScopedSilence&) = delete;
  void operator=(const ScopedSilence&) = delete;

private:
  int Before = vtkObject::GetGlobalWarningDisplay();
};

/** A scene of two translucent plates in front of an opaque one, with two lights. */
struct Trial
{
  explicit Trial(vtkRenderWindow* window)
    : Window(window)
  {
    this->AddPlate(-1.0, 1.0);
    this->AddPlate(0.0, 0.5);
    this->AddPlate(1.0, 0.5);
    this->Renderer->AutomaticLightCreationOff();
    for (const double x : { -2.0, 2.0 })
    {
      vtkNew<vtkLight> light;
      light->SetLightTypeToSceneLight();
      light->SetPositional(true);
      light->SetPosition(x, 0.0, 4.0);
      this->Renderer->AddLight(light);
    }
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->ResetCamera();
  }

  ~Trial() { this->Window->RemoveRenderer(this->Renderer); }

  Trial(const Trial&) = delete;
  void operator=(const Trial&) = delete;

  /** Draws by a pass, and releases the pass's resources. */
  void Draw(vtkSeeThroughPass* frame)
  {
    this->Renderer->SetPass(frame);
    this->Window->Render();
    frame->ReleaseGraphicsResources(this->Window);
    this->Renderer->SetPass(nullptr);
  }

  vtkRenderWindow* Window;
  vtkNew<vtkRenderer> Renderer;

private:
  void AddPlate(double z, double opacity)
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> faces;
    faces->InsertNextCell(4);
    for (const auto& [x, y] : { std::pair{ -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } })
    {
      faces->InsertCellPoint(points->InsertNextPoint(x, y, z));
    }
    vtkNew<vtkPolyData> plate;
    plate->SetPoints(points);
    plate->SetPolys(faces);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(plate);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetOpacity(opacity);
    this->Renderer->AddActor(actor);
  }
};

std::string TextOf(unsigned int name)
{
  const auto* const text = reinterpret_cast<const char*>(glGetString(name));
  return text ? text : "?";
}

void DescribeDevice(vtkRenderWindow* window, std::ostream& os)
{
  os << "OpenGL: " << TextOf(GL_RENDERER) << ", " << TextOf(GL_VENDOR) << ", " << TextOf(GL_VERSION)
     << ", GLSL " << TextOf(GL_SHADING_LANGUAGE_VERSION) << "\n";
  os << "window: " << window->GetClassName() << ", " << window->GetMultiSamples()
     << " samples a pixel, " << vitrine::SubpixelBits() << " subpixel bits\n";
  os << "extensions:";
  for (const char* const name : { "GL_EXT_shader_framebuffer_fetch",
         "GL_ARB_fragment_shader_interlock", "GL_ARB_post_depth_coverage", "GL_ARB_clip_control" })
  {
    os << " " << name << (vitrine::HasExtension(name) ? " yes," : " no,");
  }
  os << " storage blocks of " << vitrine::LargestStorageBlock() << " bytes\n";
}

// What draws in place of a method. If it is another exact method, the reason names it.
std::string VerdictOn(const std::string& reason, vtkTransparencyPass* method)
{
  if (reason.empty())
  {
    return "works";
  }
  return (method->GetActiveSubstitute().empty() ? "VTK's blending in its place: " : "") + reason;
}

/** What a method chose that has an error budget, and the budgets that such windows keep. */
std::string ChoiceOf(vtkTransparencyPass* method)
{
  auto* const budgeted = vtkErrorBudgetTransparencyPass::SafeDownCast(method);
  if (!budgeted || budgeted->GetChosenMethod().empty())
  {
    return {};
  }
  std::ostringstream text;
  text << ", by " << budgeted->GetChosenMethod() << " with errors of up to " << std::fixed
       << std::setprecision(2) << 255.0 * budgeted->GetGuaranteedError() << "/255";
  return text.str();
}

void DescribeMethods(Trial& trial, std::ostream& os)
{
  std::istringstream names(vtkTransparencyPass::GetMethods());
  for (std::string name; std::getline(names, name, ',');)
  {
    const auto method = vtk::TakeSmartPointer(vtkTransparencyPass::NewMethod(name));
    vtkNew<vtkSeeThroughPass> frame;
    frame->SetTranslucentPass(method);
    trial.Draw(frame);
    const std::string reason = frame->GetFallbackReason();
    os << "method " << name << ": " << VerdictOn(reason, method) << ChoiceOf(method) << "\n";
  }
}

void DescribeClusteredLights(Trial& trial, std::ostream& os)
{
  vtkNew<vtkClusteredLightsPass> lights;
  vtkNew<vtkSeeThroughPass> frame;
  frame->SetLightingPass(lights);
  trial.Draw(frame);
  const std::string reason = lights->GetFallbackReason();
  os << "lights clustered: " << (reason.empty() ? "works" : "VTK's mappers in its place: " + reason)
     << "\n";
}

void DescribeDeferredLights(Trial& trial, std::ostream& os)
{
  vtkNew<vtkDeferredLightsPass> lights;
  vtkNew<vtkSeeThroughPass> frame;
  frame->SetLightingPass(lights);
  trial.Draw(frame);
  const std::string reason = lights->GetFallbackReason();
  const bool works = reason.empty() && lights->GetNumberOfDeferredProps() > 0;
  os << "lights deferred: "
     << (works ? "works"
               : "forward in its place: " + (reason.empty() ? "no prop was deferred" : reason))
     << "\n";
}

/** Returns true if the window has a context of OpenGL, and it is current. */
bool HasOpenGL(vtkRenderWindow* window)
{
  // Without a context there may be no entry points: glad's are null until the first window loads them.
  return vtkOpenGLRenderWindow::SafeDownCast(window) && window->IsCurrent() &&
    glCreateShader != nullptr && glGetString(GL_VERSION);
}
}

//------------------------------------------------------------------------------
std::string vtkDeviceReport::Describe(vtkRenderWindow* window)
{
  std::ostringstream os;
  os << "VTK: " << vtkVersion::GetVTKVersion() << "\n";
  if (!window)
  {
    os << "OpenGL: none without a window\n";
    return os.str();
  }
  const ScopedSilence silence;
  window->SetSize(64, 48);
  Trial trial(window);
  window->Render();
  if (!HasOpenGL(window))
  {
    os << "OpenGL: none in a " << window->GetClassName() << "\n";
    return os.str();
  }
  DescribeDevice(window, os);
  DescribeMethods(trial, os);
  DescribeClusteredLights(trial, os);
  DescribeDeferredLights(trial, os);
  return os.str();
}
