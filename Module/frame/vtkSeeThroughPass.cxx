#include "vtkSeeThroughPass.h"

#include "Core/budget/FrameTimeBudget.h"
#include "frame/ChainEdit.h"
#include "frame/FrameClock.h"
#include "frame/RendererFlags.h"
#include "frame/ScopedShareOfLights.h"
#include "gl/VitrineOpenGL.h"
#include "scene/PassTraits.h"
#include "scene/Settings.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkClusteredLightsPass.h"
#include "vtkCommand.h"
#include "vtkDistributedTransparencyPass.h"
#include "vtkErrorBudgetTransparencyPass.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkSequencePass.h"
#include "vtkSmartPointer.h"
#include "vtkTransparencyPass.h"
#include "vtkWeakPointer.h"

#include <array>
#include <functional>
#include <sstream>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkSeeThroughPass);

namespace
{

/** The largest error budget for a frame time if no other was set. */
constexpr double LargestTimedBudget = 32.0 / 255.0;

// A renderer serves a hardware selector itself, but only if no pass is set. With a pass it leaves all drawing to the
// pass, and no pass of VTK serves selectors.
void RenderForSelector(vtkRenderer* renderer)
{
  const vtkSmartPointer<vtkRenderPass> pass = renderer->GetPass();
  renderer->SetPass(nullptr);
  renderer->DeviceRender();
  renderer->SetPass(pass);
}

/** Tells the camera whether the window draws in stereo. No pass of VTK does so. */
void TellCameraOfStereo(vtkRenderer* renderer)
{
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window || !renderer->IsActiveCameraCreated() ||
    renderer->GetActiveCamera()->GetStereo() == window->GetStereoRender())
  {
    return;
  }
  window->MakeCurrent();
  vtkOpenGLState* const state = window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(state);
  const vtkOpenGLState::ScopedglScissor scissor(state);
  const vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  renderer->GetActiveCamera()->Render(renderer);
}

// vtkCameraPass does not tell the camera that the window is in stereo, so both eyes would see the same picture. A
// renderer without a pass tells it when it updates the camera; that also sets the viewport and clears.
class EyeCameraPass : public vtkCameraPass
{
public:
  static EyeCameraPass* New() { VTK_STANDARD_NEW_BODY(EyeCameraPass); }
  vtkTypeMacro(EyeCameraPass, vtkCameraPass);

  void Render(const vtkRenderState* s) override
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(s->GetRenderer()->GetRenderWindow());
    vtkRenderer* renderer = s->GetRenderer();
    if (s->GetFrameBuffer() || !window || !renderer->IsActiveCameraCreated() || !this->DelegatePass)
    {
      this->Superclass::Render(s);
      return;
    }
    window->MakeCurrent();
    vtkOpenGLState* state = window->GetState();
    const vtkOpenGLState::ScopedglViewport viewport(state);
    const vtkOpenGLState::ScopedglScissor scissor(state);
    const vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
    renderer->GetActiveCamera()->Render(renderer);
    this->DelegatePass->Render(s);
    this->NumberOfRenderedProps = this->DelegatePass->GetNumberOfRenderedProps();
  }
};

vitrine::PassTraits TraitsOfFrame(vtkRenderPass* pass)
{
  auto* const frame = static_cast<vtkSeeThroughPass*>(pass);
  vitrine::PassTraits traits;
  traits.HasWindowPixels = true;
  traits.Delegates = { frame->GetLightingPass(), frame->GetTranslucentPass() };
  const bool isSetAside = frame->GetSetAsideReason()[0] != '\0';
  if (frame->GetEffectsPass() && !isSetAside)
  {
    traits.Delegates.push_back(frame->GetEffectsPass());
    return traits;
  }
  // The frame's own camera hands drawing to the steps that are listed here.
  const bool hasOwnCamera = EyeCameraPass::SafeDownCast(frame->GetCameraPass()) != nullptr;
  for (vtkRenderPass* const step :
    { hasOwnCamera ? nullptr : static_cast<vtkRenderPass*>(frame->GetCameraPass()),
      frame->GetLightsPass(), frame->GetOpaquePass(), frame->GetVolumetricPass(),
      frame->GetOverlayPass(), frame->GetPostProcessPass() })
  {
    traits.Delegates.push_back(step);
  }
  return traits;
}

