#include "Core/culling/walk/BandParts.h"

#include "Core/culling/cover/FewFacetsCoverage.h"
#include "Core/culling/hidden/BoxesHidden.h"
#include "Core/culling/screen/DeviceModel.h"

#include <algorithm>

namespace vitrine
{

namespace
{
// A part with more faces than this per cell of the screen is dense. It is tested only if the budget can spare it. With
// several rows of samples per line it is not inserted: most of its small faces cover no row completely.
const float MostFacesPerCell = 32.0f;

// A part with more faces per cell is never tested: the test takes longer than it is worth.
const float MostOfDensePerCell = 4096.0f;

// A part that may cover this share of the screen of the band may use the whole budget.
const float MuchOfScreen = 1.0f / 64.0f;

// The projection of so many faces takes as long as one piece of a face on a line.
const std::size_t FacesPerPiece = 8;
const std::size_t CutFacesPerPiece = 2; // if the faces are clipped at the near plane, too

/**
 * Returns true if no corner lies far off the screen. There the floats of a device would lose the samples next to the
 * borders.
 */
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

/** @param isUntested  true if the box of the part was not tested */
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

/**
 * Returns true if a face of the projected part may show. Inserts the part then, unless it is inserted already or the
 * budget forbids it.
 */
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

/**
 * Inserts the projected part. Returns true if it owns samples of the s-buffer now. Then it shows, and need not be
 * tested.
 */
bool BandParts::InsertsSamples(std::uint32_t part, const Occluder& occluder)
{
  const std::uint64_t changed = this->Tools.Lines.Counts().Changed;
  this->Insert(part, occluder);
  return this->Tools.Lines.Counts().Changed != changed;
}

/** Returns true if the projected part was inserted in vain before, and has not moved since. */
bool BandParts::WasIdle(std::uint32_t part)
{
  return this->Tools.States.Has(part, PartStates::WasIdle) &&
    this->Tools.Owners.HadNothing(part, this->Tools.Projected.Rectangle());
}

/** Returns true if all faces of the projected part are hidden. Sets PartStates::AreFacesHidden. */
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

/** Returns true if back faces of the projected part may show. */
bool BandParts::HasBackFaces(const Occluder& occluder) const
{
  const bool isWhole = occluder.Mesh->IsClosed() && this->Tools.Projected.IsBehindNear();
  return occluder.HasBackFaces && !isWhole;
}

/**
 * Projects a part. Returns false if it is not all behind the near plane. Then it is clipped there, which costs more.
 */
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

/** Returns true if the budget allows to test the faces. */
bool BandParts::IsWorthTesting(const Occluder& occluder, const ScreenRectangle& rectangle) const
{
  const std::size_t faces = occluder.Mesh->Faces().size();
  const float perCell = FacesPerCell(rectangle, faces);
  return perCell <= MostFacesPerCell
    ? this->Tools.Budget.Allows(faces / FacesPerPiece)
    : perCell <= MostOfDensePerCell && this->Tools.Budget.CanSpare(faces / FacesPerPiece);
}

/** Returns true if a part with this rectangle may cover much of the screen. */
bool BandParts::IsLarge(const ScreenRectangle& rectangle) const
{
  const auto columns = static_cast<float>(this->Tools.Lines.Columns());
  const auto lines = static_cast<float>(this->Tools.Lines.Lines());
  const float across = std::min(rectangle.Right, columns) - std::max(rectangle.Left, 0.0f);
  const float up = std::min(rectangle.Top, lines) - std::max(rectangle.Bottom, 0.0f);
  return across > 0.0f && across * up >= MuchOfScreen * columns * lines;
}

/** Returns true if the budget allows to insert the faces. */
bool BandParts::IsWorthInserting(const Occluder& occluder, const ScreenRectangle& rectangle) const
{
  const std::size_t faces = occluder.Mesh->Faces().size();
  const bool isDense = FacesPerCell(rectangle, faces) > MostFacesPerCell;
  return (!isDense || this->Tools.Lines.Samples().HasOneRowPerLine()) &&
    (this->Tools.Budget.AllowsSmall(faces / FacesPerPiece) || this->IsLarge(rectangle)) &&
    this->IsWorthTesting(occluder, rectangle);
}

/**
 * Inserts what the projected part covers into the s-buffer. A part that reaches before the near plane is inserted
 * twice: clipped there, and clipped farther behind, where margins are narrower.
 */
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

/** Returns true if the facets of the projected part can be inserted all at once. */
bool BandParts::HasFewFacets(const Occluder& occluder) const
{
  return occluder.Mesh->Few() && this->Tools.Projected.IsBehindNear() &&
    this->Tools.Lines.BySample();
}

/** Inserts all facets at once. Returns false if they do not tell what is covered. */
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
