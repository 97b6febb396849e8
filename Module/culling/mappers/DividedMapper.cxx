#include "culling/mappers/DividedMapper.h"

#include "scene/ClassName.h"
#include "vtkCulledCompositePolyDataMapper.h"
#include "vtkCulledPolyDataMapper.h"

#include "vtkActor.h"

namespace vitrine
{

ShownParts::ShownParts(const ViewMatrices& view, vtkActor* actor,
  std::shared_ptr<const MapperParts> parts, std::vector<std::uint8_t> shown)
  : View(view)
  , Parts(std::move(parts))
  , IsShown(std::move(shown))
{
  actor->GetMatrix(this->ToWorld.data());
}

bool ShownParts::IsOf(vtkRenderer* renderer, vtkActor* actor) const
{
  std::array<double, 16> toWorld;
  actor->GetMatrix(toWorld.data());
  return toWorld == this->ToWorld && ViewMatricesOf(renderer) == this->View;
}

void DividedMapper::SetShown(
  vtkRenderer* renderer, vtkActor* actor, const std::shared_ptr<const ShownParts>& shown)
{
  this->Told[{ renderer, actor }] = shown;
  if (this->Told.size() > this->MostTold)
  {
    this->ForgetWhatWasTakenBack();
    this->MostTold = 2 * this->Told.size();
  }
}

void DividedMapper::ForgetWhatWasTakenBack()
{
  for (auto i = this->Told.begin(); i != this->Told.end();)
  {
    i = i->second.expired() ? this->Told.erase(i) : std::next(i);
  }
}

std::shared_ptr<const ShownParts> DividedMapper::ShownIn(
  vtkRenderer* renderer, vtkActor* actor) const
{
  const auto told = this->Told.find({ renderer, actor });
  const std::shared_ptr<const ShownParts> shown =
    told == this->Told.end() ? nullptr : told->second.lock();
  return shown && !renderer->GetSelector() && shown->IsOf(renderer, actor) ? shown : nullptr;
}

DividedMapper* DividedMapperOf(vtkMapper* mapper)
{
  if (IsExactly<vtkCulledCompositePolyDataMapper>(mapper))
  {
    return static_cast<vtkCulledCompositePolyDataMapper*>(mapper)->GetDividedMapper();
  }
  return IsExactly<vtkCulledPolyDataMapper>(mapper)
    ? static_cast<vtkCulledPolyDataMapper*>(mapper)->GetDividedMapper()
    : nullptr;
}

}
