#include "culling/PropPolicy.h"

#include "culling/CullingPolicy.h"
#include "culling/PartGeometry.h"
#include "culling/PartRules.h"
#include "culling/mappers/DividedMapper.h"
#include "culling/mappers/vtkCulledCompositePolyDataMapper.h"
#include "scene/ActorRules.h"
#include "scene/ClassName.h"
#include "scene/CutProps.h"
#include "scene/DrawingMapper.h"
#include "scene/Matrices.h"
#include "scene/ScalarColors.h"

#include "vtkActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkCellArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkFlagpoleLabel.h"
#include "vtkImageMapper3D.h"
#include "vtkImageSlice.h"
#include "vtkMapper.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSkybox.h"
#include "vtkTextActor3D.h"

#include <algorithm>
#include <array>

namespace vitrine
{

namespace
{

// The largest sum that leads to world coordinates. Products of larger ones with the matrix of a view may exceed floats.
const double FarthestSum = 1e15;

bool IsComposite(vtkMapper* mapper)
{
  return mapper->IsA("vtkCompositePolyDataMapper2") || mapper->IsA("vtkCompositePolyDataMapper");
}

/**
 * Returns true if the mapper draws within the bounds of its data. Other mappers may draw balls or splats around points,
 * or anything.
 */
bool KeepsToItsBounds(vtkMapper* mapper)
{
  return IsKnownMapper(mapper) || IsComposite(mapper) ||
    IsExactlyOfClass(mapper, "vtkOpenGLGlyph3DMapper");
}

/**
 * Returns true for mappers that blend though VTK takes their colours to be opaque. These are splats, which fade. Others
 * draw what they like in the opaque pass, as labels of contours, or edges of graphs.
 */
bool BlendsByItself(vtkMapper* mapper)
{
  const std::array<const char*, 4> others{ "vtkPolyDataMapper", "vtkDataSetMapper",
    "vtkGlyph3DMapper", "vtkMoleculeMapper" };
  return mapper->IsA("vtkPointGaussianMapper") ||
    std::none_of(
      others.begin(), others.end(), [mapper](const char* other) { return mapper->IsA(other); });
}

/** Returns true if VTK draws the whole actor as translucent. Blocks of a composite mapper are looked at one by one. */
bool IsTranslucentAsAWhole(vtkActor* actor)
{
  return IsComposite(actor->GetMapper()) ? actor->GetForceTranslucent()
                                         : actor->HasTranslucentPolygonalGeometry() != 0;
}

bool IsTransparent(vtkActor* actor)
{
  return !(actor->GetProperty()->GetOpacity() >= 1.0);
}

bool HasClippingPlanes(vtkMapper* mapper)
{
  vtkPlaneCollection* const planes = mapper->GetClippingPlanes();
  return planes && planes->GetNumberOfItems() > 0;
}

/** Returns true if there are polygons and strips only. Data that are not known may have others. */
bool HasFacesAlone(vtkDataObject* data)
{
  if (auto* const mesh = vtkPolyData::SafeDownCast(data))
  {
    return mesh->GetNumberOfVerts() == 0 && mesh->GetNumberOfLines() == 0;
  }
  auto* const tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    return false;
  }
  const auto children = vtk::Range(tree, vtk::DataObjectTreeOptions::SkipEmptyNodes);
  return std::all_of(
    children.begin(), children.end(), [](vtkDataObject* child) { return HasFacesAlone(child); });
}

/**
 * Returns true if VTK offsets depths of what the actor draws. ParaView offsets lines and points, and has 0 for faces.
 */
bool HasOffsetDepths(vtkActor* actor, vtkPolyDataMapper* mapper)
{
  if (vtkMapper::GetResolveCoincidentTopology() == VTK_RESOLVE_OFF)
  {
    return false;
  }
  double factor = 0.0, units = 0.0;
  mapper->GetCoincidentTopologyPolygonOffsetParameters(factor, units);
  return vtkMapper::GetResolveCoincidentTopology() != VTK_RESOLVE_POLYGON_OFFSET || factor != 0.0 ||
    units != 0.0 || actor->GetProperty()->GetRepresentation() != VTK_SURFACE ||
    mapper->GetNumberOfInputConnections(0) == 0 || !HasFacesAlone(mapper->GetInputDataObject(0, 0));
}

bool IsFar(const glm::dvec3& sums)
{
  return !(std::max(sums.x, std::max(sums.y, sums.z)) <= FarthestSum);
}

template <class Text>
bool IsOpaqueText(vtkProp* prop)
{
  auto* const text = Text::SafeDownCast(prop);
  const char* const input = text ? text->GetInput() : nullptr;
  return input && *input && !text->HasTranslucentPolygonalGeometry();
}

/**
 * Returns true if there is any text in the opaque pass. A text is an image with an alpha. Its place is not known:
 * nobody but VTK must ask texts that look at the eye for it, since that turns them.
 */
bool IsOpaqueText(vtkProp* prop)
{
  return IsOpaqueText<vtkTextActor3D>(prop) || IsOpaqueText<vtkBillboardTextActor3D>(prop) ||
    IsOpaqueText<vtkFlagpoleLabel>(prop);
}

/**
 * Returns true for the floor of a sky, which fades towards the horizon. All else of a sky is at the far plane, behind
 * everything.
 */
bool IsFloorBelowSky(vtkProp* prop)
{
  auto* const sky = vtkSkybox::SafeDownCast(prop);
  return sky && sky->GetProjection() == vtkSkybox::Floor;
}

/** Returns true for an image in the opaque pass. Images of VTK have alpha, and fade where they end. */
bool IsOpaqueImage(vtkProp* prop)
{
  auto* const image = vtkImageSlice::SafeDownCast(prop);
  return image && image->GetMapper() && !image->HasTranslucentPolygonalGeometry();
}

bool IsWiderThanItsBounds(vtkProp* prop)
{
  auto* const image = vtkImageSlice::SafeDownCast(prop);
  return image &&
    (image->GetMapper()->GetBackground() || image->GetMapper()->GetBorder() ||
      image->IsA("vtkImageStack"));
}

std::string MapperOf(vtkProp* prop)
{
  auto* const actor = vtkActor::SafeDownCast(prop);
  return actor && actor->GetMapper() ? actor->GetMapper()->GetClassName() : "";
}

using Facts = const PropFacts&;

std::vector<PropRow> MakeRows()
{
  std::vector<PropRow> rows;
  for (const DrawnElsewhereRow& row : DrawnElsewhereRows())
  {
    rows.push_back({ PropStage::Class, PropEffect::AlwaysDrawn, row.Condition, row.Why,
      [&row](Facts facts) { return row.Applies(facts.Prop); }, row.Detail });
  }
  const std::vector<PropRow> others = {
    { PropStage::Mapper, PropEffect::AlwaysDrawn,
      "its mapper draws one of several pieces, or is a vtkDataSetMapper that has yet to draw its "
      "input",
      "what it draws is known only once it is drawn", [](Facts facts) { return !facts.Mapper; } },
    { PropStage::Mapper, PropEffect::AlwaysDrawn,
      "its scalars bring a lookup table that its mapper has not got yet",
      "what is translucent is known only once it is drawn",
      [](Facts facts)
      {
        vtkMapper* const mapper = facts.Actor->GetMapper();
        return BringTheirTable(mapper, ScalarsOf(mapper, mapper->GetInput()));
      } },
    { PropStage::Depths, PropEffect::ViewAlone,
      "depths of its faces, lines or points are offset (vtkMapper::SetResolveCoincidentTopology)",
      "it is drawn at other depths than its own",
      [](Facts facts) { return HasOffsetDepths(facts.Actor, facts.Mapper); } },
    { PropStage::Depths, PropEffect::ViewAlone, "it has a selection (vtkMapper::SetSelection)",
      "the selection is drawn at other depths than its own",
      [](Facts facts) { return DrawsSelection(facts.Mapper); } },
    { PropStage::Depths, PropEffect::ViewAlone,
      "its edges or vertices are shown (EdgeVisibility, VertexVisibility)",
      "they are drawn at other depths than its faces",
      [](Facts facts)
      {
        vtkProperty* const property = facts.Actor->GetProperty();
        return property->GetEdgeVisibility() || property->GetVertexVisibility();
      } },
    { PropStage::Depths, PropEffect::ViewAlone,
      "its points are spheres, or its lines are tubes (RenderPointsAsSpheres, RenderLinesAsTubes)",
      "they are drawn nearer than they are",
      [](Facts facts)
      {
        vtkProperty* const property = facts.Actor->GetProperty();
        return property->GetRenderPointsAsSpheres() || property->GetRenderLinesAsTubes();
      } },
    { PropStage::Division, PropEffect::AlwaysDrawn,
      "one of its blocks has points that are no finite numbers",
      "they may spoil what is drawn with them",
      [](Facts facts) { return !facts.Division->IsFinite; } },
    { PropStage::Division, PropEffect::AlwaysDrawn, "it has no blocks of polygons",
      "there is nothing to be hidden", [](Facts facts) { return facts.Division->Parts.empty(); } },
    { PropStage::Data, PropEffect::AlwaysDrawn, "its mapper has no data",
      "it may get some while it is drawn", [](Facts facts) { return !facts.Mapper->GetInput(); } },
    { PropStage::Place, PropEffect::AlwaysDrawn,
      "its mapper is told where coordinates count from (SetVBOShiftScaleMethod)",
      "how a device rounds them is not known",
      [](Facts facts) { return facts.Mapper && !IsShiftKnown(facts.Mapper); } },
    { PropStage::Place, PropEffect::AlwaysDrawn, "it has points that are no finite numbers",
      "where they are drawn is not known",
      [](Facts facts) { return !facts.Geometry->IsFinite(); } },
    { PropStage::Place, PropEffect::AlwaysDrawn, "its matrix is not affine",
      "it does not keep faces flat", [](Facts facts) { return !IsAffine(*facts.ToWorld); } },
    { PropStage::Place, PropEffect::AlwaysDrawn, "it has no points",
      "there is nothing to be hidden",
      [](Facts facts) { return !(facts.Geometry->Least().x <= facts.Geometry->Greatest().x); } },
    { PropStage::Distance, PropEffect::AlwaysDrawn,
      "it is farther than 1e15 from the origin, in units of the world",
      "products with the matrix of a view may be more than floats hold",
      [](Facts facts) { return IsFar(*facts.Sums); } },
    { PropStage::Opacity, PropEffect::HidesNothing, "its opacity is below 1",
      "it lets light through", [](Facts facts) { return IsTransparent(facts.Actor); } },
    { PropStage::Opacity, PropEffect::HidesNothing, "the opacity of its back faces is below 1",
      "they let light through", [](Facts facts) { return HasTranslucentBack(facts.Actor); } },
    { PropStage::Opacity, PropEffect::HidesNothing, "colours of its scalars may be translucent",
      "they let light through",
      [](Facts facts) { return MayHaveTranslucentColors(facts.Actor->GetMapper()); } },
    { PropStage::Opacity, PropEffect::HidesNothing,
      "VTK draws it as translucent for another reason, as after ForceTranslucentOn",
      "it may let light through", [](Facts facts) { return IsTranslucentAsAWhole(facts.Actor); } },
    { PropStage::Surface, PropEffect::HidesNothing, "its representation is not a surface",
      "lines and points cover nothing",
      [](Facts facts) { return facts.Actor->GetProperty()->GetRepresentation() != VTK_SURFACE; } },
    { PropStage::Surface, PropEffect::HidesNothing, "its front faces are culled",
      "back faces alone are drawn",
      [](Facts facts) { return facts.Actor->GetProperty()->GetFrontfaceCulling() != 0; } },
    { PropStage::Surface, PropEffect::HidesNothing,
      "it is drawn as opaque whatever it is (ForceOpaqueOn)", "it may let light through",
      [](Facts facts) { return facts.Actor->GetForceOpaque(); } },
    { PropStage::Surface, PropEffect::HidesNothing, "its mapper has clipping planes",
      "they cut holes into it",
      [](Facts facts) { return HasClippingPlanes(facts.Actor->GetMapper()); } },
    { PropStage::Part, PropEffect::HidesNothing,
      "it is a block with an opacity, colours, a table or textures of its own",
      "it may let light through", [](Facts facts) { return !facts.Piece->MayHide; } },
    { PropStage::Frame, PropEffect::HidesNothing,
      "it has a texture with an alpha, or one that is not known", "it may let light through",
      [](Facts facts) { return !AreTexturesOpaque(facts.Actor); } },
    { PropStage::Frame, PropEffect::HidesNothing, "a vtkSection removes a piece of it",
      "other parts show where the piece was",
      [](Facts facts) { return IsMarkedAsCut(facts.Actor); } },
    { PropStage::Frame, PropEffect::HidesNothing, "it is marked by NON_OCCLUDING()",
      "the user says so", [](Facts facts) { return IsNonOccluding(facts.Actor); } },
    { PropStage::Frame, PropEffect::HidesNothing,
      "it has no polygons, or has ghost cells or points", "nothing else is sure to cover anything",
      [](Facts facts) { return facts.Geometry && !facts.Geometry->HasSurePolygons(); } },
    { PropStage::Hidden, PropEffect::ViewAlone, "its representation is a wireframe",
      "lines go on beyond their ends, at any depth",
      [](Facts facts) { return IsWireframe(facts.Actor); } },
    { PropStage::Hidden, PropEffect::ViewAlone, "its data change in most frames",
      "to read them takes longer than to draw them",
      [](Facts facts) { return facts.Geometry->IsRestless(facts.Frame); } },
    { PropStage::Blending, PropEffect::Blends,
      "it is a text that VTK draws among what is opaque (ForceOpaqueOn)",
      "a text is an image with an alpha",
      [](Facts facts) { return !facts.Actor && IsOpaqueText(facts.Prop); } },
    { PropStage::Blending, PropEffect::Blends, "it is the floor below a vtkSkybox",
      "it fades towards the horizon",
      [](Facts facts) { return !facts.Actor && IsFloorBelowSky(facts.Prop); } },
    { PropStage::Blending, PropEffect::Blends,
      "it is an image that VTK draws among what is opaque (vtkImageSlice, vtkImageActor)",
      "images have an alpha, and fade where they end",
      [](Facts facts) { return !facts.Actor && IsOpaqueImage(facts.Prop); } },
    { PropStage::Blending, PropEffect::Blends,
      "its opacity is below 1, and it is forced to be opaque", "VTK blends it all the same",
      [](Facts facts) { return facts.Actor && IsTransparent(facts.Actor); } },
    { PropStage::Blending, PropEffect::Blends, "the opacity of its back faces is below 1",
      "VTK blends them as it draws its front faces",
      [](Facts facts) { return facts.Actor && HasTranslucentBack(facts.Actor); } },
    { PropStage::Blending, PropEffect::Blends,
      "its shaders have code of the user's, or its mapper an observer of UpdateShaderEvent",
      "they may give it an alpha",
      [](Facts facts) { return facts.Actor && HasShaderCode(facts.Actor); } },
    { PropStage::Blending, PropEffect::Blends,
      "it has a texture with an alpha that VTK does not know of", "the alpha is blended",
      [](Facts facts) { return facts.Actor && !facts.AreTexturesOpaque; } },
    { PropStage::Blending, PropEffect::Blends,
      "colours of its scalars may be translucent, which VTK does not know of", "they are blended",
      [](Facts facts)
      {
        return facts.Actor && facts.Actor->GetMapper() &&
          MayHaveTranslucentColors(facts.Actor->GetMapper());
      } },
    { PropStage::Blending, PropEffect::Blends, "it is drawn in blocks, and is forced to be opaque",
      "blocks may be translucent",
      [](Facts facts)
      {
        return facts.Actor && facts.Actor->GetForceOpaque() && facts.Actor->GetMapper() &&
          IsComposite(facts.Actor->GetMapper());
      } },
    { PropStage::Blending, PropEffect::Blends, "its mapper draws splats, labels, or what it likes",
      "they are blended among what is opaque",
      [](Facts facts) {
        return facts.Actor && facts.Actor->GetMapper() && BlendsByItself(facts.Actor->GetMapper());
      },
      MapperOf },
    { PropStage::Beside, PropEffect::BlendsAnywhere, "it blends, and is a text",
      "it turns towards the eye",
      [](Facts facts) { return !facts.Actor && IsOpaqueText(facts.Prop); } },
    { PropStage::Beside, PropEffect::BlendsAnywhere,
      "it blends, and is the floor below a vtkSkybox", "it is as wide as the sky",
      [](Facts facts) { return !facts.Actor && IsFloorBelowSky(facts.Prop); } },
    { PropStage::Beside, PropEffect::BlendsAnywhere,
      "it blends, and is an image with a border or background, or a vtkImageStack",
      "it is wider than its bounds",
      [](Facts facts) { return !facts.Actor && IsWiderThanItsBounds(facts.Prop); } },
    { PropStage::Beside, PropEffect::BlendsAnywhere,
      "it blends, and the class of its mapper is not known", "it may draw beside its bounds",
      [](Facts facts) {
        return facts.Actor && facts.Actor->GetMapper() &&
          !KeepsToItsBounds(facts.Actor->GetMapper());
      },
      MapperOf },
  };
  rows.insert(rows.end(), others.begin(), others.end());
  return rows;
}

using StageRows = std::vector<const PropRow*>;

/** Returns the rules of a stage, so that no other rule is looked at. */
const StageRows& RowsOf(PropStage stage)
{
  static const std::vector<StageRows> rowsOfStages = []
  {
    std::vector<StageRows> all(static_cast<std::size_t>(PropStage::Count));
    for (const PropRow& row : PropRows())
    {
      all[static_cast<std::size_t>(row.Stage)].push_back(&row);
    }
    return all;
  }();
  return rowsOfStages[static_cast<std::size_t>(stage)];
}
}

