#include "culling/SceneParts.h"

#include "Core/culling/DeviceRounding.h"
#include "culling/ActorRules.h"
#include "culling/Matrices.h"

#include "vtkActor.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
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

// A tree is built anew once more than one part in so many has been put into it, or moved.
const std::size_t FewOf = 16;

// Where parts were absent for more updates than that, all is read anew: they may be gone for good.
const vtkMTimeType LongestAbsence = 1000;

// Geometries that are gone are dropped where there are more than so many to a part.
const std::size_t MostGeometries = 2;

// Of the sums that lead to world coordinates: farther away, their products with a view's matrix may be more than floats hold.
const double FarthestSum = 1e15;

/** Whether the matrix keeps parallels parallel, as all but those of users' making do. */
bool IsAffine(const glm::dmat4& m)
{
  return m[0][3] == 0.0 && m[1][3] == 0.0 && m[2][3] == 0.0 && m[3][3] == 1.0;
}
}

void SceneParts::Update(vtkProp* const* props, int count)
{
  ++this->Frame;
  if (this->Frame % LongestAbsence == 0)
  {
    this->ForgetAbsent();
  }
  this->LookAnewIfOffsetsChanged();
  std::vector<std::uint32_t> moved;
  bool hasChanged = false;
  this->Drawn.resize(static_cast<std::size_t>(count));
  this->Cursor = 0;
  for (int i = 0; i < count; ++i)
  {
    const std::uint32_t part = this->Find(props[i]);
    this->Drawn[static_cast<std::size_t>(i)] = part;
    this->Parts[part].SeenIn = this->Frame;
    if (!this->IsUnchanged(this->Parts[part]))
    {
      this->Look(this->Parts[part]);
      this->PlaceWhole(part, moved);
      hasChanged = true;
    }
  }
  if (hasChanged)
  {
    this->Replant(moved);
    this->MeasureAll();
    this->DropDeadGeometries();
  }
}

/** What mappers offset depths by is a setting of the whole program, which no part's time tells of. */
void SceneParts::LookAnewIfOffsetsChanged()
{
  const int offsets = vtkMapper::GetResolveCoincidentTopology();
  if (std::exchange(this->Offsets, offsets) != offsets)
  {
    for (Part& part : this->Parts)
    {
      part.PropTime = 0;
    }
  }
}

/** Begins anew, if there are parts to be forgotten. */
void SceneParts::ForgetAbsent()
{
  const bool isAnyAbsent = std::any_of(this->Parts.begin(), this->Parts.end(),
    [&](const Part& part) { return part.Prop && part.SeenIn + LongestAbsence < this->Frame; });
  if (isAnyAbsent)
  {
    this->Parts.clear();
    this->Spare.clear();
    this->BoxOf.clear();
    this->Index.clear();
    this->Geometries.clear();
    this->Boxes = LooseOctree();
  }
}

/** Props come in the same order from frame to frame, though some may be left out. */
std::uint32_t SceneParts::Find(vtkProp* prop)
{
  if (this->Cursor < this->Parts.size() && this->Parts[this->Cursor].Prop == prop)
  {
    return this->Cursor++;
  }
  const auto [place, isNew] =
    this->Index.try_emplace(prop, static_cast<std::uint32_t>(this->Parts.size()));
  if (isNew)
  {
    this->Parts.emplace_back();
    this->Parts.back().Prop = prop;
    this->BoxOf.emplace_back();
  }
  this->Cursor = place->second + 1;
  return place->second;
}

/** Whether a part is as it was; in the order in which what holds the next is known to be there. */
bool SceneParts::IsUnchanged(const Part& part) const
{
  if (part.Prop->GetMTime() != part.PropTime)
  {
    return false;
  }
  if (!part.Actor)
  {
    return true;
  }
  return ShaderPropertyOf(part.Prop) == part.Shader &&
    (!part.Shader || ShaderTimeOf(part.Shader) == part.ShaderTime) &&
    part.Mapper->GetMTime() == part.MapperTime && part.Producer &&
    part.Producer->vtkObject::GetMTime() == part.ProducerTime &&
    (!part.Divided || part.Divided->PartsFor(part.Actor) == part.Division) &&
    (part.Division || part.Geometry->IsCurrent(part.Data, this->Frame));
}

