#include "look/ChosenParts.h"

#include "scene/PartNumbers.h"

#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkProp3D.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace vitrine
{

namespace
{

/** Appends the numbers of a node and of all below it. */
void AddNumbers(vtkDataObject* data, const std::map<unsigned int, std::uint32_t>& chosen,
  std::uint32_t above, std::vector<std::uint32_t>& numbers)
{
  const auto found = chosen.find(static_cast<unsigned int>(numbers.size()));
  const std::uint32_t number = found == chosen.end() ? above : found->second;
  numbers.push_back(number);
  if (auto* const tree = vtkDataObjectTree::SafeDownCast(data))
  {
    for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::None))
    {
      AddNumbers(child, chosen, number, numbers);
    }
  }
}
}

bool ChosenParts::IsOfParts(vtkProp* prop)
{
  return vtkProp3D::SafeDownCast(prop) && !prop->IsA("vtkVolume") && !prop->IsA("vtkImageSlice") &&
    !prop->IsA("vtkAssembly");
}

void ChosenParts::Add(vtkProp* prop, int block)
{
  PartsOfProp& parts = this->Props[prop];
  if (parts.Prop != prop)
  {
    parts = { prop, {} };
  }
  const auto number = static_cast<std::uint32_t>(this->Count + 1);
  if (parts.NumberOf.insert({ static_cast<unsigned int>(std::max(block, 0)), number }).second)
  {
    ++this->Count;
  }
}

void ChosenParts::RemoveAll()
{
  this->Props.clear();
  this->Count = 0;
}

bool ChosenParts::Has(vtkProp* prop) const
{
  const auto found = this->Props.find(prop);
  return found != this->Props.end() && found->second.Prop == prop;
}

void ChosenParts::AddPropsTo(std::unordered_set<vtkProp*>& props) const
{
  for (const auto& [prop, parts] : this->Props)
  {
    if (parts.Prop)
    {
      props.insert(prop);
    }
  }
}

std::vector<vtkProp*> ChosenParts::PropsIn(vtkRenderer* renderer) const
{
  std::vector<vtkProp*> found;
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator place;
  props->InitTraversal(place);
  vtkProp* prop = nullptr;
  while (!this->IsEmpty() && (prop = props->GetNextProp(place)))
  {
    if (prop->GetVisibility() && this->Has(prop))
    {
      found.push_back(prop);
    }
  }
  return found;
}

std::vector<std::uint32_t> ChosenParts::NumbersOf(vtkProp* prop) const
{
  std::vector<std::uint32_t> numbers;
  if (this->Has(prop))
  {
    AddNumbers(BlocksOf(prop), this->Props.at(prop).NumberOf, 0, numbers);
  }
  return numbers;
}

}
