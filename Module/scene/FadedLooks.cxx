#include "scene/FadedLooks.h"

#include "scene/PropertyCopy.h"

#include "vtkActor.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"
#include "vtkVersionMacros.h"
#include "vtkWeakPointer.h"

#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 3
#include "vtkCompositePolyDataMapper2.h"
using BlocksMapper = vtkCompositePolyDataMapper2;
#else
#include "vtkCompositePolyDataMapper.h"
using BlocksMapper = vtkCompositePolyDataMapper;
#endif

#include <algorithm>
#include <mutex>
#include <optional>
#include <utility>

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

/** A property of an actor, and the copy of it that the actor shows. */
class PropertySide
{
public:
  bool IsCopied() const { return this->Copy != nullptr; }

  vtkProperty* Shown() const { return this->Copy; }
  vtkProperty* Own() const { return this->Original; }

  /** Copies a property, which may be null. */
  void CopyOf(vtkProperty* property)
  {
    this->Original = property;
    this->Copy = property ? CopyProperty(property) : nullptr;
    this->Faded = property ? property->GetOpacity() : 1.0;
    this->NoteTimes();
  }

  void SetOpacity(double opacity)
  {
    this->Copy->SetOpacity(opacity);
    this->Faded = this->Copy->GetOpacity();
    this->NoteTimes();
  }

  /** Gives the property what was set on the copy, or else the copy what was set on the property. */
  void TakeChanges()
  {
    if (!this->Copy)
    {
      return;
    }
    if (this->Copy->GetMTime() > this->CopyTime)
    {
      const bool isOurs = this->Copy->GetOpacity() == this->Faded;
      const double opacity = (isOurs ? this->Original : this->Copy)->GetOpacity();
      CopyProperty(this->Copy, this->Original);
      this->Original->SetOpacity(opacity);
    }
    else if (this->Original->GetMTime() > this->OriginalTime)
    {
      CopyProperty(this->Original, this->Copy);
      this->Copy->SetOpacity(this->Faded);
    }
    this->NoteTimes();
  }

private:
  void NoteTimes()
  {
    this->CopyTime = this->Copy ? this->Copy->GetMTime() : 0;
    this->OriginalTime = this->Original ? this->Original->GetMTime() : 0;
  }

  vtkSmartPointer<vtkProperty> Original;
  vtkSmartPointer<vtkProperty> Copy;
  double Faded = 1.0; ///< the opacity that the copy got from here
  vtkMTimeType CopyTime = 0;
  vtkMTimeType OriginalTime = 0;
};

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

/** A faded part: what it had before, and has now. */
struct FadedLooks::Look
{
  std::pair<vtkProp*, unsigned int> Key; ///< The prop may be gone.
  vtkWeakPointer<vtkProp> Prop;
  double Original = 1.0;
  std::map<const FadedLooks*, double> Wanted; ///< the opacities that it shall have
  bool IsHidden = false;

  // Of actors.
  PropertySide Front;
  PropertySide Back;
  bool IsForcedOpaque = false;

  // Of blocks: what they had of their own, and what they got.
  vtkSmartPointer<vtkDataObject> Data;
  std::optional<double> Opacity;
  std::optional<double> Faded;
  std::optional<bool> Visibility;

  vtkActor* Actor() const { return vtkActor::SafeDownCast(this->Prop); }

  /** Takes what others have set since the part was faded as its own. */
  void TakeChanges()
  {
    vtkActor* const actor = this->Actor();
    if (actor && this->Data)
    {
      this->TakeChangesOfBlock(actor);
    }
    else if (actor)
    {
      this->Front.TakeChanges();
      this->Back.TakeChanges();
      if (this->Front.IsCopied() &&
        (actor->GetProperty() != this->Front.Shown() ||
          actor->GetBackfaceProperty() != this->Back.Shown()))
      {
        this->Restore();
      }
      const bool isCopied = this->Front.IsCopied();
      this->IsForcedOpaque = (isCopied && this->IsForcedOpaque) || actor->GetForceOpaque();
      vtkProperty* const own = isCopied ? this->Front.Own() : actor->GetProperty();
      this->Original = this->IsForcedOpaque ? 1.0 : own->GetOpacity();
    }
  }

