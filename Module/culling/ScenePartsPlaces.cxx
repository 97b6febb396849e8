// Places of parts: their boxes, and the octree of these.

#include "culling/SceneParts.h"

#include "Core/culling/screen/DeviceModel.h"
#include "culling/PartRules.h"
#include "culling/PropPolicy.h"
#include "scene/Matrices.h"

#include "vtkActor.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vitrine
{

namespace
{

// The octree is built anew after more than one part in so many has moved, or come.
const std::size_t FewOf = 16;

// Boxes are put around the middle of all parts if it is farther from the origin than this multiple of their size.
const double FarOff = 1000.0;
}

/** Notes where the actor is, and whether any of it may hide others. */
void SceneParts::ReadActor(Part& part)
{
  double elements[16];
  part.Actor->GetMatrix(elements);
  part.ToWorld = MatrixOf(elements);
  part.ToWorld[3] -= glm::dvec4(this->Middle, 0.0);
  part.FromWorld = glm::inverse(part.ToWorld);
  part.HasTextures =
    part.Actor->GetTexture() || part.Actor->GetProperty()->GetNumberOfTextures() > 0;
  const PropFacts facts = FactsOf(part);
  part.HidesNothingBy = FindPropRow(PropStage::Opacity, facts);
  part.IsOpaque = !part.HidesNothingBy;
  if (part.IsOpaque)
  {
    part.HidesNothingBy = FindPropRow(PropStage::Surface, facts);
  }
  part.MayHide = !part.HidesNothingBy && IsAffine(part.ToWorld);
  part.HasBackFaces = !part.Actor->GetProperty()->GetBackfaceCulling();
  part.IsWireframe = vitrine::IsWireframe(part.Actor);
}

/** Returns the coordinates that a device has of a part. The part must be a prop. */
DeviceCoordinates SceneParts::CoordinatesOf(const Part& part)
{
  const glm::dvec3& least = part.Geometry->Least();
  const glm::dvec3& greatest = part.Geometry->Greatest();
  if (IsDrawnAboutMiddle(part.Mapper, *part.Geometry))
  {
    return { 0.5 * (least + greatest), 0.5 * (greatest - least) };
  }
  return { glm::dvec3(0.0), glm::max(glm::abs(least), glm::abs(greatest)) };
}

/**
 * Returns the box of a part, in world coordinates (WC) relative to Origin(). It is empty if the part cannot be hidden.
 */
Box SceneParts::Read(Part& part, const DeviceCoordinates& drawn) const
{
  part.Growth =
    part.IsOfViewAlone ? MostGrowthOf(part.Actor) : GrowthOf(part.Actor, *part.Geometry);
  part.MayHide = part.MayHide && part.Geometry->IsFinite();
  const glm::dvec3& least = part.Geometry->Least();
  const glm::dvec3& greatest = part.Geometry->Greatest();
  part.AlwaysDrawnBy = FindPropRow(PropStage::Place, FactsOf(part));
  if (part.AlwaysDrawnBy)
  {
    part.Growth = 0.0f;
    return Box();
  }
  const glm::dvec3 middle(part.ToWorld * glm::dvec4(0.5 * (least + greatest), 1.0));
  glm::dvec3 half(0.0);
  part.Sums = glm::abs(glm::dvec3(part.ToWorld * glm::dvec4(drawn.Origin, 1.0)));
  part.Drawn = drawn;
  part.Drawn.InWorld = glm::abs(glm::dvec3(part.ToWorld[3])) + glm::abs(this->Middle);
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 direction = glm::abs(glm::dvec3(part.ToWorld[axis]));
    half += direction * (0.5 * (greatest[axis] - least[axis]));
    part.Sums += direction * drawn.Farthest[axis];
    part.Drawn.InWorld += direction * (std::abs(drawn.Origin[axis]) + drawn.Farthest[axis]);
  }
  part.Sums += RoundingOfDoubles * part.Drawn.InWorld;
  part.AlwaysDrawnBy = FindPropRow(PropStage::Distance, FactsOf(part));
  if (part.AlwaysDrawnBy)
  {
    return Box();
  }
  // Boxes are found in doubles, and the floats of a device reach farther.
  half += RoundingOfSums * part.Sums;
  return Box::Around(middle - half, middle + half);
}

/** Sets the box of a part. Adds the part to `moved` if that is a change. */
void SceneParts::Place(std::uint32_t part, const Box& box, std::vector<std::uint32_t>& moved)
{
  const bool isOfViewAlone = this->Parts[part].IsOfViewAlone;
  const Box hideable = isOfViewAlone ? Box() : box;
  this->Parts[part].InView = isOfViewAlone ? box : Box();
  if (!(this->BoxOf[part] == hideable))
  {
    this->BoxOf[part] = hideable;
    moved.push_back(part);
  }
}

