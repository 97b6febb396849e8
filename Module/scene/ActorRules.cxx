#include "scene/ActorRules.h"

#include "culling/PartGeometry.h"
#include "culling/mappers/vtkCulledCompositePolyDataMapper.h"
#include "culling/vtkHierarchicalSBufferCuller.h"
#include "scene/ClassName.h"
#include "scene/DrawingMapper.h"
#include "scene/PipelineState.h"
#include "scene/ScalarColors.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDataSetMapper.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMapper.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkVersionMacros.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

// What antialiased and snapped lines and points touch beyond their width.
const float BesidesWidth = 1.5f;

/** Has access to a member of all props. */
class AnyProp : public vtkProp
{
public:
  static vtkShaderProperty* ShaderOf(vtkProp* prop) { return prop->*(&AnyProp::ShaderProperty); }
};

/** Has access to what all of them do. */
class AnyTexture : public vtkTexture
{
public:
  /** Of an image, those of its arrays that are drawn. */
  static vtkDataArray* ColorsOf(vtkTexture* texture, vtkDataObject* image)
  {
    using ArrayOf = vtkDataArray* (vtkAlgorithm::*)(int, vtkDataObject*);
    return (texture->*static_cast<ArrayOf>(&AnyTexture::GetInputArrayToProcess))(0, image);
  }
};

/** That draws what a vtkDataSetMapper, or another one by itself, is to; null if there is none. */
vtkMapper* InnermostMapperOf(vtkActor* actor)
{
  vtkMapper* const mapper = actor->GetMapper();
  vtkDataSetMapper* const ofSurface = mapper ? SurfaceMapperOf(actor) : nullptr;
  return ofSurface ? ofSurface->GetPolyDataMapper() : mapper;
}

/** From VTK 9.2 on, props may stand in coordinates of the room, or of the device. */
bool StandsInWorld(vtkActor* actor)
{
#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 2
  static_cast<void>(actor);
  return true;
#else
  return actor->GetCoordinateSystem() == vtkProp3D::WORLD;
#endif
}

/** In pixels, of lines or points. */
float WidthOf(vtkActor* actor)
{
  return std::max(actor->GetProperty()->GetLineWidth(), actor->GetProperty()->GetPointSize());
}

/** Whether a vtkDataSetMapper may have the mapper within colour by other arrays than it tells: that one never learns which of a data set's own arrays. */
bool MayColorByOthers(vtkMapper* mapper)
{
  return IsExactly<vtkDataSetMapper>(mapper) && mapper->GetScalarVisibility() &&
    mapper->GetScalarMode() == VTK_SCALAR_MODE_USE_FIELD_DATA;
}

/** Whether a device was given its points about the origin, whatever the mapper is told since. */
bool HasUnshiftedPoints(vtkOpenGLPolyDataMapper* mapper)
{
  vtkOpenGLVertexBufferObject* points = mapper->GetVBOs()->GetVBO("vertexMC");
  return points && points->GetUploadTime() > 0 && !points->GetCoordShiftAndScaleEnabled();
}

/** Blocks of a composite mapper are looked at one by one. */
bool IsTranslucentAsAWhole(vtkActor* actor)
{
  return IsExactly<vtkCulledCompositePolyDataMapper>(actor->GetMapper())
    ? actor->GetForceTranslucent()
    : actor->HasTranslucentPolygonalGeometry() != 0;
}

/** Of three components without a map to colours: no alpha. */
bool IsOpaque(vtkTexture* texture)
{
  vtkImageData* image = IsInputMade(texture) ? texture->GetInput() : nullptr;
  vtkDataArray* colors = image ? AnyTexture::ColorsOf(texture, image) : nullptr;
  return colors && colors->GetNumberOfComponents() == 3 &&
    colors->GetDataType() == VTK_UNSIGNED_CHAR && texture->GetColorMode() == VTK_COLOR_MODE_DEFAULT;
}

