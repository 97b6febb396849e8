#include "section/CutParts.h"

#include "Core/geometry/ClosedMesh.h"
#include "scene/ExactParts.h"
#include "scene/Matrices.h"
#include "scene/PartNumbers.h"
#include "section/CapActor.h"

#include "vtkActor.h"
#include "vtkGlyph3DMapper.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <glm/common.hpp>

#include <algorithm>
#include <tuple>

namespace vitrine
{

namespace
{

/** Parts are read anew if more corners than these are of parts that have changed since, or whose data are gone. */
constexpr std::size_t MostStaleCorners = 1 << 20;

/** Parts are read anew if more than these, and half of all, are no longer drawn. */
constexpr std::size_t MostGoneParts = 1024;

bool IsSamePart(const CutPart& a, const CutPart& b)
{
  return a.Slot == b.Slot && a.Cuts == b.Cuts && a.Masks == b.Masks && a.IsClosed == b.IsClosed;
}

/** Returns true for mappers that draw the points of data that have no cells: as splats, balls and sticks. */
bool DrawsPointsWithoutCells(vtkMapper* mapper)
{
  return mapper->IsA("vtkPointGaussianMapper") || mapper->IsA("vtkOpenGLSphereMapper") ||
    mapper->IsA("vtkOpenGLStickMapper");
}

/** Returns the box in WC of a box in model coordinates. */
std::pair<glm::dvec3, glm::dvec3> BoxInWorld(const glm::dmat4& toWorld, const double bounds[6])
{
  glm::dvec3 min(toWorld[3]);
  glm::dvec3 max = min;
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 a = glm::dvec3(toWorld[axis]) * bounds[2 * axis];
    const glm::dvec3 b = glm::dvec3(toWorld[axis]) * bounds[2 * axis + 1];
    min += glm::min(a, b);
    max += glm::max(a, b);
  }
  return { min, max };
}
}

void CutParts::Update(vtkRenderer* renderer, const SectionPlanes& planes, const MasksOf& masksOf,
  const MayCut& mayCut, const glm::dvec3* center)
{
  const std::vector<CutPart> before = std::move(this->Cut);
  const std::uint64_t generation = this->GenerationNumber;
  this->IsCenterGiven = center != nullptr;
  if (this->HasManyGone || (center && *center != this->Middle) ||
    this->CountStaleCorners() > std::max(MostStaleCorners, this->AllCorners.size() / 2))
  {
    this->Forget();
  }
  this->Middle = center ? *center : this->Middle;
  this->Cut.clear();
  std::size_t drawnParts = 0;
  std::uint32_t nextPlace = 1;
  const StandIns& standIns = StandInsOf(renderer);
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator place;
  props->InitTraversal(place);
  while (vtkProp* const prop = props->GetNextProp(place))
  {
    auto* const actor = vtkActor::SafeDownCast(prop);
    if (!actor || dynamic_cast<CapActor*>(actor))
    {
      continue;
    }
    const std::uint32_t place = nextPlace;
    nextPlace += NumberOfNodes(BlocksOf(actor));
    if (!standIns.IsSeen(actor) || standIns.Shown.count(actor) > 0)
    {
      continue;
    }
    if (!mayCut(actor))
    {
      ++drawnParts;
      continue;
    }
    const std::size_t first = this->Cut.size();
    actor->ComputeMatrix();
    const glm::dmat4 toWorld = MatrixOf(actor->GetMatrix());
    if (vtkGlyph3DMapper::SafeDownCast(actor->GetMapper()))
    {
      ++drawnParts;
      this->Look(actor, {}, toWorld, planes, masksOf);
      continue;
    }
    ForEachDrawn(actor,
      [&](const DrawnData& drawn)
      {
        ++drawnParts;
        this->Look(actor, drawn, toWorld, planes, masksOf);
      });
    for (std::size_t i = first; i < this->Cut.size(); ++i)
    {
      this->Cut[i].Place = place + this->Cut[i].Block;
    }
  }
  this->HasManyGone = this->KnownParts.size() > 2 * drawnParts + MostGoneParts;
  PartNumbers& numbers = PartNumbers::Of(renderer);
  for (CutPart& part : this->Cut)
  {
    part.Number = numbers.FirstOf(part.Prop) + (BlocksOf(part.Prop) ? part.Block : 0u);
  }
  const bool isSame = generation == this->GenerationNumber && before.size() == this->Cut.size() &&
    std::equal(before.begin(), before.end(), this->Cut.begin(), IsSamePart);
  this->ChangeNumber += isSame ? 0 : 1;
}

