#include "LayersUnderPixel.h"

#include "vtkActor.h"
#include "vtkCompositeDataSet.h"
#include "vtkCompositeRepresentation.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkInformation.h"
#include "vtkMapper.h"
#include "vtkPVDataRepresentation.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"

namespace vitrine
{

namespace
{

/**
 * Adds the names from a node down to the block of a flat index, which counts from the node. Returns true if it is
 * there. Otherwise `index` is what is left of it behind the node.
 */
bool FindName(vtkDataObject* node, unsigned int& index, std::string& names)
{
  if (index == 0)
  {
    return true;
  }
  --index;
  auto* const tree = vtkDataObjectTree::SafeDownCast(node);
  if (!tree)
  {
    return false;
  }
  vtkNew<vtkDataObjectTreeIterator> child;
  child->SetDataSet(tree);
  child->SkipEmptyNodesOff();
  child->VisitOnlyLeavesOff();
  child->TraverseSubTreeOff();
  for (child->InitTraversal(); !child->IsDoneWithTraversal(); child->GoToNextItem())
  {
    if (FindName(child->GetCurrentDataObject(), index, names))
    {
      vtkInformation* const about =
        child->HasCurrentMetaData() ? child->GetCurrentMetaData() : nullptr;
      const char* const name = about ? about->Get(vtkCompositeDataSet::NAME()) : nullptr;
      names = name ? name + (names.empty() ? std::string() : "/" + names) : names;
      return true;
    }
  }
  return false;
}

std::string NameOfBlock(vtkProp* prop, unsigned int index)
{
  auto* const actor = vtkActor::SafeDownCast(prop);
  vtkMapper* const mapper = actor ? actor->GetMapper() : nullptr;
  std::string names;
  if (mapper && mapper->GetNumberOfInputConnections(0) > 0)
  {
    FindName(mapper->GetInputDataObject(0, 0), index, names);
  }
  return names;
}

/** Returns true if a proxy is of the representation, or has it chosen among several, as Surface and Volume are. */
bool Shows(vtkSMProxy* proxy, vtkPVDataRepresentation* representation)
{
  vtkObjectBase* const one = proxy->GetClientSideObject();
  auto* const several = vtkCompositeRepresentation::SafeDownCast(one);
  return one == representation || (several && several->GetActiveRepresentation() == representation);
}
}

void LayersUnderPixel::Note(vtkPVDataRepresentation* representation, vtkRenderer* renderer)
{
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator place;
  props->InitTraversal(place);
  while (vtkProp* const prop = props->GetNextProp(place))
  {
    Shown& shown = this->Props[prop];
    if (!shown.Prop)
    {
      shown = { prop, representation ? representation->GetUniqueIdentifier() : 0 };
    }
  }
}

unsigned int LayersUnderPixel::RepresentationOf(vtkProp* prop) const
{
  const auto shown = this->Props.find(prop);
  return shown != this->Props.end() && shown->second.Prop ? shown->second.Representation : 0;
}

void LayersUnderPixel::Find(
  vtkRenderer* renderer, vtkMultiProcessController* ranks, FrameAnswers& answers)
{
  if (this->Pixel[0] < 0 || this->Pixel[1] < 0)
  {
    return;
  }
  this->Picker->SetController(ranks);
  this->Picker->SetRenderer(renderer);
  this->Picker->SetPosition(this->Pixel[0], this->Pixel[1]);
  if (!this->Picker->Pick())
  {
    answers.LayersProblem = this->Picker->GetProblem();
    return;
  }
  for (vtkIdType i = 0; i < this->Picker->GetNumberOfLayers(); ++i)
  {
    vtkProp* const prop = this->Picker->GetProp(i);
    LayerOfPixel layer;
    layer.Rank = this->Picker->GetRank(i);
    layer.Representation = this->RepresentationOf(prop);
    layer.Block = NameOfBlock(prop, this->Picker->GetBlock(i));
    layer.Depth = this->Picker->GetWindowDepth(i);
    layer.Distance = this->Picker->GetDistance(i);
    layer.Share = this->Picker->GetShare(i);
    answers.Layers.push_back(layer);
  }
}

std::string NameOfSource(vtkPVDataRepresentation* representation)
{
  vtkSMSessionProxyManager* const proxies = vtkSMProxyManager::IsInitialized()
    ? vtkSMProxyManager::GetProxyManager()->GetActiveSessionProxyManager()
    : nullptr;
  if (!proxies)
  {
    return {};
  }
  vtkNew<vtkSMProxyIterator> each;
  each->SetSessionProxyManager(proxies);
  for (each->Begin("representations"); !each->IsAtEnd(); each->Next())
  {
    vtkSMProxy* const proxy = each->GetProxy();
    if (proxy->GetProperty("Input") && Shows(proxy, representation))
    {
      vtkSMProxy* const source = vtkSMPropertyHelper(proxy, "Input").GetAsProxy();
      const char* const name = source ? proxies->GetProxyName("sources", source) : nullptr;
      return name ? name : "";
    }
  }
  return {};
}

}
