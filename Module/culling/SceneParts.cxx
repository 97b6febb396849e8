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
#include <glm/geometric.hpp>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace vitrine
{

namespace
{

const std::uint32_t LeafSize = 16;

// A tree is built anew where more than one part in so many has moved or come.
const std::size_t FewOf = 16;

// Where parts were absent for more updates than that, all is read anew: they may be gone for good.
const vtkMTimeType LongestAbsence = 1000;

// Geometries that are gone are dropped where there are more than so many to a part.
const std::size_t MostGeometries = 2;

// Of the sums that lead to world coordinates: farther away, their products with a view's matrix may be more than floats hold.
const double FarthestSum = 1e15;

// Boxes are put around the middle of parts that are farther from the origin than so many times their size.
const double FarOff = 1000.0;

// What doubles make of the origin on the way to the screen, as a share of it, over RoundingOfSums.
const double RoundingOfOrigin = 0x1p-48 / RoundingOfSums;

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
  const std::size_t known = this->Parts.size();
  std::vector<Octree::MovedItem> moved;
  bool hasChanged = false;
  this->Drawn.resize(static_cast<std::size_t>(count));
  this->Cursor = 0;
  for (int i = 0; i < count; ++i)
  {
    const std::uint32_t part = this->Find(props[i]);
    this->Drawn[static_cast<std::size_t>(i)] = part;
    this->Parts[part].SeenIn = this->Frame;
    const Box before = this->BoxOf[part];
    if (!this->IsUnchanged(this->Parts[part]))
    {
      this->Look(this->Parts[part]);
      this->BoxOf[part] = this->Parts[part].Actor ? this->Read(this->Parts[part]) : Box();
      hasChanged = true;
      if (part < known && !(before == this->BoxOf[part]))
      {
        moved.push_back({ part, before });
      }
    }
  }
  if (known != this->Parts.size() || hasChanged)
  {
    this->Replant(moved, known);
    glm::dvec3 middle;
    if (this->IsFarOff(middle))
    {
      this->MoveOrigin(middle);
    }
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
    [&](const Part& part) { return part.SeenIn + LongestAbsence < this->Frame; });
  if (isAnyAbsent)
  {
    this->Parts.clear();
    this->BoxOf.clear();
    this->Index.clear();
    this->Geometries.clear();
    this->Boxes = Octree();
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
    part.Geometry->IsCurrent(part.Data, this->Frame);
}

/** Notes what a part is now. */
void SceneParts::Look(Part& part)
{
  part.PropTime = part.Prop->GetMTime();
  part.Shader = ShaderPropertyOf(part.Prop);
  part.ShaderTime = part.Shader ? ShaderTimeOf(part.Shader) : 0;
  part.Actor = AsHideable(part.Prop);
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

/** Returns the part's box: empty if it cannot be hidden. */
Box SceneParts::Read(Part& part)
{
  double elements[16];
  part.Actor->GetMatrix(elements);
  part.ToWorld = MatrixOf(elements);
  part.ToWorld[3] -= glm::dvec4(this->Middle, 0.0);
  part.Growth = GrowthOf(part.Actor, *part.Geometry);
  part.MayHide = IsAffine(part.ToWorld) && part.Geometry->IsFinite() && IsOpaqueSurface(part.Actor);
  const glm::dvec3& least = part.Geometry->Least();
  const glm::dvec3& greatest = part.Geometry->Greatest();
  if (!part.Geometry->IsFinite() || !IsAffine(part.ToWorld) || part.Growth < 0.0f ||
    !(least.x <= greatest.x))
  {
    part.Growth = 0.0f;
    return Box();
  }
  const glm::dvec3 middle(part.ToWorld * glm::dvec4(0.5 * (least + greatest), 1.0));
  const bool isAboutMiddle = IsDrawnAboutMiddle(part.Mapper, *part.Geometry);
  const glm::dvec3 largest =
    isAboutMiddle ? 0.5 * (greatest - least) : glm::max(glm::abs(least), glm::abs(greatest));
  glm::dvec3 half(0.0);
  part.Sums = glm::abs(isAboutMiddle ? middle : glm::dvec3(part.ToWorld[3])) +
    RoundingOfOrigin * glm::abs(this->Middle);
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 direction = glm::abs(glm::dvec3(part.ToWorld[axis]));
    half += direction * (0.5 * (greatest[axis] - least[axis]));
    part.Sums += direction * largest[axis];
  }
  if (!(std::max(part.Sums.x, std::max(part.Sums.y, part.Sums.z)) <= FarthestSum))
  {
    return Box();
  }
  half += RoundingOfSums * part.Sums; // boxes are of doubles, a device's floats reach farther
  return Box::Around(middle - half, middle + half);
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

/** Puts the octree right: parts from `known` on are new. */
void SceneParts::Replant(std::vector<Octree::MovedItem>& moved, std::size_t known)
{
  const BoxArray boxes(this->BoxOf.data(), static_cast<std::uint32_t>(this->BoxOf.size()));
  const std::size_t added = this->Parts.size() - known;
  if ((moved.size() + added) * FewOf > this->Parts.size())
  {
    this->Boxes = Octree(boxes, LeafSize);
    return;
  }
  this->Boxes.Move(moved.data(), moved.size(), boxes);
  for (std::size_t part = known; part < this->Parts.size(); ++part)
  {
    this->Boxes.Insert(static_cast<std::uint32_t>(part), boxes);
  }
}

/** Whether parts are small for how far they are from the origin, as those on maps are. */
bool SceneParts::IsFarOff(glm::dvec3& middle) const
{
  glm::dvec3 least(std::numeric_limits<double>::infinity()), greatest = -least;
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    if (this->BoxOf[i].IsPlaceable() && this->Parts[i].SeenIn == this->Frame)
    {
      least = glm::min(least, glm::dvec3(this->BoxOf[i].Min));
      greatest = glm::max(greatest, glm::dvec3(this->BoxOf[i].Max));
    }
  }
  middle = 0.5 * (least + greatest);
  return glm::length(middle) > FarOff * glm::length(greatest - least);
}

/** Has boxes count from `middle`, which counts from the old origin. */
void SceneParts::MoveOrigin(const glm::dvec3& middle)
{
  this->Middle += middle;
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    Part& part = this->Parts[i];
    const bool isThere = part.SeenIn == this->Frame;
    this->BoxOf[i] = isThere && part.Actor ? this->Read(part) : Box();
    part.PropTime = isThere ? part.PropTime : 0; // others are looked at when they come again
  }
  this->Boxes =
    Octree(BoxArray(this->BoxOf.data(), static_cast<std::uint32_t>(this->BoxOf.size())), LeafSize);
}

void SceneParts::MeasureAll()
{
  this->Farthest = glm::dvec3(0.0);
  this->Growth = 0.0f;
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    if (this->BoxOf[i].IsPlaceable())
    {
      this->Farthest = glm::max(this->Farthest, this->Parts[i].Sums);
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
  }
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

}
