#include "scene/ActorRules.h"

#include "scene/ClassName.h"
#include "scene/DrawingMapper.h"
#include "scene/PipelineState.h"
#include "scene/ScalarColors.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDataSetMapper.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkVersionMacros.h"

#include <algorithm>

namespace vitrine
{

namespace
{

/** Gives access to a protected member of all props. */
class AnyProp : public vtkProp
{
public:
  static vtkShaderProperty* ShaderOf(vtkProp* prop) { return prop->*(&AnyProp::ShaderProperty); }
};

/** Gives access to a protected function of all textures. */
class AnyTexture : public vtkTexture
{
public:
  /** Returns the array of an image that the texture draws. */
  static vtkDataArray* ColorsOf(vtkTexture* texture, vtkDataObject* image)
  {
    using ArrayOf = vtkDataArray* (vtkAlgorithm::*)(int, vtkDataObject*);
    return (texture->*static_cast<ArrayOf>(&AnyTexture::GetInputArrayToProcess))(0, image);
  }
};

/**
 * Returns the mapper that draws: the internal mapper of a vtkDataSetMapper, or the actor's own mapper. It may be null.
 */
vtkMapper* InnermostMapperOf(vtkActor* actor)
{
  vtkMapper* const mapper = actor->GetMapper();
  vtkDataSetMapper* const ofSurface = mapper ? SurfaceMapperOf(actor) : nullptr;
  return ofSurface ? ofSurface->GetPolyDataMapper() : mapper;
}

/** Returns the mapper of a prop that is an actor. It may be null. */
vtkMapper* MapperOf(vtkProp* prop)
{
  return static_cast<vtkActor*>(prop)->GetMapper();
}

/** Returns the class of the mapper. It is empty if the actor has lost its mapper since the rule was applied. */
std::string MapperClassOf(vtkProp* prop)
{
  vtkMapper* const mapper = MapperOf(prop);
  return mapper ? mapper->GetClassName() : std::string();
}

/**
 * Returns true if the actor is in world coordinates. From VTK 9.2 on, props may be in physical or device coordinates.
 */
bool StandsInWorld(vtkActor* actor)
{
#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 2
  static_cast<void>(actor);
  return true;
#else
  return actor->GetCoordinateSystem() == vtkProp3D::WORLD;
#endif
}

/**
 * Returns true if the internal mapper of a vtkDataSetMapper may colour by another array. It never learns which of the
 * data set's field arrays to use.
 */
bool MayColorByOthers(vtkMapper* mapper)
{
  return IsExactly<vtkDataSetMapper>(mapper) && mapper->GetScalarVisibility() &&
    mapper->GetScalarMode() == VTK_SCALAR_MODE_USE_FIELD_DATA;
}

/** Returns true if the texture has three components that are colours, so no alpha. */
bool IsOpaque(vtkTexture* texture)
{
  vtkImageData* image = IsInputMade(texture) ? texture->GetInput() : nullptr;
  vtkDataArray* colors = image ? AnyTexture::ColorsOf(texture, image) : nullptr;
  return colors && colors->GetNumberOfComponents() == 3 &&
    colors->GetDataType() == VTK_UNSIGNED_CHAR && texture->GetColorMode() == VTK_COLOR_MODE_DEFAULT;
}

/** Returns true if `rule` holds for the actor's own texture and for those of its property. */
template <class Rule>
bool IsTrueOfTextures(vtkActor* actor, const Rule& rule)
{
  if (actor->GetTexture() && !rule(actor->GetTexture()))
  {
    return false;
  }
  if (actor->GetProperty()->GetNumberOfTextures() == 0)
  {
    return true;
  }
  const auto& textures = actor->GetProperty()->GetAllTextures();
  return std::all_of(
    textures.begin(), textures.end(), [&](const auto& texture) { return rule(texture.second); });
}
}

const std::vector<DrawnElsewhereRow>& DrawnElsewhereRows()
{
  static const std::vector<DrawnElsewhereRow> rows = {
    { "its class is neither vtkOpenGLActor itself nor ParaView's vtkPVLODActor",
      "where it is drawn is not known",
      [](vtkProp* prop)
      { return !IsExactly<vtkOpenGLActor>(prop) && !IsExactlyOfClass(prop, "vtkPVLODActor"); },
      [](vtkProp* prop) { return std::string(prop->GetClassName()); } },
    { "it has no mapper", "there is nothing to be hidden",
      [](vtkProp* prop) { return !MapperOf(prop); } },
    { "the class of its mapper is not known", "where it draws is not known",
      [](vtkProp* prop) { return !IsKnownMapper(MapperOf(prop)); }, MapperClassOf },
    { "it stands in coordinates of the room or of the device (SetCoordinateSystem)",
      "where that is is not known",
      [](vtkProp* prop) { return !StandsInWorld(static_cast<vtkActor*>(prop)); } },
    { "its shaders have code of the user's, or its mapper an observer of UpdateShaderEvent",
      "they may move or fade it",
      [](vtkProp* prop) { return HasShaderCode(static_cast<vtkActor*>(prop)); } },
  };
  return rows;
}

vtkActor* AsHideable(vtkProp* prop)
{
  const std::vector<DrawnElsewhereRow>& rows = DrawnElsewhereRows();
  const bool isElsewhere = std::any_of(
    rows.begin(), rows.end(), [prop](const DrawnElsewhereRow& row) { return row.Applies(prop); });
  return isElsewhere ? nullptr : static_cast<vtkActor*>(prop);
}

vtkShaderProperty* ShaderPropertyOf(vtkProp* prop)
{
  return AnyProp::ShaderOf(prop);
}

bool HasShaderCode(vtkActor* actor)
{
  vtkShaderProperty* shader = ShaderPropertyOf(actor);
  return MaySetUniforms(InnermostMapperOf(actor)) ||
    (shader &&
      (shader->GetNumberOfShaderReplacements() > 0 || shader->HasVertexShaderCode() ||
        shader->HasFragmentShaderCode() || shader->HasGeometryShaderCode()));
}

bool MaySetUniforms(vtkMapper* mapper)
{
  return mapper && mapper->HasObserver(vtkCommand::UpdateShaderEvent);
}

bool MayHaveTranslucentColors(vtkMapper* mapper)
{
  return MayColorByOthers(mapper) || !AreColorsOpaque(mapper, mapper->GetInput());
}

bool HasTranslucentBack(vtkActor* actor)
{
  vtkProperty* back = actor->GetBackfaceProperty();
  return back && back->GetOpacity() < 1.0;
}

bool AreTexturesMade(vtkActor* actor)
{
  return IsTrueOfTextures(actor, [](vtkTexture* texture) { return IsInputMade(texture); });
}

bool AreTexturesOpaque(vtkActor* actor)
{
  return IsTrueOfTextures(actor, [](vtkTexture* texture) { return IsOpaque(texture); });
}

}