/** Notes what a part is now. */
void SceneParts::Look(Part& part)
{
  part.PropTime = part.Prop->GetMTime();
  part.Shader = ShaderPropertyOf(part.Prop);
  part.ShaderTime = part.Shader ? ShaderTimeOf(part.Shader) : 0;
  part.Actor = AsHideable(part.Prop);
  part.Divided = nullptr;
  part.Division.reset();
  const std::shared_ptr<PartGeometry> before =
    std::move(part.Geometry); // found again if it is still current
  if (!part.Actor)
  {
    return;
  }
  part.Mapper = static_cast<vtkPolyDataMapper*>(part.Actor->GetMapper());
  part.Producer = vtkTrivialProducer::SafeDownCast(part.Mapper->GetInputAlgorithm());
  if (!part.Producer && !part.Mapper->GetStatic())
  {
    part.Mapper->Update();
  }
  part.MapperTime = part.Mapper->GetMTime();
  part.ProducerTime = part.Producer ? part.Producer->vtkObject::GetMTime() : 0;
  part.Divided = DividedMapperOf(part.Mapper);
  part.Division = part.Divided ? part.Divided->PartsFor(part.Actor) : nullptr;
  if (!part.Division)
  {
    this->LookAtData(part);
  }
}

/** Notes what the actor shows as a whole. */
void SceneParts::LookAtData(Part& part)
{
  part.Data = part.Mapper->GetInput();
  if (part.Data)
  {
    part.Geometry = this->GeometryOf(part.Data);
  }
  else
  {
    part.Actor = nullptr;
    part.PropTime = 0; // the mapper may get some without the actor's knowing
  }
}

/** Notes where the actor stands, and whether anything of it may hide. */
void SceneParts::ReadActor(Part& part)
{
  double elements[16];
  part.Actor->GetMatrix(elements);
  part.ToWorld = MatrixOf(elements);
  part.MayHide = IsAffine(part.ToWorld) && IsOpaqueSurface(part.Actor);
}

/**
 * Returns the part's box: empty if it cannot be hidden.
 * @param farthest  the largest absolute coordinates of what the device computes with, in model coordinates (MC)
 */
Box SceneParts::Read(Part& part, const glm::dvec3& farthest) const
{
  part.Growth = GrowthOf(part.Actor, *part.Geometry);
  part.MayHide = part.MayHide && part.Geometry->IsFinite();
  const glm::dvec3& least = part.Geometry->Least();
  const glm::dvec3& greatest = part.Geometry->Greatest();
  if (!part.Geometry->IsFinite() || !IsAffine(part.ToWorld) || part.Growth < 0.0f ||
    !(least.x <= greatest.x))
  {
    part.Growth = 0.0f;
    return Box();
  }
  const glm::dvec3 middle(part.ToWorld * glm::dvec4(0.5 * (least + greatest), 1.0));
  glm::dvec3 half(0.0);
  part.Sums = glm::abs(glm::dvec3(part.ToWorld[3]));
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 direction = glm::abs(glm::dvec3(part.ToWorld[axis]));
    half += direction * (0.5 * (greatest[axis] - least[axis]));
    part.Sums += direction * farthest[axis];
  }
  if (!(std::max(part.Sums.x, std::max(part.Sums.y, part.Sums.z)) <= FarthestSum))
  {
    return Box();
  }
  half += RoundingOfSums * part.Sums; // boxes are of doubles, a device's floats reach farther
  return Box::Around(middle - half, middle + half);
}

/** Notes where a part is now, and that it has moved, if it has. */
void SceneParts::Place(std::uint32_t part, const Box& box, std::vector<std::uint32_t>& moved)
{
  if (!(this->BoxOf[part] == box))
  {
    this->BoxOf[part] = box;
    moved.push_back(part);
  }
}

/** Places a prop that was looked at: as one part, or as the parts that it is divided into. */
void SceneParts::PlaceWhole(std::uint32_t whole, std::vector<std::uint32_t>& moved)
{
  this->FitPieces(whole, moved);
  Part& part = this->Parts[whole];
  if (part.Actor)
  {
    this->ReadActor(part);
  }
  if (!part.Actor || part.Division)
  {
    this->Place(whole, Box(), moved);
  }
  else
  {
    const glm::dvec3 farthest =
      glm::max(glm::abs(part.Geometry->Least()), glm::abs(part.Geometry->Greatest()));
    this->Place(whole, this->Read(part, farthest), moved);
  }
  for (std::size_t i = 0; i < part.Pieces.size(); ++i)
  {
    const MapperPart& divided = part.Division->Parts[i];
    Part& piece = this->Parts[part.Pieces[i]];
    piece.Actor = part.Actor;
    piece.ToWorld = part.ToWorld;
    piece.Data = divided.Data;
    piece.Geometry = divided.Geometry;
    piece.MayHide = part.MayHide && divided.MayHide;
    this->Place(part.Pieces[i], this->Read(piece, part.Division->Farthest), moved);
  }
}

