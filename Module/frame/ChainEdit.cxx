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
#include <cstddef>
#include <utility>

namespace vitrine
{

namespace
{

using PassPointer = vtkSmartPointer<vtkRenderPass>;

/** Sets the only delegate of a pass. Returns false if passes of its class have none or several. */
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
  const bool handsOver = !vtkRenderStepsPass::SafeDownCast(pass) && !pass->IsA("vtkShadowMapPass");
  const std::vector<vtkRenderPass*> delegates = TraitsOf(pass).Delegates;
  return handsOver && delegates.size() == 1 ? delegates.front() : nullptr;
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

/** Returns the index behind the last pass that draws opaque geometry, or 0 if there is none. */
std::size_t EndOfOpaque(const std::vector<PassPointer>& passes)
{
  std::size_t end = passes.size();
  while (end > 0 && !DrawsOpaqueParts(passes[end - 1]))
  {
    --end;
  }
  return end;
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

bool ChainEdit::Replace(vtkRenderPass* parent, vtkRenderPass* before, vtkRenderPass* after)
{
  if (!parent)
  {
    this->RootPass = after;
  }
  else if (auto* const sequence = vtkSequencePass::SafeDownCast(parent))
  {
    Passes passes = PassesOf(sequence);
    std::replace(passes.begin(), passes.end(), PassPointer(before), PassPointer(after));
    this->SetPasses(sequence, passes);
  }
  else if (SetDelegate(parent, after))
  {
    this->Undo.push_back([parent, old = PassPointer(before)] { SetDelegate(parent, old); });
  }
  else
  {
    return false;
  }
  return true;
}

bool ChainEdit::PutTranslucentStep(vtkRenderPass* step)
{
  if (this->PutInPlace(step, this->RootPass, nullptr))
  {
    return true;
  }
  const Place drawing = DrawingPlaceOf(this->RootPass);
  const PassTraits traits = TraitsOf(drawing.Pass);
  return traits.DrawsOpaque && traits.HasWindowPixels &&
    this->Replace(drawing.Parent, drawing.Pass, InSequence({ drawing.Pass, step }));
}

bool ChainEdit::PutInPlace(vtkRenderPass* step, vtkRenderPass* pass, vtkRenderPass* parent)
{
  if (auto* const steps = vtkRenderStepsPass::SafeDownCast(pass))
  {
    this->Undo.push_back(
      [steps, old = PassPointer(steps->GetTranslucentPass())] { steps->SetTranslucentPass(old); });
    steps->SetTranslucentPass(step);
    return true;
  }
  if (auto* const sequence = vtkSequencePass::SafeDownCast(pass))
  {
    return this->PutIntoSequence(step, sequence);
  }
  const PassTraits traits = TraitsOf(pass);
  if (traits.DrawsTranslucent)
  {
    return this->Replace(parent, pass, step);
  }
  if (IsExactly<vtkDefaultPass>(pass))
  {
    return this->Replace(parent, pass,
      InSequence(
        { vtkNew<vtkOpaquePass>(), step, vtkNew<vtkVolumetricPass>(), vtkNew<vtkOverlayPass>() }));
  }
  return traits.Delegates.size() == 1 && this->PutInPlace(step, traits.Delegates.front(), pass);
}

bool ChainEdit::PutIntoSequence(vtkRenderPass* step, vtkSequencePass* sequence)
{
  const std::size_t end = EndOfOpaque(PassesOf(sequence));
  vtkNew<vtkSequencePass> nothing;
  bool isPlaced = false;
  bool isTooEarly = false;
  const Passes before = PassesOf(sequence);
  for (std::size_t i = 0; i < before.size() && !isPlaced; ++i)
  {
    // Opaque geometry that is drawn later would cover the translucent step.
    isTooEarly = i + 1 < end;
    isPlaced = this->PutInPlace(isTooEarly ? nothing.Get() : step, before[i], sequence);
  }
  const bool isMissing = isTooEarly || !isPlaced;
  if (isMissing && end > 0)
  {
    Passes passes = PassesOf(sequence);
    passes.insert(passes.begin() + static_cast<std::ptrdiff_t>(end), step);
    this->SetPasses(sequence, passes);
    isPlaced = true;
  }
  return isPlaced;
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
  this->Undo.push_back([lights] { lights->SetDelegatePass(nullptr); });
  lights->SetDelegatePass(drawing.Pass);
  [[maybe_unused]] const bool isPlaced = this->Replace(drawing.Parent, drawing.Pass, lights);
  assert(isPlaced); // SetDelegate() knows each pass that DrawingPlaceOf() goes through.
}

}