/** Event by which a renderer's observers are asked for the pass that is attached to it. */
constexpr unsigned long AskForAttached = vtkCommand::UserEvent + 0x56495452;

/** Keeps a pass alive while a renderer is observed, and tells it when a frame starts. */
class FrameObserver : public vtkCommand
{
public:
  static FrameObserver* New() { return new FrameObserver; }
  void Execute(vtkObject* renderer, unsigned long event, void* data) override
  {
    if (event == AskForAttached)
    {
      *static_cast<vtkSeeThroughPass**>(data) = this->Pass;
      return;
    }
    this->StartFrame(static_cast<vtkRenderer*>(renderer));
  }

  vtkSmartPointer<vtkSeeThroughPass> Pass;
  std::function<void(vtkRenderer*)> StartFrame;
};

/** Returns true if VTK peels volumes and translucent geometry together. Ranks draw volumes each by itself. */
bool PeelsVolumes(vtkOpenGLRenderer* renderer, const vtkRenderState* s, vtkRenderPass* translucent)
{
  auto* const ranks = vtkDistributedTransparencyPass::SafeDownCast(translucent);
  return renderer && (!ranks || ranks->GetNumberOfRanks() == 1) &&
    vitrine::RendererFlags::PeelsVolumes(renderer, s);
}

/** Returns true if `frame` is `chain` or a pass below it. `chain` may be null. */
bool Contains(vtkRenderPass* chain, vtkSeeThroughPass* frame)
{
  return chain &&
    !vitrine::AllPasses(chain, [frame](vtkRenderPass* pass) { return pass != frame; });
}

/** Gives a pass of lights another delegate during its lifetime. */
class ScopedDelegate
{
public:
  ScopedDelegate(vtkClusteredLightsPass* lights, vtkRenderPass* delegate)
    : Lights(lights)
    , Before(lights->GetDelegatePass())
  {
    this->Lights->SetDelegatePass(delegate);
  }
  ~ScopedDelegate() { this->Lights->SetDelegatePass(this->Before); }
  ScopedDelegate(const ScopedDelegate&) = delete;
  void operator=(const ScopedDelegate&) = delete;

private:
  vtkSmartPointer<vtkClusteredLightsPass> Lights;
  vtkSmartPointer<vtkRenderPass> Before;
};

/** Gives a variable another value during its lifetime. */
template <class Value>
class ScopedValue
{
public:
  ScopedValue(Value& variable, Value value)
    : Variable(variable)
    , Before(std::exchange(variable, value))
  {
  }
  ~ScopedValue() { this->Variable = this->Before; }
  ScopedValue(const ScopedValue&) = delete;
  void operator=(const ScopedValue&) = delete;

private:
  Value& Variable;
  Value Before;
};
}

vitrinePassTraitsMacro(vtkSeeThroughPass, TraitsOfFrame);

struct vtkSeeThroughPass::Internals
{
  vtkSmartPointer<vtkClusteredLightsPass> Lighting;
  vtkSmartPointer<vtkRenderPass> Effects;
  vtkSmartPointer<vtkRenderPass> WithoutBudget; ///< The TranslucentPass before SetErrorBudget().
  double FrameTime = 0.0;                       ///< in milliseconds, 0 for none
  double LargestBudget = 0.0; ///< with a frame time: the ErrorBudget that was set, 0 for none
  vtkWeakPointer<vtkErrorBudgetTransparencyPass> Timed; ///< the method that keeps the frame time
  vitrine::FrameTimeBudget Pace;
  vitrine::FrameClock Clock;
  vitrine::RendererFlags Flags;
  std::string FallbackReason; ///< Reason of the frame, not of its method.
  std::string SetAsideReason;
  std::string Text;                     ///< Buffer of the text that GetFallbackReason() returned.
  vtkWeakPointer<vtkRenderer> Renderer; ///< The renderer to which this pass is attached.
  /** Tags of the renderer's observer, which holds this pass. A weak pointer to a vtkCommand would dangle. */
  std::array<unsigned long, 2> Observers{};
  const vtkRenderer* Drawn = nullptr; ///< The renderer whose frame is being drawn.
  bool IsReleasing = false;           ///< ReleaseGraphicsResources() is called.
  bool IsLit = false; ///< The LightingPass draws, and calls this pass to draw the steps.

