#include "inspection/FadedLooks.h"

#include "scene/PropertyCopy.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkVersionMacros.h"

#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 3
#include "vtkCompositePolyDataMapper2.h"
using BlocksMapper = vtkCompositePolyDataMapper2;
#else
#include "vtkCompositePolyDataMapper.h"
using BlocksMapper = vtkCompositePolyDataMapper;
#endif

#include <algorithm>

namespace vitrine
{
namespace
{

/** Returns the attributes of an actor's blocks, which are made if there are none, or null if it draws no blocks. */
vtkCompositeDataDisplayAttributes* AttributesOf(vtkActor* actor)
{
  auto* const mapper = BlocksMapper::SafeDownCast(actor->GetMapper());
  if (mapper && !mapper->GetCompositeDataDisplayAttributes())
  {
    mapper->SetCompositeDataDisplayAttributes(vtkNew<vtkCompositeDataDisplayAttributes>());
  }
  return mapper ? mapper->GetCompositeDataDisplayAttributes() : nullptr;
}

/** Has a mapper draw its blocks as their attributes say now. VTK does not notice by itself that one was removed. */
void NoteChange(vtkActor* actor)
{
  AttributesOf(actor)->Modified();
  actor->GetMapper()->Modified();
}

void AddNodes(vtkCompositeDataDisplayAttributes* attributes, vtkDataObject* data, double opacity,
  std::vector<BlockNode>& nodes)
{
  if (data && attributes->HasBlockOpacity(data))
  {
    opacity = attributes->GetBlockOpacity(data);
  }
  nodes.push_back({ data, opacity });
  if (auto* const tree = vtkDataObjectTree::SafeDownCast(data))
  {
    for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::None))
    {
      AddNodes(attributes, child, opacity, nodes);
    }
  }
}
}

std::vector<BlockNode> BlockNodesOf(vtkActor* actor)
{
  std::vector<BlockNode> nodes;
  vtkDataObject* const data = BlocksOf(actor);
  vtkCompositeDataDisplayAttributes* const attributes = data ? AttributesOf(actor) : nullptr;
  if (attributes)
  {
    AddNodes(attributes, data, actor->GetProperty()->GetOpacity(), nodes);
  }
  return nodes;
}

void FadedLooks::Read(vtkRenderer* renderer)
{
  this->Users.clear();
  this->Nodes.clear();
  vtkActorCollection* const actors = renderer->GetActors();
  vtkCollectionSimpleIterator place;
  actors->InitTraversal(place);
  while (vtkActor* const actor = actors->GetNextActor(place))
  {
    ++this->Users[actor->GetProperty()];
  }
}

const std::vector<BlockNode>& FadedLooks::NodesOf(vtkActor* actor)
{
  std::vector<BlockNode>& nodes = this->Nodes[actor];
  if (nodes.empty())
  {
    nodes = BlockNodesOf(actor);
  }
  return nodes;
}

FadedLooks::Look& FadedLooks::LookOf(std::uint32_t number, const ShownPart& part)
{
  Look& look = this->Looks[number];
  vtkActor* const actor = vtkActor::SafeDownCast(part.Prop);
  if (look.IsSet || look.IsHidden)
  {
    return look;
  }
  look.Prop = part.Prop;
  look.Block = part.Block;
  if (actor && BlocksOf(actor))
  {
    const std::vector<BlockNode>& nodes = this->NodesOf(actor);
    if (part.Block < nodes.size())
    {
      look.Data = nodes[part.Block].Data;
      look.Original = nodes[part.Block].Opacity;
    }
  }
  else if (actor)
  {
    look.Original = actor->GetProperty()->GetOpacity();
    look.IsForcedOpaque = actor->GetForceOpaque();
  }
  look.Original = look.IsForcedOpaque ? 1.0 : std::clamp(look.Original, 0.0, 1.0);
  return look;
}

double FadedLooks::OriginalOf(std::uint32_t number, const ShownPart& part)
{
  return this->LookOf(number, part).Original;
}