/** Gives a prop as many pieces as it is divided into; none where what cannot be drawn may spoil all. */
void SceneParts::FitPieces(std::uint32_t whole, std::vector<std::uint32_t>& moved)
{
  const std::shared_ptr<const MapperParts> division = this->Parts[whole].Division;
  const std::size_t count = division && division->IsFinite ? division->Parts.size() : 0;
  std::vector<std::uint32_t> pieces = std::move(this->Parts[whole].Pieces);
  for (; pieces.size() > count; pieces.pop_back())
  {
    this->Spare.push_back(pieces.back());
    this->Parts[pieces.back()] = Part();
    this->Place(pieces.back(), Box(), moved);
  }
  for (; pieces.size() < count && !this->Spare.empty(); this->Spare.pop_back())
  {
    pieces.push_back(this->Spare.back());
  }
  for (; pieces.size() < count; this->BoxOf.emplace_back())
  {
    pieces.push_back(static_cast<std::uint32_t>(this->Parts.size()));
    this->Parts.emplace_back();
  }
  this->Parts[whole].Pieces = std::move(pieces);
}

std::shared_ptr<PartGeometry> SceneParts::GeometryOf(vtkPolyData* data)
{
  std::weak_ptr<PartGeometry>& known = this->Geometries[data];
  std::shared_ptr<PartGeometry> geometry = known.lock();
  if (!geometry || !geometry->IsCurrent(data, this->Frame))
  {
    geometry = std::make_shared<PartGeometry>(data);
    known = geometry;
  }
  return geometry;
}

/** Data that come and go, as those of animations do, would leave more and more entries. */
void SceneParts::DropDeadGeometries()
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

/** Puts the octree right. */
void SceneParts::Replant(const std::vector<std::uint32_t>& moved)
{
  if ((this->Boxes.PutCount() + moved.size()) * FewOf > this->Parts.size())
  {
    this->Boxes = LooseOctree(this->BoxOf);
    return;
  }
  for (const std::uint32_t part : moved)
  {
    this->Boxes.Put(part, this->BoxOf[part]);
  }
}

void SceneParts::MeasureAll()
{
  this->Farthest = glm::dvec3(0.0);
  this->Growth = 0.0f;
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    if (this->BoxOf[i].IsPlaceable())
    {
      this->Farthest = glm::max(this->Farthest,
        glm::max(
          glm::abs(glm::dvec3(this->BoxOf[i].Min)), glm::abs(glm::dvec3(this->BoxOf[i].Max))));
      this->Growth = std::max(this->Growth, this->Parts[i].Growth);
    }
  }
}

void SceneParts::MarkDrawn(std::vector<std::uint8_t>& visible) const
{
  visible.assign(this->Parts.size(), 0);
  for (const std::uint32_t part : this->Drawn)
  {
    visible[part] = 1;
    for (const std::uint32_t piece : this->Parts[part].Pieces)
    {
      visible[piece] = 1;
    }
  }
}

int SceneParts::CountParts(int i) const
{
  const Part& part = this->Parts[this->Drawn[static_cast<std::size_t>(i)]];
  return part.Pieces.empty() ? 1 : static_cast<int>(part.Pieces.size());
}

int SceneParts::CountHidden(int i, const std::vector<std::uint8_t>& visible) const
{
  const std::uint32_t part = this->Drawn[static_cast<std::size_t>(i)];
  const std::vector<std::uint32_t>& pieces = this->Parts[part].Pieces;
  return pieces.empty() ? !visible[part]
                        : static_cast<int>(std::count_if(pieces.begin(), pieces.end(),
                            [&](std::uint32_t piece) { return !visible[piece]; }));
}

std::shared_ptr<const ShownParts> SceneParts::Tell(vtkRenderer* renderer, const ViewMatrices& view,
  int i, const std::vector<std::uint8_t>& visible) const
{
  const Part& part = this->Parts[this->Drawn[static_cast<std::size_t>(i)]];
  if (part.Pieces.empty())
  {
    return nullptr;
  }
  std::vector<std::uint8_t> shown;
  for (const std::uint32_t piece : part.Pieces)
  {
    shown.push_back(visible[piece]);
  }
  auto told = std::make_shared<const ShownParts>(view, part.Actor, part.Division, std::move(shown));
  part.Divided->Tell(renderer, part.Actor, told);
  return told;
}

Occluder SceneParts::OccluderOf(std::uint32_t i)
{
  Part& part = this->Parts[i];
  if (!part.MayHide || IsNonOccluding(part.Actor) || !AreTexturesOpaque(part.Actor))
  {
    return {};
  }
  const glm::dvec3 coarser = part.Sums / this->Farthest;
  const double most = std::max(1.0, std::max(coarser.x, std::max(coarser.y, coarser.z)));
  return { &part.Geometry->Occluder(part.Data), &part.ToWorld, static_cast<float>(most),
    !part.Actor->GetProperty()->GetBackfaceCulling() };
}

void SceneParts::Expect(std::uint32_t i) const
{
  Prefetch(&this->Parts[i]);
  Prefetch(&this->Parts[i].ToWorld);
}

}
