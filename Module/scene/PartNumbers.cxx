#include "scene/PartNumbers.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <memory>
#include <mutex>

namespace vitrine
{

namespace
{

/** The numbers of all renderers. They outlive static objects, since renderers may do so. */
struct Registry
{
  std::mutex Lock;
  std::unordered_map<vtkObject*, std::unique_ptr<PartNumbers>> Numbers;

  static Registry& Instance()
  {
    static Registry* const registry = new Registry;
    return *registry;
  }
};

void ForgetRenderer(vtkObject* renderer, unsigned long, void*, void*)
{
  Registry& registry = Registry::Instance();
  const std::lock_guard<std::mutex> guard(registry.Lock);
  registry.Numbers.erase(renderer);
}
}

vtkDataObject* CompositeDataOf(vtkProp* prop)
{
  vtkActor* const actor = vtkActor::SafeDownCast(prop);
  vtkMapper* const mapper = actor ? actor->GetMapper() : nullptr;
  const bool drawsBlocks = mapper &&
    (mapper->IsA("vtkCompositePolyDataMapper2") || mapper->IsA("vtkCompositePolyDataMapper"));
  return drawsBlocks && mapper->GetNumberOfInputConnections(0) > 0
    ? vtkCompositeDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0))
    : nullptr;
}

vtkDataObject* BlocksOf(vtkProp* prop)
{
#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 3
  vtkActor* const actor = vtkActor::SafeDownCast(prop);
  if (actor && actor->GetMapper() && !actor->GetMapper()->IsA("vtkCompositePolyDataMapper2"))
  {
    return nullptr;
  }
#endif
  return CompositeDataOf(prop);
}

std::uint32_t NumberOfNodes(vtkDataObject* data)
{
  std::uint32_t count = 1;
  if (auto* const tree = vtkDataObjectTree::SafeDownCast(data))
  {
    for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::None))
    {
      count += NumberOfNodes(child);
    }
  }
  return count;
}

PartNumbers& PartNumbers::Of(vtkRenderer* renderer)
{
  Registry& registry = Registry::Instance();
  const std::lock_guard<std::mutex> guard(registry.Lock);
  std::unique_ptr<PartNumbers>& numbers = registry.Numbers[renderer];
  if (!numbers)
  {
    numbers = std::make_unique<PartNumbers>();
    vtkNew<vtkCallbackCommand> whenDeleted;
    whenDeleted->SetCallback(ForgetRenderer);
    renderer->AddObserver(vtkCommand::DeleteEvent, whenDeleted);
  }
  return *numbers;
}

std::uint32_t PartNumbers::FirstOf(vtkProp* prop)
{
  const std::uint32_t count = NumberOfNodes(BlocksOf(prop));
  const auto found = this->Current.find(prop);
  const bool isKnown = found != this->Current.end() && found->second.Prop == prop;
  return isKnown && found->second.Count >= count ? found->second.First : this->Give(prop, count);
}

ShownPart PartNumbers::PartOf(std::uint32_t number) const
{
  const auto after = std::upper_bound(this->Ranges.begin(), this->Ranges.end(), number,
    [](std::uint32_t wanted, const Range& range) { return wanted < range.First; });
  if (after == this->Ranges.begin())
  {
    return {};
  }
  const Range& range = *std::prev(after);
  const bool isGiven = number - range.First < range.Count && range.Prop;
  return isGiven ? ShownPart{ range.Prop, number - range.First } : ShownPart{};
}

/** Gives the next numbers to a prop. */
std::uint32_t PartNumbers::Give(vtkProp* prop, std::uint32_t count)
{
  this->ForgetDeleted();
  if (count > MaximumNumber - this->Next)
  {
    this->Ranges.clear();
    this->Current.clear();
    this->Next = 1;
  }
  const Range range{ this->Next, count, prop };
  this->Ranges.push_back(range);
  this->Current[prop] = range;
  this->Next += count;
  return range.First;
}

/** Removes the ranges of deleted props if there are many ranges. */
void PartNumbers::ForgetDeleted()
{
  if (this->Ranges.size() < this->MostRanges)
  {
    return;
  }
  const auto isGone = [](const Range& range) { return range.Prop == nullptr; };
  this->Ranges.erase(
    std::remove_if(this->Ranges.begin(), this->Ranges.end(), isGone), this->Ranges.end());
  for (auto at = this->Current.begin(); at != this->Current.end();)
  {
    at = isGone(at->second) ? this->Current.erase(at) : std::next(at);
  }
  this->MostRanges = std::max<std::size_t>(1024, 2 * this->Ranges.size());
}

}
