#include "culling/SceneParts.h"

#include "culling/PartRules.h"
#include "culling/PropPolicy.h"
#include "culling/mappers/BlockParts.h"
#include "scene/ActorRules.h"
#include "scene/ClassName.h"
#include "scene/CutProps.h"
#include "scene/DrawingMapper.h"

#include "vtkActor.h"
#include "vtkDataSetMapper.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkShaderProperty.h"
#include "vtkTrivialProducer.h"

#include <glm/common.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace vitrine
{

namespace
{

// The most geometries per part. If there are more, those of deleted data are forgotten.
const std::size_t MostGeometries = 2;
}

bool SceneParts::Update(vtkProp* const* props, int count)
{
  ++this->Frame;
  this->ForgetAbsent();
  this->LookAnewIfSettingsChanged();
  std::vector<std::uint32_t> moved;
  const bool hasChanged = this->LookAtAll(props, count, moved);
  // Parts that were looked at before a filter made data may show these data, too.
  if (this->HasMadeData)
  {
    this->LookAtAll(props, count, moved);
  }
  if (hasChanged)
  {
    this->Replant(moved);
    glm::dvec3 middle;
    if (this->IsFarOff(middle))
    {
      this->MoveOrigin(middle);
    }
    this->MeasureAll();
    this->Kept.clear();
    this->ForgetDeadGeometries();
  }
  return !this->HasImagesToMake;
}

/** Looks at the parts that have changed, in their order. Returns true if there were any. */
bool SceneParts::LookAtAll(vtkProp* const* props, int count, std::vector<std::uint32_t>& moved)
{
  ++this->Looks;
  this->HasMadeData = false;
  this->AreOpaque.clear();
  this->FindAll(props, count);
  this->FindUnchanged();
  this->HasImagesToMake = !this->AreImagesMade();
  if (this->HasImagesToMake)
  {
    return false;
  }
  bool hasChanged = false;
  for (std::size_t i = 0; i < this->Drawn.size(); ++i)
  {
    const std::uint32_t part = this->Drawn[i];
    const bool isSame = this->AreSame[i] || this->IsUnchanged(part);
    if (!isSame)
    {
      this->Look(part);
      this->PlaceWhole(part, moved);
      hasChanged = true;
    }
    if (!isSame || !this->IsPlain(part))
    {
      this->LookAtOpacity(part);
    }
  }
  return hasChanged;
}

/**
 * Looks at all parts anew if settings of the whole program have changed: offsets of depths, and whether mappers shift
 * coordinates. No time of a part tells of these.
 */
void SceneParts::LookAnewIfSettingsChanged()
{
  ProgramSettings now;
  now.Coincident = vtkMapper::GetResolveCoincidentTopology();
  vtkMapper::GetResolveCoincidentTopologyPolygonOffsetParameters(now.Factor, now.Units);
  now.IsShifted = vtkOpenGLVertexBufferObject::GetGlobalCoordShiftAndScaleEnabled() != 0;
  const ProgramSettings before = std::exchange(this->Settings, now);
  if (before.Coincident != now.Coincident || before.Factor != now.Factor ||
    before.Units != now.Units || before.IsShifted != now.IsShifted)
  {
    for (Part& part : this->Parts)
    {
      part.PropTime = 0;
    }
  }
}

/** Finds what a prop lets through by its textures or otherwise. It is called for props that may have changed. */
void SceneParts::LookAtOpacity(std::uint32_t part)
{
  vtkActor* const actor = vtkActor::SafeDownCast(this->PropOf[part]);
  if (!actor)
  {
    this->Blends[part] = BlendingOf(this->PropOf[part]);
    return;
  }
  const bool areTexturesOpaque = AreTexturesOpaque(actor);
  this->AreOpaque[actor] = areTexturesOpaque;
  this->Blends[part] = BlendingOf(actor, areTexturesOpaque);
}

/** Reads a part anew. */
void SceneParts::Look(std::uint32_t i)
{
  Part& part = this->Parts[i];
  vtkProp* const prop = this->PropOf[i];
  this->Living[i] = prop;
  part.PropTime = prop->GetMTime();
  part.Shader = ShaderPropertyOf(prop);
  part.ShaderTime = part.Shader ? part.Shader->GetMTime() : 0;
  PropFacts facts;
  facts.Prop = prop;
  part.AlwaysDrawnBy = FindPropRow(PropStage::Class, facts);
  part.Actor = part.AlwaysDrawnBy ? nullptr : static_cast<vtkActor*>(prop);
  const vtkMapper* const mapperBefore = part.Mapper;
  part.Divided = nullptr;
  part.Division.reset();
  const std::shared_ptr<PartGeometry> before =
    std::move(part.Geometry); // found again if it is still current
  if (!part.Actor)
  {
    return;
  }
  this->LookAtMapper(part);
  part.AlwaysDrawnBy = FindPropRow(PropStage::Mapper, FactsOf(part));
  if (part.AlwaysDrawnBy)
  {
    part.Actor = nullptr;
    part.PropTime = 0; // the mapper may change without a change of the actor
    return;
  }
  part.ViewAloneBy = FindPropRow(PropStage::Depths, FactsOf(part));
  part.IsOfViewAlone = part.ViewAloneBy != nullptr;
  part.Divided = part.IsOfViewAlone ? nullptr : DividerOf(part);
  part.Division = part.Divided ? part.Divided->PartsFor(part.Actor, this->Looks) : nullptr;
  if (!part.Division)
  {
    this->LookAtData(part, part.Mapper == mapperBefore ? before.get() : nullptr);
  }
}

/** Notes which mapper draws the actor, if that is known. Makes its data then. */
void SceneParts::LookAtMapper(Part& part)
{
  part.SurfaceMapper = SurfaceMapperOf(part.Actor);
  part.HasSurfaceMapper = part.SurfaceMapper != nullptr;
  part.SurfaceMapperTime = part.SurfaceMapper ? part.SurfaceMapper->GetMTime() : 0;
  part.HasLevels = !IsExactly<vtkOpenGLActor>(part.Actor);
  part.OfActor = part.Actor->GetMapper();
  part.Mapper = DrawingMapperOf(part.Actor);
  part.HasSelection = part.Mapper && DrawsSelection(part.Mapper);
  if (!part.Mapper)
  {
    return;
  }
  const bool hasInput = part.Mapper->GetNumberOfInputConnections(0) > 0;
  part.Producer =
    hasInput ? vtkTrivialProducer::SafeDownCast(part.Mapper->GetInputAlgorithm()) : nullptr;
  part.Pipeline = PipelineState();
  if (!part.Producer && hasInput && !part.Mapper->GetStatic())
  {
    this->MakeData(part);
  }
  part.MapperTime = part.Mapper->GetMTime();
  part.ProducerTime = part.Producer ? part.Producer->vtkObject::GetMTime() : 0;
  const bool hasFilter = part.SurfaceMapper && !part.Producer &&
    part.SurfaceMapper->GetInput()->GetDataObjectType() != VTK_POLY_DATA;
  part.Input = hasFilter ? part.SurfaceMapper->GetInput() : nullptr;
  part.InputTime = hasFilter ? part.Input->GetMTime() : 0;
  part.Filter = hasFilter ? part.Mapper->GetInputAlgorithm() : nullptr;
  part.FilterTime = hasFilter ? part.Filter->GetMTime() : 0;
}

/** Returns what divides a part, or null. VTK's own composite mapper is divided here. */
DividedMapper* SceneParts::DividerOf(Part& part)
{
  if (!IsCompositeMapperOfVTK(part.Mapper))
  {
    part.Blocks.reset();
    return DividedMapperOf(part.Mapper);
  }
  if (!part.Blocks || !part.Blocks->IsOf(part.Mapper))
  {
    part.Blocks = std::make_shared<BlockParts>(static_cast<VITRINE_COMPOSITE_MAPPER*>(part.Mapper));
  }
  return part.Blocks.get();
}

PropFacts SceneParts::FactsOf(const Part& part) const
{
  PropFacts facts;
  facts.Prop = part.Actor;
  facts.Actor = part.Actor;
  facts.Mapper = part.Mapper;
  facts.Division = part.Division.get();
  facts.Geometry = part.Geometry.get();
  facts.ToWorld = &part.ToWorld;
  facts.Sums = &part.Sums;
  facts.Frame = this->Looks;
  return facts;
}

/** Lets filters make the data that the mapper draws. Notes if these are other data than before. */
void SceneParts::MakeData(Part& part)
{
  vtkDataObject* before = part.Mapper->GetInputDataObject(0, 0);
  const vtkMTimeType time = before ? before->GetMTime() : 0;
  part.Pipeline = PipelineState(part.Mapper);
  vtkDataObject* data = part.Mapper->GetInputDataObject(0, 0);
  this->HasMadeData = this->HasMadeData || data != before || (data && data->GetMTime() != time);
}

/**
 * Reads the data of an actor that is drawn as a whole.
 * @param before  what its mapper has drawn before, if that is known
 */
void SceneParts::LookAtData(Part& part, const PartGeometry* before)
{
  part.Data = part.Mapper->GetInput();
  part.AlwaysDrawnBy = FindPropRow(PropStage::Data, FactsOf(part));
  if (!part.AlwaysDrawnBy)
  {
    part.Geometry = this->GeometryOf(part.Data, before);
    part.DataTime = part.Geometry->TimeOf(part.Data, this->Looks);
  }
  else
  {
    part.Actor = nullptr;
    part.PropTime = 0; // the mapper may get data without a change of the actor
  }
}

/**
 * Returns the geometry of data, which may be shared.
 * @param before  what a mapper has drawn in place of them, if that is known; so data that are replaced in each frame
 *                are not read in each frame
 */
std::shared_ptr<PartGeometry> SceneParts::GeometryOf(vtkPolyData* data, const PartGeometry* before)
{
  std::weak_ptr<PartGeometry>& known = this->Geometries[data];
  std::shared_ptr<PartGeometry> geometry = known.lock();
  if (!geometry || !geometry->IsCurrent(data, this->Looks))
  {
    geometry = std::make_shared<PartGeometry>(
      data, geometry && geometry->WasOf(data) ? geometry.get() : before);
    known = geometry;
  }
  return geometry;
}

/** Forgets geometries of deleted data. Otherwise animations would leave more and more of them. */
void SceneParts::ForgetDeadGeometries()
{
  if (this->Geometries.size() <= MostGeometries * this->Parts.size())
  {
    return;
  }
  for (auto i = this->Geometries.begin(); i != this->Geometries.end();)
  {
    i = i->second.expired() ? this->Geometries.erase(i) : std::next(i);
  }
}

void SceneParts::MarkDrawn(std::vector<std::uint8_t>& visible) const
{
  visible.assign(this->Parts.size(), 0);
  for (const std::uint32_t part : this->Drawn)
  {
    this->Mark(part, visible);
  }
}

/** Sets the byte of a prop and of all of its pieces. */
void SceneParts::Mark(
  std::uint32_t part, std::vector<std::uint8_t>& visible, std::uint8_t value) const
{
  visible[part] = value;
  if (this->HasPieces[part])
  {
    for (const std::uint32_t piece : this->Parts[part].Pieces)
    {
      visible[piece] = value;
    }
  }
}

int SceneParts::CountParts(int i) const
{
  const std::uint32_t part = this->Drawn[static_cast<std::size_t>(i)];
  return this->HasPieces[part] ? static_cast<int>(this->Parts[part].Pieces.size()) : 1;
}

int SceneParts::CountHidden(int i, const std::vector<std::uint8_t>& visible) const
{
  const std::uint32_t part = this->Drawn[static_cast<std::size_t>(i)];
  if (!this->HasPieces[part])
  {
    return !visible[part];
  }
  const std::vector<std::uint32_t>& pieces = this->Parts[part].Pieces;
  return static_cast<int>(std::count_if(
    pieces.begin(), pieces.end(), [&](std::uint32_t piece) { return !visible[piece]; }));
}

std::shared_ptr<const ShownParts> SceneParts::TellMapper(vtkRenderer* renderer,
  const ViewMatrices& view, int i, const std::vector<std::uint8_t>& visible) const
{
  const Part& part = this->Parts[this->Drawn[static_cast<std::size_t>(i)]];
  if (part.Pieces.empty() || part.Blocks)
  {
    return nullptr;
  }
  std::vector<std::uint8_t> shown;
  for (const std::uint32_t piece : part.Pieces)
  {
    shown.push_back(visible[piece] != IsLeftOut);
  }
  auto told = std::make_shared<const ShownParts>(view, part.Actor, part.Division, std::move(shown));
  part.Divided->SetShown(renderer, part.Actor, told);
  return told;
}

Occluder SceneParts::OccluderOf(std::uint32_t i)
{
  const Part& part = this->Parts[i];
  const bool hides = part.MayHide && this->IsOpaque(part) && !IsMarkedAsCut(part.Actor) &&
    !IsNonOccluding(part.Actor);
  return hides ? this->ShapeOf(i) : Occluder();
}

/** Returns true if a part is opaque. The frame must draw it. */
bool SceneParts::IsOpaque(const Part& part) const
{
  return part.IsOpaque && !(part.HasTextures && !this->AreOpaque.at(part.Actor));
}

/** Returns the mesh of a part, whether it hides others or not. */
Occluder SceneParts::ShapeOf(std::uint32_t i)
{
  const Part& part = this->Parts[i];
  const OccluderMesh& mesh = part.Geometry->Occluder(part.Data, this->Looks);
  if (mesh.PointCount() == 0)
  {
    return {}; // then its box is tested, and not its points
  }
  return { &mesh, &part.ToWorld, &part.Drawn, part.HasBackFaces, part.Geometry->Boxes(),
    part.Geometry->IsOfFacesAlone() };
}

void SceneParts::PrefetchOccluder(std::uint32_t i) const
{
  Prefetch(&this->Parts[i]);
  Prefetch(&this->Parts[i].ToWorld);
}

}