  void TakeChangesOfBlock(vtkActor* actor)
  {
    vtkCompositeDataDisplayAttributes* const attributes = AttributesOf(actor);
    const bool has = attributes && attributes->HasBlockOpacity(this->Data);
    if (!attributes || !this->Faded ||
      (has && attributes->GetBlockOpacity(this->Data) == *this->Faded))
    {
      return;
    }
    this->Faded.reset();
    this->Opacity.reset();
    this->Original =
      has ? attributes->GetBlockOpacity(this->Data) : actor->GetProperty()->GetOpacity();
  }

  void Fade(double opacity)
  {
    this->TakeChanges();
    vtkActor* const actor = this->Actor();
    if (this->Data)
    {
      vtkCompositeDataDisplayAttributes* const attributes = AttributesOf(actor);
      if (!attributes)
      {
        return;
      }
      if (!this->Faded && attributes->HasBlockOpacity(this->Data))
      {
        this->Opacity = attributes->GetBlockOpacity(this->Data);
      }
      attributes->SetBlockOpacity(this->Data, opacity);
      this->Faded = attributes->GetBlockOpacity(this->Data);
      NoteChange(actor);
      return;
    }
    if (!this->Front.IsCopied())
    {
      this->IsForcedOpaque = actor->GetForceOpaque();
      this->Front.CopyOf(actor->GetProperty());
      this->Back.CopyOf(actor->GetBackfaceProperty());
      actor->SetProperty(this->Front.Shown());
      actor->SetBackfaceProperty(this->Back.Shown());
    }
    actor->SetForceOpaque(false);
    this->Front.SetOpacity(opacity);
    if (this->Back.IsCopied())
    {
      this->Back.SetOpacity(std::min(opacity, this->Back.Own()->GetOpacity()));
    }
  }

  void Show(bool isVisible)
  {
    vtkActor* const actor = this->Actor();
    if (!this->Prop || this->IsHidden == !isVisible)
    {
      return;
    }
    this->IsHidden = !isVisible;
    vtkCompositeDataDisplayAttributes* const attributes =
      actor && this->Data ? AttributesOf(actor) : nullptr;
    if (!attributes)
    {
      this->Prop->SetVisibility(isVisible);
      return;
    }
    const bool has = attributes->HasBlockVisibility(this->Data);
    if (!isVisible)
    {
      this->Visibility =
        has ? std::optional<bool>(attributes->GetBlockVisibility(this->Data)) : std::nullopt;
      attributes->SetBlockVisibility(this->Data, false);
    }
    else if (!has || attributes->GetBlockVisibility(this->Data))
    {
      return; // Others have shown it.
    }
    else if (this->Visibility)
    {
      attributes->SetBlockVisibility(this->Data, *this->Visibility);
    }
    else
    {
      attributes->RemoveBlockVisibility(this->Data);
    }
    NoteChange(actor);
  }

  /** Puts back what is still as it was set here. */
  void Restore()
  {
    vtkActor* const actor = this->Actor();
    vtkCompositeDataDisplayAttributes* const attributes =
      actor && this->Faded ? AttributesOf(actor) : nullptr;
    if (attributes)
    {
      if (this->Opacity)
      {
        attributes->SetBlockOpacity(this->Data, *this->Opacity);
      }
      else
      {
        attributes->RemoveBlockOpacity(this->Data);
      }
      NoteChange(actor);
    }
    if (actor && this->Front.IsCopied())
    {
      if (actor->GetProperty() == this->Front.Shown())
      {
        actor->SetProperty(this->Front.Own());
      }
      if (actor->GetBackfaceProperty() == this->Back.Shown())
      {
        actor->SetBackfaceProperty(this->Back.Own());
      }
      actor->SetForceOpaque(this->IsForcedOpaque || actor->GetForceOpaque());
    }
    this->Front.CopyOf(nullptr);
    this->Back.CopyOf(nullptr);
    this->Faded.reset();
  }

  /** Gives the part the look that it shall have now. */
  void Apply()
  {
    double opacity = 1.0;
    for (const auto& [who, wanted] : this->Wanted)
    {
      opacity = std::min(opacity, wanted);
    }
    if (this->Wanted.empty())
    {
      this->Show(true);
      this->TakeChanges();
      this->Restore();
      return;
    }
    if (this->Actor() && opacity > 0.0)
    {
      this->Fade(opacity);
    }
    this->Show(this->Actor() && opacity > 0.0);
  }
};