  /**
   * Returns the pass that the pass contains as its EffectsPass since it was attached later to the same renderer, or
   * null.
   */
  static vtkSeeThroughPass* InnerOf(vtkSeeThroughPass* pass)
  {
    auto* const inner = vtkSeeThroughPass::SafeDownCast(pass->GetEffectsPass());
    const bool isAttached =
      inner && inner->Private->Renderer && inner->Private->Renderer == pass->Private->Renderer;
    return isAttached ? inner : nullptr;
  }

  double LargestTimed() const
  {
    return this->LargestBudget > 0.0 ? this->LargestBudget : LargestTimedBudget;
  }

  /** Has the method keep the budget that the frame time asks for. */
  void BeginTimedFrame(vtkRenderer* renderer)
  {
    this->Pace.Ask(this->FrameTime, this->LargestTimed());
    for (const vitrine::FrameClock::Frame& frame : this->Clock.Begin(renderer))
    {
      this->Pace.NoteFrame(frame.Budget, frame.Milliseconds);
    }
    this->Timed->SetErrorBudget(this->Pace.Budget());
  }

  void TellSetAside(bool isSetAside)
  {
    this->SetAsideReason = isSetAside ? std::string(this->Effects->GetClassName()) +
        " is set aside: no step for translucent geometry is known in it"
                                      : std::string();
  }
};

//------------------------------------------------------------------------------
vtkSeeThroughPass::vtkSeeThroughPass()
  : Private(new Internals)
{
  vtkNew<EyeCameraPass> camera;
  camera->SetDelegatePass(this->SequencePass);
  this->SetCameraPass(camera);
  vtkNew<vtkLinkedListTransparencyPass> linkedList;
  this->SetTranslucentPass(linkedList);
}

//------------------------------------------------------------------------------
vtkSeeThroughPass::~vtkSeeThroughPass() = default;

//------------------------------------------------------------------------------
void vtkSeeThroughPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LightingPass: " << this->GetLightingPass() << "\n";
  os << indent << "ErrorBudget: " << this->GetErrorBudget() << "\n";
  os << indent << "FrameTime: " << this->GetFrameTime() << "\n";
  os << indent << "MeasuredFrameTime: " << this->GetMeasuredFrameTime() << "\n";
  os << indent << "FrameTimeProblem: " << this->GetFrameTimeProblem() << "\n";
  os << indent << "EffectsPass: " << this->GetEffectsPass() << "\n";
  os << indent << "FallbackReason: " << this->GetFallbackReason() << "\n";
  os << indent << "SetAsideReason: " << this->GetSetAsideReason() << "\n";
}

//------------------------------------------------------------------------------
void vtkSeeThroughPass::SetLightingPass(vtkClusteredLightsPass* lights)
{
  if (this->Private->Lighting == lights)
  {
    return;
  }
  if (Contains(lights, this))
  {
    vtkErrorMacro(
      "SetLightingPass() was given a pass that draws this pass; it is ignored. Call its "
      "SetDelegatePass(nullptr) before, or set it on the renderer instead");
    return;
  }
  this->Private->Lighting = lights;
  this->Modified();
}

//------------------------------------------------------------------------------
vtkClusteredLightsPass* vtkSeeThroughPass::GetLightingPass()
{
  return this->Private->Lighting;
}

//------------------------------------------------------------------------------
void vtkSeeThroughPass::SetErrorBudget(double budget)
{
  Internals& in = *this->Private;
  auto* const current = vtkErrorBudgetTransparencyPass::SafeDownCast(this->TranslucentPass);
  if (budget == 0.0)
  {
    in.FrameTime = 0.0;
    const vtkSmartPointer<vtkRenderPass> before = std::exchange(in.WithoutBudget, nullptr);
    if (current)
    {
      this->SetTranslucentPass(
        before ? before.Get() : vtkNew<vtkLinkedListTransparencyPass>().Get());
    }
    return;
  }
  const auto method = current ? vtkSmartPointer<vtkErrorBudgetTransparencyPass>(current)
                              : vtkSmartPointer<vtkErrorBudgetTransparencyPass>::New();
  method->SetErrorBudget(budget); // which tells why it refuses a budget
  if (method->GetErrorBudget() != budget)
  {
    return;
  }
  in.LargestBudget = budget;
  if (!current)
  {
    in.WithoutBudget = this->TranslucentPass;
    this->SetTranslucentPass(method);
  }
}