void FadedLooks::Fade(Look& look, vtkActor* actor, double opacity)
{
  if (look.Data)
  {
    vtkCompositeDataDisplayAttributes* const attributes = AttributesOf(actor);
    if (!look.IsSet && attributes->HasBlockOpacity(look.Data))
    {
      look.Opacity = attributes->GetBlockOpacity(look.Data);
    }
    attributes->SetBlockOpacity(look.Data, opacity);
    NoteChange(actor);
    return;
  }
  if (!look.IsSet)
  {
    look.Front = actor->GetProperty();
    look.Back = actor->GetBackfaceProperty();
    look.FrontOpacity = look.Front->GetOpacity();
    look.BackOpacity = look.Back ? look.Back->GetOpacity() : 1.0;
    look.IsCopy = look.Back || this->Users[look.Front] > 1;
    actor->SetForceOpaque(false);
    if (look.IsCopy)
    {
      actor->SetProperty(CopyProperty(look.Front));
      actor->SetBackfaceProperty(look.Back ? CopyProperty(look.Back).Get() : nullptr);
    }
  }
  actor->GetProperty()->SetOpacity(opacity);
  if (look.Back)
  {
    actor->GetBackfaceProperty()->SetOpacity(std::min(opacity, look.BackOpacity));
  }
}

void FadedLooks::Show(Look& look, bool isVisible)
{
  vtkActor* const actor = vtkActor::SafeDownCast(look.Prop);
  if (!look.Prop || look.IsHidden == !isVisible)
  {
    return;
  }
  look.IsHidden = !isVisible;
  if (!actor || !look.Data)
  {
    look.Prop->SetVisibility(isVisible);
    return;
  }
  vtkCompositeDataDisplayAttributes* const attributes = AttributesOf(actor);
  if (!isVisible && attributes->HasBlockVisibility(look.Data))
  {
    look.Visibility = attributes->GetBlockVisibility(look.Data);
  }
  if (!isVisible)
  {
    attributes->SetBlockVisibility(look.Data, false);
  }
  else if (look.Visibility)
  {
    attributes->SetBlockVisibility(look.Data, *look.Visibility);
  }
  else
  {
    attributes->RemoveBlockVisibility(look.Data);
  }
  NoteChange(actor);
}

void FadedLooks::Set(std::uint32_t number, const ShownPart& part, double opacity)
{
  Look& look = this->LookOf(number, part);
  vtkActor* const actor = vtkActor::SafeDownCast(part.Prop);
  if (actor && opacity > 0.0)
  {
    this->Fade(look, actor, opacity);
    look.IsSet = true;
  }
  Show(look, actor && opacity > 0.0);
}

void FadedLooks::ShowHidden()
{
  for (auto& [number, look] : this->Looks)
  {
    Show(look, true);
  }
}

bool FadedLooks::IsHidden(std::uint32_t number) const
{
  const auto found = this->Looks.find(number);
  return found != this->Looks.end() && found->second.IsHidden;
}

void FadedLooks::PutBack(Look& look)
{
  Show(look, true);
  vtkActor* const actor = vtkActor::SafeDownCast(look.Prop);
  if (!actor || !look.IsSet)
  {
    return;
  }
  if (look.Data)
  {
    vtkCompositeDataDisplayAttributes* const attributes = AttributesOf(actor);
    if (look.Opacity)
    {
      attributes->SetBlockOpacity(look.Data, *look.Opacity);
    }
    else
    {
      attributes->RemoveBlockOpacity(look.Data);
    }
    NoteChange(actor);
    return;
  }
  if (look.IsCopy)
  {
    actor->SetProperty(look.Front);
    actor->SetBackfaceProperty(look.Back);
  }
  else
  {
    look.Front->SetOpacity(look.FrontOpacity);
  }
  actor->SetForceOpaque(look.IsForcedOpaque);
}

void FadedLooks::PutBack(std::uint32_t number)
{
  const auto found = this->Looks.find(number);
  if (found != this->Looks.end())
  {
    PutBack(found->second);
    this->Looks.erase(found);
  }
}

void FadedLooks::PutBackAll()
{
  for (auto& [number, look] : this->Looks)
  {
    PutBack(look);
  }
  this->Looks.clear();
}

}
