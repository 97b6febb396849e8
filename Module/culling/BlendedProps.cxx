#include "culling/BlendedProps.h"

#include "culling/ActorRules.h"
#include "culling/ClassName.h"
#include "culling/DrawingMapper.h"
#include "culling/ScalarColors.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkImageMapper3D.h"
#include "vtkImageSlice.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkProp3DCollection.h"
#include "vtkPropAssembly.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"

#include <algorithm>
#include <limits>

namespace vitrine
{

namespace
{

const float Anywhere = std::numeric_limits<float>::infinity();

bool IsComposite(vtkMapper* mapper)
{
  return mapper->IsA("vtkCompositePolyDataMapper2") || mapper->IsA("vtkCompositePolyDataMapper");
}

/** Others may draw balls or splats around points, or anything. */
bool KeepsToItsBounds(vtkMapper* mapper)
{
  return IsKnownMapper(mapper) || IsComposite(mapper) ||
    IsExactlyOfClass(mapper, "vtkOpenGLGlyph3DMapper");
}

/** Mappers whose colours VTK knows to be opaque, and that blend all the same: blocks that are forced, and splats, which fade. */
bool BlendsByItself(vtkActor* actor, vtkMapper* mapper)
{
  return (actor->GetForceOpaque() && IsComposite(mapper)) || mapper->IsA("vtkPointGaussianMapper");
}

/** VTK's images have alpha, and fade where they end. */
Blending BlendingOfImage(vtkImageSlice* image)
{
  vtkImageMapper3D* mapper = image->GetMapper();
  if (!mapper || image->HasTranslucentPolygonalGeometry())
  {
    return {};
  }
  const bool isWider =
    mapper->GetBackground() || mapper->GetBorder() || image->IsA("vtkImageStack");
  return { true, isWider ? Anywhere : 0.0f };
}

Blending BlendingOfAll(vtkPropCollection* parts)
{
  Blending all;
  vtkCollectionSimpleIterator place;
  parts->InitTraversal(place);
  while (vtkProp* part = parts->GetNextProp(place))
  {
    const Blending one = BlendingOf(part);
    all = { all.MayBlend || one.MayBlend, std::max(all.Beside, one.Beside) };
  }
  return all;
}

/** Of what tells which parts or actors it is made of. */
Blending BlendingOfParts(vtkProp* prop)
{
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
  vtkMapper* mapper = actor->GetMapper();
  const bool mayBlend = actor->GetProperty()->GetOpacity() < 1.0 || HasTranslucentBack(actor) ||
    HasShaderCode(actor) || !areTexturesOpaque ||
    (mapper && (MayHaveTranslucentColors(mapper) || BlendsByItself(actor, mapper)));
  if (!mayBlend || (!actor->GetForceOpaque() && actor->HasTranslucentPolygonalGeometry()))
  {
    return {};
  }
  return { true, !mapper || KeepsToItsBounds(mapper) ? MostGrowthOf(actor) : Anywhere };
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
  if (auto* image = vtkImageSlice::SafeDownCast(prop))
  {
    return BlendingOfImage(image);
  }
  const Blending parts = BlendingOfParts(prop);
  return { parts.MayBlend, parts.MayBlend && !prop->GetBounds() ? Anywhere : parts.Beside };
}

}