//------------------------------------------------------------------------------
double vtkSeeThroughPass::GetErrorBudget()
{
  auto* const method = vtkErrorBudgetTransparencyPass::SafeDownCast(this->TranslucentPass);
  return !method ? 0.0 : this->IsTimed() ? this->Private->LargestTimed() : method->GetErrorBudget();
}

//------------------------------------------------------------------------------
// The method may have been replaced since. A chain in which this pass is drawn replaces it for a frame.
bool vtkSeeThroughPass::IsTimed() const
{
  const Internals& in = *this->Private;
  return in.FrameTime > 0.0 && in.Timed && in.Timed == this->TranslucentPass;
}

//------------------------------------------------------------------------------
void vtkSeeThroughPass::SetFrameTime(double milliseconds)
{
  Internals& in = *this->Private;
  if (!vitrine::NotNegative.Has(milliseconds))
  {
    vtkErrorMacro("FrameTime cannot be "
      << vitrine::NumberText(milliseconds)
      << ". It is a finite number of milliseconds, or 0 for none");
    return;
  }
  if (!this->IsTimed())
  {
    in.FrameTime = 0.0; // another method was set since
  }
  if (milliseconds == in.FrameTime)
  {
    return;
  }
  if (milliseconds == 0.0)
  {
    in.FrameTime = 0.0;
    this->SetErrorBudget(in.LargestBudget);
  }
  else if (!this->IsTimed())
  {
    const double largest = this->GetErrorBudget();
    this->SetErrorBudget(largest > 0.0 ? largest : LargestTimedBudget);
    in.LargestBudget = largest;
    in.Timed = vtkErrorBudgetTransparencyPass::SafeDownCast(this->TranslucentPass);
  }
  in.FrameTime = milliseconds;
  this->Modified();
}

//------------------------------------------------------------------------------
double vtkSeeThroughPass::GetFrameTime()
{
  return this->IsTimed() ? this->Private->FrameTime : 0.0;
}

//------------------------------------------------------------------------------
double vtkSeeThroughPass::GetLargestTimedBudget()
{
  return LargestTimedBudget;
}

//------------------------------------------------------------------------------
double vtkSeeThroughPass::GetMeasuredFrameTime()
{
  return this->IsTimed() ? this->Private->Pace.Milliseconds() : 0.0;
}

//------------------------------------------------------------------------------
std::string vtkSeeThroughPass::GetFrameTimeProblem()
{
  const Internals& in = *this->Private;
  const double measured = this->GetMeasuredFrameTime();
  if (measured <= in.FrameTime)
  {
    return {};
  }
  std::ostringstream text;
  text.precision(3);
  text << "frames take " << measured << " ms, not " << in.FrameTime << " ms";
  if (in.Pace.IsTooSlow())
  {
    text << ", with any error of up to " << 255.0 * in.LargestTimed() << "/255";
  }
  return text.str();
}

