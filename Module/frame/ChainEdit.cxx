#include "frame/ChainEdit.h"

#include "scene/ClassName.h"
#include "scene/PassTraits.h"

#include "vtkCameraPass.h"
#include "vtkClusteredLightsPass.h"
#include "vtkDefaultPass.h"
#include "vtkImageProcessingPass.h"
#include "vtkNew.h"
#include "vtkOpaquePass.h"
#include "vtkOverlayPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkSeeThroughPass.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapPass.h"
#include "vtkVolumetricPass.h"

#include <algorithm>
#include <cassert>
#include <set>
#include <utility>

namespace vitrine
{

namespace
{

using PassPointer = vtkSmartPointer<vtkRenderPass>;

/**
 * Sets the pass to which `pass` hands drawing, or its opaque drawing if it has several steps. Returns false if passes
 * of its class have none.
 */
bool SetDelegate(vtkRenderPass* pass, vtkRenderPass* delegate)
{
  if (auto* const processing = vtkImageProcessingPass::SafeDownCast(pass))
  {
    processing->SetDelegatePass(delegate);
  }
  else if (auto* const supersampling = vtkSSAAPass::SafeDownCast(pass))
  {
    supersampling->SetDelegatePass(delegate);
  }
  else if (auto* const camera = vtkCameraPass::SafeDownCast(pass))
  {
    camera->SetDelegatePass(delegate);
  }
  else if (auto* const lights = vtkClusteredLightsPass::SafeDownCast(pass))
  {
    lights->SetDelegatePass(delegate);
  }
  else if (auto* const shadows = vtkShadowMapPass::SafeDownCast(pass))
  {
    shadows->SetOpaqueSequence(delegate);
  }
  else if (auto* const steps = vtkRenderStepsPass::SafeDownCast(pass))
  {
    steps->SetOpaquePass(delegate);
  }
  else
  {
    return false;
  }
  return true;
}

vtkSmartPointer<vtkRenderPassCollection> CollectionOf(const std::vector<PassPointer>& passes)
{
  auto collection = vtkSmartPointer<vtkRenderPassCollection>::New();
  for (const PassPointer& pass : passes)
  {
    collection->AddItem(pass);
  }
  return collection;
}

PassPointer InSequence(const std::vector<PassPointer>& passes)
{
  auto sequence = vtkSmartPointer<vtkSequencePass>::New();
  sequence->SetPasses(CollectionOf(passes));
  return sequence;
}

std::vector<PassPointer> PassesOf(vtkSequencePass* sequence)
{
  const std::vector<vtkRenderPass*> delegates = TraitsOf(sequence).Delegates;
  return { delegates.begin(), delegates.end() };
}

/** A pass and its parent, which hands drawing to it. The root has a null parent. */
struct Place
{
  vtkRenderPass* Parent;
  vtkRenderPass* Pass;
};

/** Returns the only pass to which `pass` hands all drawing, or null if there is none or if there are several. */
vtkRenderPass* OnlyDelegateOf(vtkRenderPass* pass)
{
  const PassTraits traits = TraitsOf(pass);
  const bool drawsItself = traits.DrawsOpaque || traits.DrawsTranslucent;
  const bool handsOver = !drawsItself && !vtkRenderStepsPass::SafeDownCast(pass);
  return handsOver && traits.Delegates.size() == 1 ? traits.Delegates.front() : nullptr;
}

/** Finds the pass that draws the scene, below the passes that process its picture or set the camera or the lights. */
Place DrawingPlaceOf(vtkRenderPass* root)
{
  Place place{ nullptr, root };
  while (vtkRenderPass* const delegate = OnlyDelegateOf(place.Pass))
  {
    place = { place.Pass, delegate };
  }
  return place;
}

/** The steps of a chain that draw geometry, found in the order in which they draw. */
class DrawingSteps
{
public:
  explicit DrawingSteps(vtkRenderPass* root) { this->Add({ nullptr, root }); }

  /** Places for a translucent step. The pass of a place is a vtkRenderStepsPass, or draws translucent geometry. */
  std::vector<Place> Translucent;
  /** The last pass that draws opaque geometry. Its pass is null if there is none. */
  Place Opaque{ nullptr, nullptr };
  /** Opaque geometry is drawn after all translucent geometry. */
  bool EndsOpaque = false;

private:
  void Add(const Place& place)
  {
    const PassTraits traits = TraitsOf(place.Pass);
    // Nobody knows what a pass of an unknown class draws, so it stays where it is.
    const bool drawsOpaque = traits.DrawsOpaque && traits.HasWindowPixels;
    if (drawsOpaque)
    {
      this->AddOpaque(place);
    }
    if (traits.DrawsTranslucent || IsExactly<vtkDefaultPass>(place.Pass))
    {
      this->AddTranslucent(place);
    }
    else if (this->Entered.insert(place.Pass).second)
    {
      this->AddBelow(place);
    }
    if (drawsOpaque)
    {
      this->Opaque = place; // It is complete behind all its delegates.
    }
  }