/** Its own, and those of its property. */
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

vtkActor* AsHideable(vtkProp* prop)
{
  vtkActor* actor = IsExactly<vtkOpenGLActor>(prop) ? static_cast<vtkActor*>(prop) : nullptr;
  if (!actor || !actor->GetMapper() || !IsKnownMapper(actor->GetMapper()))
  {
    return nullptr;
  }
  return StandsInWorld(actor) && !HasShaderCode(actor) ? actor : nullptr;
}

bool MayBeBehindOthers(vtkActor* actor, vtkMapper* drawing)
{
  vtkProperty* property = actor->GetProperty();
  return vtkMapper::GetResolveCoincidentTopology() == VTK_RESOLVE_OFF && !drawing->GetSelection() &&
    !property->GetEdgeVisibility() && !property->GetVertexVisibility() &&
    !property->GetRenderPointsAsSpheres() && !property->GetRenderLinesAsTubes();
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

bool IsShiftKnown(vtkPolyDataMapper* mapper)
{
  const int method = static_cast<vtkOpenGLPolyDataMapper*>(mapper)->GetVBOShiftScaleMethod();
  return method == vtkOpenGLVertexBufferObject::AUTO_SHIFT_SCALE ||
    method == vtkOpenGLVertexBufferObject::ALWAYS_AUTO_SHIFT_SCALE ||
    method == vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE;
}

bool IsSmallOrFarOff(const PartGeometry& geometry)
{
  const glm::dvec3 size = geometry.Greatest() - geometry.Least();
  const glm::dvec3 middle = 0.5 * (geometry.Greatest() + geometry.Least());
  // VTK's limits are 1e6 and 3. Just above them it is taken not to, which is never the better case.
  return glm::dot(size, size) > 0.0 &&
    (glm::dot(middle, middle) / glm::dot(size, size) > 1.001e6 ||
      std::abs(std::log10(glm::dot(size, size))) > 3.001);
}

bool IsDrawnAboutMiddle(vtkPolyDataMapper* mapper, const PartGeometry& geometry)
{
  auto* drawing = static_cast<vtkOpenGLPolyDataMapper*>(mapper);
  const bool isUsual = !drawing->GetPauseShiftScale() &&
    drawing->GetVBOShiftScaleMethod() == vtkOpenGLVertexBufferObject::AUTO_SHIFT_SCALE &&
    vtkOpenGLVertexBufferObject::GetGlobalCoordShiftAndScaleEnabled();
  return isUsual && IsSmallOrFarOff(geometry) && !HasUnshiftedPoints(drawing);
}

float GrowthOf(vtkActor* actor, const PartGeometry& geometry)
{
  const bool isThin =
    actor->GetProperty()->GetRepresentation() != VTK_SURFACE || geometry.HasThinCells();
  return isThin ? WidthOf(actor) + BesidesWidth : 0.0f;
}

float MostGrowthOf(vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  return BesidesWidth +
    std::max(
      { WidthOf(actor), property->GetSelectionLineWidth(), property->GetSelectionPointSize() });
}

bool IsNonOccluding(vtkActor* actor)
{
  vtkInformation* keys = actor->GetPropertyKeys();
  return keys && keys->Get(vtkHierarchicalSBufferCuller::NON_OCCLUDING()) != 0;
}

bool IsOpaque(vtkActor* actor)
{
  return !IsTranslucentAsAWhole(actor) && actor->GetProperty()->GetOpacity() >= 1.0 &&
    !HasTranslucentBack(actor) && !MayHaveTranslucentColors(actor->GetMapper());
}

bool IsOpaqueSurface(vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  vtkPlaneCollection* planes = actor->GetMapper()->GetClippingPlanes();
  return property->GetRepresentation() == VTK_SURFACE && !property->GetFrontfaceCulling() &&
    !actor->GetForceOpaque() && !(planes && planes->GetNumberOfItems() > 0) && IsOpaque(actor);
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