/** Places a prop that was looked at, as one part or as the parts that it is divided into. */
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
    part.AlwaysDrawnBy =
      part.Actor ? FindPropRow(PropStage::Division, FactsOf(part)) : part.AlwaysDrawnBy;
    this->Place(whole, Box(), moved);
  }
  else
  {
    this->Place(whole, this->Read(part, CoordinatesOf(part)), moved);
  }
  for (std::size_t i = 0; i < part.Pieces.size(); ++i)
  {
    const MapperPart& divided = part.Division->Parts[i];
    Part& piece = this->Parts[part.Pieces[i]];
    piece.Actor = part.Actor;
    piece.ToWorld = part.ToWorld;
    piece.FromWorld = part.FromWorld;
    piece.HasTextures = part.HasTextures;
    piece.HasBackFaces = part.HasBackFaces;
    piece.IsWireframe = part.IsWireframe;
    piece.IsOfViewAlone = part.IsOfViewAlone;
    piece.Data = divided.Data;
    piece.Geometry = divided.Geometry;
    PropFacts facts;
    facts.Piece = &divided;
    const PropRow* const ofPiece = FindPropRow(PropStage::Part, facts);
    piece.IsOpaque = part.IsOpaque && !ofPiece;
    piece.MayHide = part.MayHide;
    piece.HidesNothingBy = part.HidesNothingBy ? part.HidesNothingBy : ofPiece;
    this->Place(
      part.Pieces[i], this->Read(piece, { glm::dvec3(0.0), part.Division->Farthest }), moved);
  }
}

/**
 * Gives a prop as many pieces as it is divided into. Gives none if a block that is not finite may spoil all of them.
 */
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
  while (pieces.size() < count)
  {
    pieces.push_back(this->AddPart(nullptr));
  }
  this->Parts[whole].Pieces = std::move(pieces);
  this->HasPieces[whole] = !this->Parts[whole].Pieces.empty();
}

/** Updates the octree. */
void SceneParts::Replant(const std::vector<std::uint32_t>& moved)
{
  if ((this->Boxes.ChangeCount() + moved.size()) * FewOf > this->Parts.size())
  {
    this->Boxes = LooseOctree(this->BoxOf);
    return;
  }
  for (const std::uint32_t part : moved)
  {
    this->Boxes.SetBox(part, this->BoxOf[part]);
  }
}

/** Returns the box of a part. It is empty if the part may be anywhere. */
const Box& SceneParts::BoxInWorld(std::size_t part) const
{
  return this->Parts[part].IsOfViewAlone ? this->Parts[part].InView : this->BoxOf[part];
}

/** Returns true if parts are small for their distance from the origin, as on maps. Sets `middle` to their middle. */
bool SceneParts::IsFarOff(glm::dvec3& middle) const
{
  glm::dvec3 least(std::numeric_limits<double>::infinity()), greatest = -least;
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    const Box& box = this->BoxInWorld(i);
    if (box.IsPlaceable() && (this->SeenIn[i] == this->Frame || !this->PropOf[i]))
    {
      least = glm::min(least, glm::dvec3(box.Min));
      greatest = glm::max(greatest, glm::dvec3(box.Max));
    }
  }
  middle = 0.5 * (least + greatest);
  return glm::length(middle) > FarOff * glm::length(greatest - least);
}

/**
 * Moves the origin of all boxes to `middle`, which is relative to the old origin. Parts that are not in this frame are
 * looked at when they come again.
 */
void SceneParts::MoveOrigin(const glm::dvec3& middle)
{
  this->Middle += middle;
  std::vector<std::uint32_t> moved;
  for (std::uint32_t whole = 0; whole < this->Parts.size(); ++whole)
  {
    if (this->SeenIn[whole] == this->Frame)
    {
      this->PlaceWhole(whole, moved);
    }
    else if (this->PropOf[whole])
    {
      this->Parts[whole].PropTime = 0;
      this->Place(whole, Box(), moved);
      for (const std::uint32_t piece : this->Parts[whole].Pieces)
      {
        this->Place(piece, Box(), moved);
      }
    }
  }
  this->Boxes = LooseOctree(this->BoxOf);
}

void SceneParts::MeasureAll()
{
  this->ExtremesOfHideable = this->ExtremesOfViewAlone = Extremes();
  this->ViewAlone.clear();
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    const Part& part = this->Parts[i];
    if (!this->BoxInWorld(i).IsPlaceable())
    {
      continue;
    }
    Extremes& all = part.IsOfViewAlone ? this->ExtremesOfViewAlone : this->ExtremesOfHideable;
    all.Reach = glm::max(all.Reach, part.Sums);
    all.Growth = std::max(all.Growth, part.Growth);
    if (part.IsOfViewAlone)
    {
      this->ViewAlone.push_back({ static_cast<std::uint32_t>(i), part.InView });
    }
  }
}

}
