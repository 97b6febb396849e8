#include "culling/SceneParts.h"

#include "culling/ActorRules.h"
#include "culling/Matrices.h"

#include "vtkActor.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTrivialProducer.h"

#include <glm/common.hpp>

#include <algorithm>

namespace vitrine
{

namespace
{

const std::uint32_t LeafSize = 16;

// A tree is built anew where more than one part in so many has moved or come.
const std::size_t FewOf = 16;

// Of what floats make of the sums that lead to world coordinates; boxes are grown by it.
const double RoundingOfSums = 0x1p-20;

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
  const std::size_t known = this->Parts.size();
  std::vector<Octree::MovedItem> moved;
  bool hasChanged = false;
  this->Drawn.resize(static_cast<std::size_t>(count));
  this->Cursor = 0;
  for (int i = 0; i < count; ++i)
  {
    const std::uint32_t part = this->Find(props[i]);
    this->Drawn[static_cast<std::size_t>(i)] = part;
    const Box before = this->BoxOf[part];
    if (this->Refresh(this->Parts[part], this->BoxOf[part]))
    {
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
    this->MeasureAll();
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

/** Looks whether a part is as it was; if not, reads it anew and returns true. */
bool SceneParts::Refresh(Part& part, Box& box)
{
  part.Actor = AsHideable(part.Prop);
  if (!part.Actor)
  {
    const bool wasHideable = !box.IsEmpty();
    box = Box();
    part.Geometry.reset();
    return wasHideable;
  }
  auto* mapper = static_cast<vtkPolyDataMapper*>(part.Actor->GetMapper());
  if (!mapper->GetStatic() && !vtkTrivialProducer::SafeDownCast(mapper->GetInputAlgorithm()))
  {
    mapper->Update();
  }
  vtkPolyData* data = mapper->GetInput();
  const vtkMTimeType time = ModificationTime(part.Actor);
  if (part.Geometry && part.Time == time && part.Mapper == mapper && data &&
    part.Geometry->IsCurrent(data))
  {
    return false;
  }
  part.Time = time;
  part.Mapper = mapper;
  part.Data = data;
  if (!data)
  {
    part.Geometry.reset();
    box = Box();
    return true;
  }
  box = this->Read(part);
  return true;
}

/** Returns the part's box: empty if it cannot be hidden. */
Box SceneParts::Read(Part& part)
{
  part.Geometry = this->GeometryOf(part.Data);
  double elements[16];
  part.Actor->GetMatrix(elements);
  part.ToWorld = MatrixOf(elements);
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
  const glm::dvec3 largest = glm::max(glm::abs(least), glm::abs(greatest));
  glm::dvec3 half(0.0);
  part.Sums = glm::abs(glm::dvec3(part.ToWorld[3]));
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
  half += RoundingOfSums * part.Sums;
  return Box::Around(middle - half, middle + half);
}

std::shared_ptr<PartGeometry> SceneParts::GeometryOf(vtkPolyData* data)
{
  std::weak_ptr<PartGeometry>& known = this->Geometries[data];
  std::shared_ptr<PartGeometry> geometry = known.lock();
  if (!geometry || !geometry->IsCurrent(data))
  {
    geometry = std::make_shared<PartGeometry>(data);
    known = geometry;
  }
  return geometry;
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
  }
}

Occluder SceneParts::OccluderOf(std::uint32_t i)
{
  Part& part = this->Parts[i];
  if (!part.MayHide || !AreTexturesOpaque(part.Actor))
  {
    return {};
  }
  const glm::dvec3 coarser = part.Sums / this->Farthest;
  const double most = std::max(1.0, std::max(coarser.x, std::max(coarser.y, coarser.z)));
  return { &part.Geometry->Occluder(part.Data), &part.ToWorld, static_cast<float>(most),
    !part.Actor->GetProperty()->GetBackfaceCulling() };
}

}