/** The looks of all parts that are faded. They outlive static objects, since renderers may do so. */
struct FadedLooks::Registry
{
  std::recursive_mutex Lock; ///< Observers of what is set may fade other parts.
  std::map<std::pair<vtkProp*, unsigned int>, std::weak_ptr<Look>> Looks;

  static Registry& Instance()
  {
    static Registry* const registry = new Registry;
    return *registry;
  }

  /** Returns the look of a part, or null if it is not faded. */
  std::shared_ptr<Look> Find(const ShownPart& part) const
  {
    const auto found = this->Looks.find({ part.Prop, part.Block });
    std::shared_ptr<Look> look = found != this->Looks.end() ? found->second.lock() : nullptr;
    return look && look->Prop == part.Prop ? look : nullptr;
  }
};

const std::vector<BlockNode>& FadedLooks::NodesOf(vtkActor* actor)
{
  std::vector<BlockNode>& nodes = this->Nodes[actor];
  if (nodes.empty())
  {
    nodes = BlockNodesOf(actor);
  }
  return nodes;
}

/** Returns the look of a part that is not faded. */
std::shared_ptr<FadedLooks::Look> FadedLooks::Read(const ShownPart& part)
{
  auto look = std::make_shared<Look>();
  look->Key = { part.Prop, part.Block };
  look->Prop = part.Prop;
  vtkActor* const actor = look->Actor();
  if (actor && BlocksOf(actor))
  {
    const std::vector<BlockNode>& nodes = this->NodesOf(actor);
    if (part.Block < nodes.size())
    {
      look->Data = nodes[part.Block].Data;
      look->Original = nodes[part.Block].Opacity;
    }
  }
  else if (actor)
  {
    look->Original = actor->GetForceOpaque() ? 1.0 : actor->GetProperty()->GetOpacity();
  }
  return look;
}

double FadedLooks::OriginalOf(const ShownPart& part)
{
  Registry& registry = Registry::Instance();
  const std::lock_guard<std::recursive_mutex> guard(registry.Lock);
  std::shared_ptr<Look> look = registry.Find(part);
  if (look)
  {
    look->TakeChanges();
  }
  else
  {
    look = this->Read(part);
  }
  return std::clamp(look->Original, 0.0, 1.0);
}

void FadedLooks::Set(std::uint32_t number, const ShownPart& part, double opacity)
{
  Registry& registry = Registry::Instance();
  const std::lock_guard<std::recursive_mutex> guard(registry.Lock);
  std::shared_ptr<Look> look = registry.Find(part);
  if (!look)
  {
    look = this->Read(part);
    registry.Looks[look->Key] = look;
  }
  this->Looks[number] = look;
  look->Wanted[this] = opacity;
  look->Apply();
}

void FadedLooks::ShowHidden()
{
  const std::lock_guard<std::recursive_mutex> guard(Registry::Instance().Lock);
  for (auto& [number, look] : this->Looks)
  {
    look->Show(true);
  }
}

/** Wants nothing of a look any more. */
void FadedLooks::Drop(const std::shared_ptr<Look>& look)
{
  Registry& registry = Registry::Instance();
  look->Wanted.erase(this);
  look->Apply();
  const auto found = registry.Looks.find(look->Key);
  if (look->Wanted.empty() && found != registry.Looks.end() && found->second.lock() == look)
  {
    registry.Looks.erase(found);
  }
}

void FadedLooks::PutBack(std::uint32_t number)
{
  const std::lock_guard<std::recursive_mutex> guard(Registry::Instance().Lock);
  const auto found = this->Looks.find(number);
  if (found != this->Looks.end())
  {
    const std::shared_ptr<Look> look = found->second;
    this->Looks.erase(found);
    this->Drop(look);
  }
}

void FadedLooks::PutBackAll()
{
  const std::lock_guard<std::recursive_mutex> guard(Registry::Instance().Lock);
  std::map<std::uint32_t, std::shared_ptr<Look>> looks;
  looks.swap(this->Looks);
  for (const auto& [number, look] : looks)
  {
    this->Drop(look);
  }
}

}
