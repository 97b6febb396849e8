#include "culling/BlendedProps.h"

#include "culling/PartRules.h"
#include "scene/ActorRules.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkFlagpoleLabel.h"
#include "vtkImageSlice.h"
#include "vtkNew.h"
#include "vtkProp3DCollection.h"
#include "vtkProp3DFollower.h"
#include "vtkPropAssembly.h"
#include "vtkPropCollection.h"
#include "vtkSkybox.h"
#include "vtkTextActor3D.h"

#include <algorithm>
#include <limits>

namespace vitrine
{

namespace
{

const float Anywhere = std::numeric_limits<float>::infinity();

/** Returns the blending by the rules for props, if the prop is drawn in the opaque pass. */
Blending BlendingByRules(const PropFacts& facts)
{
  const PropRow* const why = FindPropRow(PropStage::Blending, facts);
  if (!why)
  {
    return {};
  }
  const PropRow* const anywhere = FindPropRow(PropStage::Beside, facts);
  return { NumberOf(why), NumberOf(anywhere), anywhere ? Anywhere : 0.0f };
}

/** Returns true if VTK draws the actor in its opaque pass. */
bool IsAmongOpaque(vtkActor* actor)
{
  return actor->GetForceOpaque() || !actor->HasTranslucentPolygonalGeometry();
}

/** Returns true if the prop does not consist of other props that can be asked for. */
bool IsWhole(vtkProp* prop)
{
  return vtkTextActor3D::SafeDownCast(prop) || vtkBillboardTextActor3D::SafeDownCast(prop) ||
    vtkImageSlice::SafeDownCast(prop);
}

Blending BlendingOfAll(vtkPropCollection* parts)
{
  Blending all;
  vtkCollectionSimpleIterator place;
  parts->InitTraversal(place);
  while (vtkProp* part = parts->GetNextProp(place))
  {
    const Blending one = BlendingOf(part);
    if (all.IsLessThan(one))
    {
      all = one;
    }
  }
  return all;
}

/** Returns the blending of a prop that consists of parts or actors. */
Blending BlendingOfParts(vtkProp* prop)
{
  if (auto* follower = vtkProp3DFollower::SafeDownCast(prop))
  {
    return follower->GetProp3D() ? BlendingOf(follower->GetProp3D()) : Blending();
  }
  if (auto* assembly = vtkAssembly::SafeDownCast(prop))
  {
    return BlendingOfAll(assembly->GetParts());
  }
  if (auto* assembly = vtkPropAssembly::SafeDownCast(prop))
  {
    return BlendingOfAll(assembly->GetParts());
  }
  vtkNew<vtkPropCollection> actors;
  prop->GetActors(actors);
  actors->RemoveItem(prop);
  return BlendingOfAll(actors);
}
}

Blending BlendingOf(vtkActor* actor, bool areTexturesOpaque)
{
  PropFacts facts;
  facts.Prop = actor;
  if (vtkFlagpoleLabel::SafeDownCast(actor) || vtkSkybox::SafeDownCast(actor))
  {
    return BlendingByRules(facts);
  }
  facts.Actor = actor;
  facts.AreTexturesOpaque = areTexturesOpaque;
  Blending blending = BlendingByRules(facts);
  if (!blending.MayBlend() || !IsAmongOpaque(actor))
  {
    return {};
  }
  blending.Beside = std::max(blending.Beside, MostGrowthOf(actor));
  return blending;
}

Blending BlendingOf(vtkProp* prop)
{
  if (!prop->GetVisibility())
  {
    return {};
  }
  if (auto* actor = vtkActor::SafeDownCast(prop))
  {
    return BlendingOf(actor, AreTexturesOpaque(actor));
  }
  PropFacts facts;
  facts.Prop = prop;
  const Blending blending = BlendingByRules(facts);
  return blending.MayBlend() || IsWhole(prop) ? blending : BlendingOfParts(prop);
}

}