//------------------------------------------------------------------------------
void vtkSeeThroughPass::SetEffectsPass(vtkRenderPass* chain)
{
  if (Contains(chain, this))
  {
    vtkErrorMacro(
      "SetEffectsPass() was given a chain of passes that contains this pass; it is ignored");
    return;
  }
  Internals& in = *this->Private;
  if (in.Effects == chain)
  {
    return;
  }
  in.Effects = chain;
  vtkNew<vtkSequencePass> step; // Any pass serves as the step here.
  in.TellSetAside(chain && !vitrine::ChainEdit(chain).PutTranslucentStep(step));
  this->Modified();
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkSeeThroughPass::GetEffectsPass()
{
  return this->Private->Effects;
}

//------------------------------------------------------------------------------
const char* vtkSeeThroughPass::GetFallbackReason()
{
  Internals& in = *this->Private;
  auto* const method = vtkTransparencyPass::SafeDownCast(this->TranslucentPass);
  in.Text = in.FallbackReason.empty() && method ? method->GetFallbackReason() : in.FallbackReason;
  return in.Text.c_str();
}

//------------------------------------------------------------------------------
const char* vtkSeeThroughPass::GetSetAsideReason()
{
  return this->Private->SetAsideReason.c_str();
}

//------------------------------------------------------------------------------
void vtkSeeThroughPass::Attach(vtkRenderer* renderer)
{
  this->Detach();
  if (!renderer)
  {
    vtkErrorMacro("Attach() takes a renderer");
    return;
  }
  Internals& in = *this->Private;
  vtkNew<FrameObserver> observer;
  observer->Pass = this;
  observer->StartFrame = [this](vtkRenderer* started) { this->StartFrame(started); };
  in.Observers = { renderer->AddObserver(vtkCommand::StartEvent, observer),
    renderer->AddObserver(AskForAttached, observer) };
  in.Renderer = renderer;
  vtkRenderPass* const given = renderer->GetPass();
  if (given && !Contains(given, this))
  {
    this->SetEffectsPass(given);
  }
  if (!Contains(given, this))
  {
    renderer->SetPass(this);
  }
}

//------------------------------------------------------------------------------
void vtkSeeThroughPass::Detach()
{
  Internals& in = *this->Private;
  vtkRenderer* const renderer = in.Renderer;
  if (!renderer)
  {
    return;
  }
  // The observer may hold the last reference to this pass.
  const vtkSmartPointer<vtkSeeThroughPass> alive = this;
  const vtkSmartPointer<vtkRenderPass> effects = in.Effects;
  vtkSeeThroughPass* outer = GetAttached(renderer);
  in.Renderer = nullptr;
  while (outer && outer->GetEffectsPass() != this)
  {
    outer = vtkSeeThroughPass::SafeDownCast(outer->GetEffectsPass());
  }
  if (outer)
  {
    outer->SetEffectsPass(effects);
  }
  if (renderer->GetPass() == this)
  {
    renderer->SetPass(effects);
  }
  this->SetEffectsPass(nullptr);
  for (const unsigned long observer : in.Observers)
  {
    renderer->RemoveObserver(observer);
  }
}

//------------------------------------------------------------------------------
// Observers answer in the order in which they were added, so the last one's answer stays.
vtkSeeThroughPass* vtkSeeThroughPass::GetAttached(vtkRenderer* renderer)
{
  vtkSeeThroughPass* attached = nullptr;
  if (renderer)
  {
    renderer->InvokeEvent(AskForAttached, &attached);
  }
  return attached;
}

//------------------------------------------------------------------------------
// Takes in the pass that the application set on the renderer since its last frame. A chain that contains this pass
// draws the frame as it is.
void vtkSeeThroughPass::StartFrame(vtkRenderer* renderer)
{
  vtkRenderPass* const given = renderer->GetPass();
  if (this != GetAttached(renderer) || vtkSeeThroughPass::SafeDownCast(given) ||
    Contains(given, this))
  {
    return;
  }
  vtkSeeThroughPass* taker = this;
  vtkSeeThroughPass* inner = Internals::InnerOf(taker);
  while (inner && !Contains(given, inner))
  {
    taker = inner;
    inner = Internals::InnerOf(taker);
  }
  taker->SetEffectsPass(given);
  renderer->SetPass(this);
}

//------------------------------------------------------------------------------
void vtkSeeThroughPass::Render(const vtkRenderState* s)
{
  Internals& in = *this->Private;
  if (in.IsLit)
  {
    this->RenderSteps(s);
    return;
  }
  if (s->GetRenderer()->GetSelector())
  {
    RenderForSelector(s->GetRenderer());
    return;
  }
  if (in.Drawn == s->GetRenderer())
  {
    vtkErrorMacro(
      "this pass is among its own delegates, which draw nothing more; take it out of them");
    return;
  }
  const ScopedValue<const vtkRenderer*> drawn(in.Drawn, s->GetRenderer());
  const bool isTimed = this->IsTimed();
  if (isTimed)
  {
    in.BeginTimedFrame(s->GetRenderer());
  }
  const vitrine::ScopedShareOfLights share(in.Lighting, this->TranslucentPass);
  in.FallbackReason.clear();
  if (!in.Effects || !this->RenderChain(s))
  {
    this->RenderOwnFrame(s);
  }
  if (isTimed)
  {
    in.Clock.End(in.Pace.Budget());
  }
}

//------------------------------------------------------------------------------
// Returns false, and draws nothing, if the chain has no place for the translucent step.
bool vtkSeeThroughPass::RenderChain(const vtkRenderState* s)
{
  Internals& in = *this->Private;
  vitrine::ChainEdit chain(in.Effects);
  vtkNew<vtkSequencePass> nothing;
  // The application may have changed the chain since it was set.
  const bool hasPlace =
    chain.PutTranslucentStep(this->TranslucentPass ? this->TranslucentPass : nothing.Get());
  in.TellSetAside(!hasPlace);
  if (!hasPlace)
  {
    return false;
  }
  if (in.Lighting)
  {
    chain.PutLights(in.Lighting);
  }
  TellCameraOfStereo(s->GetRenderer());
  chain.Root()->Render(s);
  this->NumberOfRenderedProps = chain.Root()->GetNumberOfRenderedProps();
  return true;
}

//------------------------------------------------------------------------------
void vtkSeeThroughPass::RenderOwnFrame(const vtkRenderState* s)
{
  Internals& in = *this->Private;
  auto* const renderer = vtkOpenGLRenderer::SafeDownCast(s->GetRenderer());
  const bool peelsVolumes = PeelsVolumes(renderer, s, this->TranslucentPass);
  if (peelsVolumes)
  {
    in.FallbackReason =
      "UseDepthPeelingForVolumes is on, so VTK peels translucent geometry and volumes together";
    in.FallbackReason += in.Lighting ? ", and lights them without the LightingPass" : "";
  }
  // The peeled volumes look up the renderer's lights.
  if (!in.Lighting || peelsVolumes)
  {
    this->RenderSteps(s);
    return;
  }
  const ScopedValue<bool> lit(in.IsLit, true);
  const ScopedDelegate drawing(in.Lighting, this);
  in.Lighting->Render(s);
}

//------------------------------------------------------------------------------
// Follows vtkOpenGLRenderer::UpdateGeometry(). Without flags of the renderer it equals vtkRenderStepsPass::Render().
void vtkSeeThroughPass::RenderSteps(const vtkRenderState* s)
{
  Internals& in = *this->Private;
  auto* const renderer = vtkOpenGLRenderer::SafeDownCast(s->GetRenderer());
  const bool peelsVolumes = PeelsVolumes(renderer, s, this->TranslucentPass);
  vtkRenderPassCollection* const passes = this->SequencePass->GetPasses();
  passes->RemoveAllItems();
  for (vtkRenderPass* const step : { this->LightsPass,
         renderer ? in.Flags.OpaqueStep(renderer, this->OpaquePass) : this->OpaquePass,
         peelsVolumes ? in.Flags.PeelingStep() : this->TranslucentPass,
         renderer ? in.Flags.SmoothingStep(renderer) : nullptr,
         peelsVolumes ? in.Flags.UnpeeledStep(this->VolumetricPass) : this->VolumetricPass,
         this->OverlayPass })
  {
    if (step)
    {
      passes->AddItem(step);
    }
  }
  this->NumberOfRenderedProps = 0;
  for (vtkRenderPass* const pass :
    { static_cast<vtkRenderPass*>(this->CameraPass), this->PostProcessPass })
  {
    if (pass)
    {
      pass->Render(s);
      this->NumberOfRenderedProps += pass->GetNumberOfRenderedProps();
    }
  }
}

//------------------------------------------------------------------------------
void vtkSeeThroughPass::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& in = *this->Private;
  if (in.IsReleasing) // a delegate draws this pass
  {
    return;
  }
  const ScopedValue<bool> releasing(in.IsReleasing, true);
  in.Clock.Release();
  in.Flags.ReleaseGraphicsResources(window);
  for (vtkRenderPass* const pass :
    { static_cast<vtkRenderPass*>(in.Lighting.Get()), in.Effects.Get(), in.WithoutBudget.Get() })
  {
    if (pass)
    {
      pass->ReleaseGraphicsResources(window);
    }
  }
  this->Superclass::ReleaseGraphicsResources(window);
}