const char* EffectOf(PropEffect effect)
{
  switch (effect)
  {
    case PropEffect::AlwaysDrawn:
      return "it is always drawn, and hides nothing";
    case PropEffect::ViewAlone:
      return "only the view hides it, and it hides nothing";
    case PropEffect::HidesNothing:
      return "it hides nothing";
    case PropEffect::Blends:
      return "what lies behind it is drawn";
    case PropEffect::BlendsAnywhere:
      break;
  }
  return "all in the view is drawn";
}

const std::vector<PropRow>& PropRows()
{
  static const std::vector<PropRow> rows = MakeRows();
  return rows;
}

std::uint8_t NumberOf(const PropRow* row)
{
  return row ? static_cast<std::uint8_t>(row - PropRows().data()) : NoPropRow;
}

const PropRow* FindPropRow(PropStage stage, const PropFacts& facts)
{
  for (const PropRow* const row : RowsOf(stage))
  {
    if (row->Applies(facts))
    {
      return row;
    }
  }
  return nullptr;
}

bool DrawsSelection(vtkMapper* mapper)
{
  vtkSelection* const selection = mapper->GetSelection();
  return selection && selection->GetNumberOfNodes() > 0;
}

std::string Explain(const PropRow& row, vtkProp* prop)
{
  return Sentence(row.Condition, row.Detail ? row.Detail(prop) : std::string(), row.Why);
}

}