  void AddBelow(const Place& place)
  {
    if (auto* const steps = vtkRenderStepsPass::SafeDownCast(place.Pass))
    {
      if (steps->GetOpaquePass())
      {
        this->Add({ steps, steps->GetOpaquePass() });
      }
      this->AddTranslucent(place);
      return;
    }
    for (vtkRenderPass* const delegate : TraitsOf(place.Pass).Delegates)
    {
      this->Add({ place.Pass, delegate });
    }
  }

  void AddOpaque(const Place& place)
  {
    this->Opaque = place;
    this->EndsOpaque = true;
  }

  void AddTranslucent(const Place& place)
  {
    this->Translucent.push_back(place);
    this->EndsOpaque = false;
  }

  std::set<vtkRenderPass*> Entered; ///< A pass that occurs twice hands work to the same delegates.
};

/** Returns `step` and what else `translucent` draws, which `step` replaces. */
PassPointer InsteadOf(vtkRenderPass* translucent, vtkRenderPass* step)
{
  std::vector<PassPointer> passes{ step };
  if (translucent && IsExactly<vtkDefaultPass>(translucent))
  {
    passes = { vtkNew<vtkOpaquePass>(), step, vtkNew<vtkVolumetricPass>(),
      vtkNew<vtkOverlayPass>() };
  }
  else if (translucent && TraitsOf(translucent).DrawsTranslucent)
  {
    // Passes that peel translucent geometry may hand volumes to a delegate.
    const std::vector<vtkRenderPass*> delegates = TraitsOf(translucent).Delegates;
    passes.insert(passes.end(), delegates.begin(), delegates.end());
  }
  return passes.size() > 1 ? InSequence(passes) : PassPointer(step);
}
}

ChainEdit::ChainEdit(vtkRenderPass* root)
  : RootPass(root)
{
}

ChainEdit::~ChainEdit()
{
  for (auto i = this->Undo.rbegin(); i != this->Undo.rend(); ++i)
  {
    (*i)();
  }
}

void ChainEdit::SetPasses(vtkSequencePass* sequence, const Passes& passes)
{
  this->Undo.push_back(
    [sequence, old = vtkSmartPointer<vtkRenderPassCollection>(sequence->GetPasses())]
    { sequence->SetPasses(old); });
  sequence->SetPasses(CollectionOf(passes));
}

void ChainEdit::Replace(vtkRenderPass* parent, vtkRenderPass* before, vtkRenderPass* after)
{
  if (!parent)
  {
    this->RootPass = after;
  }
  else if (auto* const sequence = vtkSequencePass::SafeDownCast(parent))
  {
    Passes passes = PassesOf(sequence);
    *std::find(passes.rbegin(), passes.rend(), PassPointer(before)) = after;
    this->SetPasses(sequence, passes);
  }
  else
  {
    [[maybe_unused]] const bool isSet = SetDelegate(parent, after);
    assert(isSet);
    this->Undo.push_back([parent, old = PassPointer(before)] { SetDelegate(parent, old); });
  }
}

bool ChainEdit::PutTranslucentStep(vtkRenderPass* step)
{
  const DrawingSteps steps(this->RootPass);
  vtkNew<vtkSequencePass> nothing;
  vtkRenderPass* last = step;
  if (steps.EndsOpaque)
  {
    // Opaque geometry that is drawn later would cover the translucent step.
    const Place& opaque = steps.Opaque;
    this->Replace(opaque.Parent, opaque.Pass, InSequence({ opaque.Pass, step }));
    last = nothing;
  }
  for (auto place = steps.Translucent.rbegin(); place != steps.Translucent.rend(); ++place)
  {
    this->PutAt(place->Parent, place->Pass, last);
    last = nothing;
  }
  return steps.EndsOpaque || !steps.Translucent.empty();
}

void ChainEdit::PutAt(vtkRenderPass* parent, vtkRenderPass* pass, vtkRenderPass* step)
{
  auto* const steps = vtkRenderStepsPass::SafeDownCast(pass);
  if (!steps)
  {
    this->Replace(parent, pass, InsteadOf(pass, step));
    return;
  }
  const PassPointer old = steps->GetTranslucentPass();
  this->Undo.push_back([steps, old] { steps->SetTranslucentPass(old); });
  steps->SetTranslucentPass(InsteadOf(old, step));
}

void ChainEdit::PutLights(vtkClusteredLightsPass* lights)
{
  const Place drawing = DrawingPlaceOf(this->RootPass);
  if (auto* const frame = vtkSeeThroughPass::SafeDownCast(drawing.Pass))
  {
    using LightsPointer = vtkSmartPointer<vtkClusteredLightsPass>;
    this->Undo.push_back(
      [frame, old = LightsPointer(frame->GetLightingPass())] { frame->SetLightingPass(old); });
    frame->SetLightingPass(lights);
    return;
  }
  this->Undo.push_back(
    [lights, old = PassPointer(lights->GetDelegatePass())] { lights->SetDelegatePass(old); });
  lights->SetDelegatePass(drawing.Pass);
  this->Replace(drawing.Parent, drawing.Pass, lights);
}

}
