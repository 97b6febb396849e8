#include "Core/culling/walk/BandParts.h"

#include "Core/culling/cover/FewFacetsCoverage.h"
#include "Core/culling/hidden/BoxesHidden.h"
#include "Core/culling/screen/DeviceModel.h"

#include <algorithm>

namespace vitrine
{

namespace
{
// A part with more faces to a cell of the screen is dense: it is worth no more than what can be spared. Where a line has several rows of samples it hides nothing, since most of so
// small faces cover none of them all.
const float MostFacesPerCell = 32.0f;

// Whether a part of more is hidden takes longer to find out than it is worth.
const float MostOfDensePerCell = 4096.0f;

// What may cover such a share of the band's screen is worth all that may be spent.
const float MuchOfScreen = 1.0f / 64.0f;

// To project so many faces takes as long as a piece of one on a line.
const std::size_t FacesPerPiece = 8;
const std::size_t CutFacesPerPiece = 2; // the same, and cut at the near plane

/** Whether a device has no corners so far off the screen that its floats lose the samples beside the borders. */
bool IsClippedSurely(const ScreenRectangle& around, const SampleGrid& samples)
{
  const float inset = samples.Inset();
  const float farthest = inset > 0.0f ? 2.0f * inset * FarthestOff : FarthestOff;
  return around.Left >= -farthest && around.Right <= farthest && around.Bottom >= -farthest &&
    around.Top <= farthest;
}

float FacesPerCell(const ScreenRectangle& rectangle, std::size_t faces)
{
  const float cells = (rectangle.Right - rectangle.Left) * (rectangle.Top - rectangle.Bottom);
  return static_cast<float>(faces) / std::max(cells, 1.0f);
}
}

bool BandParts::Visit(std::uint32_t part, const ScreenRectangle& rectangle)
{
  const bool wasSmall = this->Tools.States.Has(part, PartStates::WasSmall);
  if (!wasSmall && this->IsHidden(rectangle))
  {
    this->Tools.Budget.AddHidden(1);
    return false;
  }
  this->Seen = rectangle;
  if (this->Tools.States.Has(part, PartStates::WasIdle))
  {
    this->Tools.Owners.PrefetchIdler(part);
  }
  const Occluder occluder = this->Occluders.OccluderOf(part);
  const bool isSmall = occluder.Mesh && occluder.Mesh->PointCount() <= FewPointsOfAMesh;
  this->Tools.States.Set(part, PartStates::WasSmall, isSmall);
  const bool isShown = isSmall ? this->ShowSmall(part, occluder, rectangle)
                               : this->ShowLarge(part, occluder, rectangle, wasSmall);
  this->Tools.Budget.AddHidden(!isShown);
  return isShown;
}

bool BandParts::ShowSmall(
  std::uint32_t part, const Occluder& occluder, const ScreenRectangle& rectangle)
{
  const bool isBehindNear = this->Project(occluder);
  const bool isInserted = isBehindNear && this->Tools.States.Has(part, PartStates::HadSamples) &&
    this->IsWorthInserting(occluder, rectangle);
  if (isInserted && this->InsertsSamples(part, occluder))
  {
    return true;
  }
  if (isBehindNear && this->IsHidden(this->View.Grown(this->Tools.Projected.Rectangle())))
  {
    return false;
  }
  return this->ShowFaces(part, occluder, rectangle, isInserted);
}

/** @param isUntested  whether the box around it has not been tested */
bool BandParts::ShowLarge(
  std::uint32_t part, const Occluder& occluder, const ScreenRectangle& rectangle, bool isUntested)
{
  if ((isUntested && this->IsHidden(rectangle)) || this->AreBoxesHidden(occluder))
  {
    return false;
  }
  if (occluder.Mesh && this->IsWorthTesting(occluder, rectangle))
  {
    this->Project(occluder);
    return this->ShowFaces(part, occluder, rectangle, false);
  }
  return true;
}

BandParts::OwnerVerdict BandParts::VisitOwner(
  const LastOwners::Owner& owner, ScreenRectangle& rectangle)
{
  const Occluder occluder = this->Occluders.OccluderOf(owner.Part);
  if (!occluder.Mesh || !occluder.IsOfFacesAlone)
  {
    return OwnerVerdict::Waits;
  }
  const bool isBehindNear = this->Project(occluder);
  const ScreenRectangle around = this->Tools.Projected.Rectangle();
  if (!owner.IsNear(around) || !this->IsWorthInserting(occluder, around))
  {
    return OwnerVerdict::Waits;
  }
  this->Tools.States.Set(owner.Part, PartStates::IsVisited);
  rectangle = isBehindNear ? this->View.Grown(around) : Everywhere;
  this->Seen = rectangle;
  const bool isShown = this->ShowFaces(owner.Part, occluder, around, false);
  this->Tools.Budget.AddHidden(!isShown);
  return isShown ? OwnerVerdict::Shows : OwnerVerdict::Hidden;
}

bool BandParts::IsHiddenNow(std::uint32_t part, const ScreenRectangle& rectangle)
{
  const Occluder occluder = this->Occluders.OccluderOf(part);
  if (this->IsHidden(rectangle) || this->AreBoxesHidden(occluder))
  {
    return true;
  }
  if (!occluder.Mesh || !this->IsWorthTesting(occluder, rectangle))
  {
    return false;
  }
  this->Project(occluder);
  return this->AreFacesHidden(part, occluder);
}

bool BandParts::FindNearest(std::uint32_t part, const ScreenRectangle& rectangle, float& depth)
{
  const Occluder occluder = this->Occluders.OccluderOf(part);
  if (!occluder.Mesh || !this->IsWorthInserting(occluder, rectangle))
  {
    return false;
  }
  this->Project(occluder);
  depth =
    NearestOnScreen(this->Tools.Projected, this->Tools.Lines.Columns(), this->Tools.Lines.Lines());
  return true;
}

/** Of a part that is projected: whether a face of it may show. */
bool BandParts::ShowFaces(
  std::uint32_t part, const Occluder& occluder, const ScreenRectangle& rectangle, bool isInserted)
{
  if (this->IsWorthTesting(occluder, rectangle) && this->AreFacesHidden(part, occluder))
  {
    return false;
  }
  if (!isInserted && this->IsWorthInserting(occluder, rectangle) && !this->WasIdle(part))
  {
    this->Insert(part, occluder);
  }
  return true;
}

/** Puts a part that is projected into the s-buffer. Returns whether it has samples there now: then it shows, and need not be tested. */
bool BandParts::InsertsSamples(std::uint32_t part, const Occluder& occluder)
{
  const std::uint64_t changed = this->Tools.Lines.Counts().Changed;
  this->Insert(part, occluder);
  return this->Tools.Lines.Counts().Changed != changed;
}

/** Of a part that is projected: whether it is where it was when it was inserted in vain. */
bool BandParts::WasIdle(std::uint32_t part)
{
  return this->Tools.States.Has(part, PartStates::WasIdle) &&
    this->Tools.Owners.HadNothing(part, this->Tools.Projected.Rectangle());
}

/** Of a part that is projected; notes it if they are. */
bool BandParts::AreFacesHidden(std::uint32_t part, const Occluder& occluder)
{
  MeshProjection& projected = this->Tools.Projected;
  this->Tools.Budget.Spend(occluder.Mesh->Faces().size() / FacesPerPiece);
  if (!occluder.IsOfFacesAlone || occluder.Mesh->Faces().empty())
  {
    return false;
  }
  if (!this->Faces.AreAll(projected))
  {
    this->Seen = this->Faces.Witness();
    return false;
  }
  const bool areHidden = !projected.MayShowBeforeNear();
  this->Tools.States.Set(part, PartStates::AreFacesHidden, areHidden);
  return areHidden;
}

bool BandParts::AreBoxesHidden(const Occluder& occluder) const
{
  return occluder.Boxes &&
    vitrine::AreBoxesHidden(*occluder.Boxes, this->Tools.Lines, this->View, *occluder.ToWorld);
}

/** Whether back faces of a part that is projected may show. */
bool BandParts::HasBackFaces(const Occluder& occluder) const
{
  const bool isWhole = occluder.Mesh->IsClosed() && this->Tools.Projected.IsBehindNear();
  return occluder.HasBackFaces && !isWhole;
}

/** Returns whether all of it lies behind the near plane; if not it is cut there, which takes long. */
bool BandParts::Project(const Occluder& occluder)
{
  const bool isBehindNear = this->Tools.Projected.Project(
    *occluder.Mesh, this->View.Of(*occluder.ToWorld, *occluder.Drawn));
  if (!isBehindNear)
  {
    this->Tools.Budget.Spend(occluder.Mesh->Faces().size() / CutFacesPerPiece);
  }
  return isBehindNear;
}

/** Whether its faces may be tested. */
bool BandParts::IsWorthTesting(const Occluder& occluder, const ScreenRectangle& rectangle) const
{
  const std::size_t faces = occluder.Mesh->Faces().size();
  const float perCell = FacesPerCell(rectangle, faces);
  return perCell <= MostFacesPerCell
    ? this->Tools.Budget.Allows(faces / FacesPerPiece)
    : perCell <= MostOfDensePerCell && this->Tools.Budget.CanSpare(faces / FacesPerPiece);
}

/** Whether what is in it may cover much of the screen. */
bool BandParts::IsLarge(const ScreenRectangle& rectangle) const
{
  const auto columns = static_cast<float>(this->Tools.Lines.Columns());
  const auto lines = static_cast<float>(this->Tools.Lines.Lines());
  const float across = std::min(rectangle.Right, columns) - std::max(rectangle.Left, 0.0f);
  const float up = std::min(rectangle.Top, lines) - std::max(rectangle.Bottom, 0.0f);
  return across > 0.0f && across * up >= MuchOfScreen * columns * lines;
}

/** Whether they may be inserted. */
bool BandParts::IsWorthInserting(const Occluder& occluder, const ScreenRectangle& rectangle) const
{
  const std::size_t faces = occluder.Mesh->Faces().size();
  const bool isDense = FacesPerCell(rectangle, faces) > MostFacesPerCell;
  return (!isDense || this->Tools.Lines.Samples().HasOneRowPerLine()) &&
    (this->Tools.Budget.AllowsSmall(faces / FacesPerPiece) || this->IsLarge(rectangle)) &&
    this->IsWorthTesting(occluder, rectangle);
}

/** Puts what a part that is projected covers into the s-buffer. */
void BandParts::Insert(std::uint32_t part, const Occluder& occluder)
{
  const std::uint32_t number =
    this->Tools.Owners.AddInserted(part, this->Tools.Projected.Rectangle());
  this->Tools.Budget.Spend(occluder.Mesh->Faces().size() / FacesPerPiece);
  this->InsertSides(number, occluder);
  MeshProjection& projected = this->Tools.Projected;
  if (!projected.IsBehindNear() &&
    projected.ClipFarther(this->View.Of(*occluder.ToWorld, *occluder.Drawn)))
  {
    this->InsertSides(number, occluder);
  }
}

void BandParts::InsertSides(std::uint32_t number, const Occluder& occluder)
{
  if (!IsClippedSurely(this->Tools.Projected.Rectangle(), this->Tools.Lines.Samples()))
  {
    return;
  }
  if (this->HasFewFacets(occluder) && this->InsertFewFacets(number, occluder))
  {
    return;
  }
  this->Tools.Projected.FindFacings();
  this->InsertFaces(number, MeshProjection::Facing::Front);
  if (this->HasBackFaces(occluder))
  {
    this->InsertFaces(number, MeshProjection::Facing::Back);
  }
}

/** Whether all facets of a part that is projected are looked at together. */
bool BandParts::HasFewFacets(const Occluder& occluder) const
{
  return occluder.Mesh->Few() && this->Tools.Projected.IsBehindNear() &&
    this->Tools.Lines.BySample();
}

/** Returns false if they do not tell what is covered. */
bool BandParts::InsertFewFacets(std::uint32_t number, const Occluder& occluder)
{
  const FewFacets& facets = *occluder.Mesh->Few();
  this->Tools.Cuts.Begin(this->Tools.Projected, this->Tools.Lines.Samples());
  for (const MeshProjection::Facing facing :
    { MeshProjection::Facing::Front, MeshProjection::Facing::Back })
  {
    if (facing == MeshProjection::Facing::Back && !this->HasBackFaces(occluder))
    {
      continue;
    }
    const FacetDepths unsteady = this->Tools.Cuts.UnsteadyOf(facets, facing);
    const bool areSteady = std::all_of(unsteady.begin(), unsteady.end(),
      [](float depth) { return depth < FewFacets::MostUnsteady; });
    const std::optional<std::size_t> pieces = areSteady
      ? FewFacetsCoverage::Insert(
          this->Tools.Lines, facets, this->Tools.Projected, facing, number, unsteady)
      : std::nullopt;
    if (!pieces)
    {
      return false;
    }
    this->Tools.Budget.Spend(*pieces);
  }
  return true;
}

void BandParts::InsertFaces(std::uint32_t number, MeshProjection::Facing facing)
{
  MeshProjection& projected = this->Tools.Projected;
  this->Faces.ExcludeHidden(projected, facing);
  this->Tools.Budget.Spend(this->Tools.Cover.Insert(this->Tools.Lines, projected, facing, number));
}

}
