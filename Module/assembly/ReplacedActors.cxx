#include "assembly/ReplacedActors.h"

#include "assembly/PartLooks.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCulledCompositePolyDataMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"

#include <algorithm>

namespace vitrine
{

namespace
{

/** Returns when the looks or places of the parts of an actor, which shows `data`, changed last. */
vtkMTimeType LooksTimeOf(vtkActor* actor, vtkDataObject* data)
{
  vtkMTimeType newest =
    std::max(actor->GetProperty()->GetMTime(), actor->GetShaderProperty()->GetMTime());
  if (vtkCompositeDataDisplayAttributes* const attributes = AttributesOf(actor))
  {
    newest = std::max(newest, attributes->GetMTime());
  }
  if (data)
  {
    newest = std::max(newest, data->GetMTime());
  }
  if (vtkMatrix4x4* const matrix = actor->GetUserMatrix())
  {
    newest = std::max(newest, matrix->GetMTime());
  }
  return newest;
}

/** Returns true if an actor is drawn as assemblies make it, but for the looks of its parts. */
bool IsAsMade(vtkActor* actor)
{
  const auto isAll = [](const double* numbers, double value)
  { return numbers[0] == value && numbers[1] == value && numbers[2] == value; };
  vtkMapper* const mapper = actor->GetMapper();
  vtkPolyData* const alone = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  return isAll(actor->GetPosition(), 0) && isAll(actor->GetOrientation(), 0) &&
    isAll(actor->GetScale(), 1) && !actor->GetTexture() && !actor->GetBackfaceProperty() &&
    actor->GetProperty()->GetNumberOfTextures() == 0 &&
    actor->GetShaderProperty()->GetNumberOfShaderReplacements() == 0 &&
    (!mapper->GetClippingPlanes() || mapper->GetClippingPlanes()->GetNumberOfItems() == 0) &&
    (!mapper->GetScalarVisibility() || (alone && HasColors(alone)));
}
}

vtkCompositeDataDisplayAttributes* AttributesOf(vtkActor* actor)
{
  auto* const mapper = vtkCulledCompositePolyDataMapper::SafeDownCast(actor->GetMapper());
  return mapper ? mapper->GetCompositeDataDisplayAttributes() : nullptr;
}

ReplacedActors::ReplacedActors(
  const DrawnParts& parts, const std::function<bool(vtkPolyData*)>& hasLevels)
{
  for (const vtkSmartPointer<vtkActor>& actor : parts.Actors())
  {
    const ActorState& state = this->States.emplace_back(StateOf(actor));
    this->LooksTime = std::max(this->LooksTime, LooksTimeOf(actor, state.Data));
    if (state.IsPlain)
    {
      this->Actors.insert(actor);
    }
  }
  for (int part = 0; part < parts.Count(); ++part)
  {
    if (!hasLevels(parts.Part(part).Geometry))
    {
      this->Actors.erase(parts.Place(part).Actor);
    }
  }
}

bool ReplacedActors::AreOutdated(const DrawnParts& parts) const
{
  const auto& actors = parts.Actors();
  return !std::equal(actors.begin(), actors.end(), this->States.begin(), this->States.end(),
    [&](vtkActor* actor, const ActorState& state)
    {
      if (state.IsUntouched())
      {
        return LooksTimeOf(actor, state.Data) <= this->LooksTime;
      }
      const ActorState now = StateOf(actor);
      return now == state && LooksTimeOf(actor, now.Data) <= this->LooksTime;
    });
}

ReplacedActors::ActorState ReplacedActors::StateOf(vtkActor* actor)
{
  vtkMapper* const mapper = actor->GetMapper();
  return { actor, actor->vtkObject::GetMTime(), mapper, mapper->vtkObject::GetMTime(),
    mapper->GetInputDataObject(0, 0), actor->GetProperty(), actor->GetVisibility() != 0,
    IsAsMade(actor) };
}

bool ReplacedActors::ActorState::IsUntouched() const
{
  return this->Actor->vtkObject::GetMTime() == this->Time &&
    this->Actor->GetMapper() == this->Mapper &&
    this->Mapper->vtkObject::GetMTime() == this->MapperTime;
}

/** Shows or hides the actor for a frame, which is no change of it. */
void ReplacedActors::ActorState::SetVisible(bool isVisible)
{
  const bool isUntouched = this->IsUntouched();
  this->Actor->SetVisibility(isVisible);
  this->Time = isUntouched ? this->Actor->vtkObject::GetMTime() : this->Time;
}

bool ReplacedActors::AreIn(vtkRenderer* renderer) const
{
  return std::all_of(this->Actors.begin(), this->Actors.end(),
    [&](vtkProp* actor) { return actor->IsConsumer(renderer) != 0; });
}

void ReplacedActors::Hide(
  const std::unordered_set<vtkProp*>& exact, std::unordered_set<vtkProp*>& hidden)
{
  for (ActorState& state : this->States)
  {
    if (state.IsVisible && this->Has(state.Actor) && exact.count(state.Actor) == 0)
    {
      state.SetVisible(false);
      hidden.insert(state.Actor);
    }
  }
}

void ReplacedActors::Show(const std::unordered_set<vtkProp*>& hidden)
{
  for (ActorState& state : this->States)
  {
    if (hidden.count(state.Actor) > 0)
    {
      state.SetVisible(true);
    }
  }
}

}
