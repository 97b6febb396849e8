#include "culling/BlendedProps.h"

#include "culling/PartRules.h"
#include "scene/ActorRules.h"
#include "scene/ClassName.h"
#include "scene/DrawingMapper.h"
#include "scene/ScalarColors.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkFlagpoleLabel.h"
#include "vtkImageMapper3D.h"
#include "vtkImageSlice.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkProp3DCollection.h"
#include "vtkProp3DFollower.h"
#include "vtkPropAssembly.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkSkybox.h"
#include "vtkTextActor3D.h"

#include <algorithm>
#include <array>
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

/**
 * Mappers whose colours VTK knows to be opaque, and that blend all the same: blocks that are forced, splats, which fade, and those that draw what they like among what is opaque, as labels of contours, or
 * edges of graphs.
 */
bool BlendsByItself(vtkActor* actor, vtkMapper* mapper)
{
  const std::array<const char*, 4> others{ "vtkPolyDataMapper", "vtkDataSetMapper",
    "vtkGlyph3DMapper", "vtkMoleculeMapper" };
  return (actor->GetForceOpaque() && IsComposite(mapper)) ||
    mapper->IsA("vtkPointGaussianMapper") ||
    std::none_of(
      others.begin(), others.end(), [mapper](const char* other) { return mapper->IsA(other); });
}

/** Its floor fades towards the horizon; all else of it is as far away as nothing. */
Blending BlendingOfSky(vtkSkybox* sky)
{
  const bool isFloor = sky->GetProjection() == vtkSkybox::Floor;
  return { isFloor, isFloor ? Anywhere : 0.0f };
}

/** Whether there is any text, which is an image with an alpha, among what is opaque. Where it is is not known: of those that look at the eye nobody but VTK must ask, since that turns them. */
template <class Text>
Blending BlendingOfText(Text* text)
{
  const char* const input = text->GetInput();
  const bool isAnywhere = input && *input && !text->HasTranslucentPolygonalGeometry();
  return { isAnywhere, isAnywhere ? Anywhere : 0.0f };
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
  if (auto* label = vtkFlagpoleLabel::SafeDownCast(actor))
  {
    return BlendingOfText(label);
  }
  if (auto* sky = vtkSkybox::SafeDownCast(actor))
  {
    return BlendingOfSky(sky);
  }
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
  if (auto* text = vtkTextActor3D::SafeDownCast(prop))
  {
    return BlendingOfText(text);
  }
  if (auto* text = vtkBillboardTextActor3D::SafeDownCast(prop))
  {
    return BlendingOfText(text);
  }
  if (auto* actor = vtkActor::SafeDownCast(prop))
  {
    return BlendingOf(actor, AreTexturesOpaque(actor));
  }
  if (auto* image = vtkImageSlice::SafeDownCast(prop))
  {
    return BlendingOfImage(image);
  }
  return BlendingOfParts(prop);
}

}