/** Adds a part if a plane cuts it and none removes it. Points that are not drawn are nothing to cut. */
void CutParts::Look(vtkActor* actor, const DrawnData& drawn, const glm::dmat4& toWorld,
  const SectionPlanes& planes, const MasksOf& masksOf)
{
  if (drawn.Data && drawn.Data->GetNumberOfCells() == 0 &&
    !DrawsPointsWithoutCells(actor->GetMapper()))
  {
    return;
  }
  double bounds[6];
  if (drawn.Data)
  {
    drawn.Data->GetBounds(bounds);
  }
  else
  {
    actor->GetMapper()->GetBounds(bounds);
  }
  const glm::dvec3 min(bounds[0], bounds[2], bounds[4]);
  const glm::dvec3 max(bounds[1], bounds[3], bounds[5]);
  const PlaneMasks masks = masksOf(actor, drawn.Block);
  std::uint32_t cuts = 0;
  for (std::size_t plane = 0; plane < planes.Planes.size(); ++plane)
  {
    const std::uint32_t bit = 1u << plane;
    if ((masks.Both() & bit) == 0)
    {
      continue;
    }
    const DistanceRange range = DistancesOf(planes.Planes[plane].In(toWorld), min, max);
    if ((masks.Any & bit) != 0 && range.Greatest < 0.0)
    {
      return;
    }
    cuts |= range.Least < 0.0 && range.Greatest >= 0.0 ? bit : 0u;
  }
  if (cuts == 0)
  {
    return;
  }
  CutPart part;
  part.Prop = actor;
  part.Block = drawn.Block;
  part.Masks = masks;
  part.Cuts = cuts;
  std::tie(part.Min, part.Max) = BoxInWorld(toWorld, bounds);
  if (drawn.Data && actor->GetProperty()->GetRepresentation() == VTK_SURFACE)
  {
    const Known& known = this->Read(actor, drawn, toWorld);
    part.Slot = known.Slot;
    part.IsClosed = known.IsClosed;
    part.Look = LookOf(actor, drawn);
    part.FirstCorner = known.FirstCorner;
    part.CornerCount = known.CornerCount;
  }
  this->Cut.push_back(part);
}

/** Returns a part whose geometry is read, and up to date. */
const CutParts::Known& CutParts::Read(
  vtkActor* actor, const DrawnData& drawn, const glm::dmat4& toWorld)
{
  Known& known = this->KnownParts[{ actor, drawn.Block }];
  const bool isSameData = known.Data == drawn.Data && known.DataTime == drawn.Data->GetMTime();
  if (isSameData && known.ToWorld == toWorld)
  {
    return known;
  }
  if (this->AllCorners.empty() && !this->IsCenterGiven)
  {
    double bounds[6];
    drawn.Data->GetBounds(bounds);
    this->Middle = glm::dvec3(toWorld *
      glm::dvec4(
        glm::dvec3(bounds[0] + bounds[1], bounds[2] + bounds[3], bounds[4] + bounds[5]) * 0.5,
        1.0));
  }
  const std::vector<glm::dvec3> points = PointsOfPart(drawn.Data);
  const std::vector<std::uint32_t> corners = TrianglesOfPart(drawn.Data);
  this->StaleCorners += known.CornerCount;
  known.IsClosed = isSameData ? known.IsClosed : IsClosed(points, corners);
  known.Data = drawn.Data;
  known.DataTime = drawn.Data->GetMTime();
  known.ToWorld = toWorld;
  known.Slot = this->NextSlot++;
  known.FirstCorner = static_cast<std::uint32_t>(this->AllCorners.size());
  known.CornerCount = static_cast<std::uint32_t>(corners.size());
  const auto first = static_cast<std::uint32_t>(this->AllVertices.size());
  for (const glm::dvec3& point : points)
  {
    const glm::vec3 place(glm::dvec3(toWorld * glm::dvec4(point, 1.0)) - this->Middle);
    this->AllVertices.push_back({ { place.x, place.y, place.z }, known.Slot });
  }
  for (const std::uint32_t corner : corners)
  {
    this->AllCorners.push_back(first + corner);
  }
  return known;
}

bool CutParts::Contains(const CutPart& part, const glm::dvec3& point) const
{
  const glm::dvec3 along = glm::normalize(glm::dvec3(0.5773, 0.3141, 0.7548)); // along no axis
  const auto at = [&](std::size_t corner)
  {
    const float* const place = this->AllVertices[this->AllCorners[corner]].Position;
    return glm::dvec3(place[0], place[1], place[2]) + this->Middle - point;
  };
  bool isInside = false;
  for (std::uint32_t i = 0; i + 2 < part.CornerCount; i += 3)
  {
    const std::size_t first = part.FirstCorner + i;
    const glm::dvec3 a = at(first);
    const glm::dvec3 b = at(first + 1);
    const glm::dvec3 c = at(first + 2);
    const double sides[3] = { glm::dot(along, glm::cross(a, b)), glm::dot(along, glm::cross(b, c)),
      glm::dot(along, glm::cross(c, a)) };
    const bool isCrossed =
      (sides[0] < 0.0) == (sides[1] < 0.0) && (sides[1] < 0.0) == (sides[2] < 0.0);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double slope = glm::dot(along, normal);
    isInside = isInside != (isCrossed && slope != 0.0 && glm::dot(a, normal) / slope > 0.0);
  }
  return isInside;
}

std::size_t CutParts::CountStaleCorners() const
{
  std::size_t count = this->StaleCorners;
  for (const auto& known : this->KnownParts)
  {
    count += known.second.Data ? 0 : known.second.CornerCount;
  }
  return count;
}

void CutParts::Forget()
{
  this->KnownParts.clear();
  this->AllVertices.clear();
  this->AllCorners.clear();
  this->StaleCorners = 0;
  this->HasManyGone = false;
  this->NextSlot = 1;
  ++this->GenerationNumber;
}

}
