#include "Core/culling/steady/FaceBlock.h"

#include "Core/culling/steady/FaceCorners.h"
#include "Core/culling/steady/FaceSlopes.h"
#include "Core/geometry/BeyondAll.h"

namespace vitrine
{

namespace
{

/** Stores `values` where the mask is set, and `other` elsewhere. */
VITRINE_INLINE void StoreWhere(LaneMask mask, Lanes values, float other, float* place)
{
  StoreLanes(Chosen(mask, values, AllLanes(other)), place);
}
}

FaceBlock::FaceBlock(
  const MeshProjection& projection, const std::vector<std::uint32_t>& faces, std::size_t first)
  : Count(FindFaces(projection, faces, first, this->Faces))
{
  this->Find(projection);
}

/** Finds the rectangles of eight faces. */
VITRINE_FOR_EACH_PROCESSOR
void FaceBlock::Find(const MeshProjection& projection)
{
  const FaceCorners a(projection, this->Faces, 0), b(projection, this->Faces, 1),
    c(projection, this->Faces, 2);
  const ScreenRounding& rounding = projection.Rounding();
  const ScreenMargin& snapping = projection.Snapping();
  const FaceSlopes<Lanes> slopes(
    { { a.Column, b.Column, c.Column }, { a.Line, b.Line, c.Line }, { a.Depth, b.Depth, c.Depth },
      { a.InverseW, b.InverseW, c.InverseW } },
    rounding, snapping);
  const auto margin = rounding.MarginAt(GreatestOf(a.InverseW, b.InverseW, c.InverseW), snapping);
  const Lanes nearest = GreatestOf(a.Depth, b.Depth, c.Depth) + margin.Depth + slopes.Beyond;
  const Lanes sum = a.Column + b.Column + c.Column + a.Line + b.Line + c.Line + nearest;
  const LaneMask isFinite = sum - sum == AllLanes(0.0f);
  StoreWhere(
    isFinite, LeastOf(a.Column, b.Column, c.Column) - margin.Column, -BeyondAll, this->Left);
  StoreWhere(
    isFinite, GreatestOf(a.Column, b.Column, c.Column) + margin.Column, BeyondAll, this->Right);
  StoreWhere(isFinite, LeastOf(a.Line, b.Line, c.Line) - margin.Line, -BeyondAll, this->Bottom);
  StoreWhere(isFinite, GreatestOf(a.Line, b.Line, c.Line) + margin.Line, BeyondAll, this->Top);
  StoreWhere(isFinite, nearest, BeyondAll, this->Nearest);
}

VITRINE_FOR_EACH_PROCESSOR
unsigned FaceBlock::MayHaveAny(const SampleGrid& samples, const glm::vec2& growth) const
{
  return this->All() &
    samples.MayHaveAny(LoadLanes(this->Left) - growth.x, LoadLanes(this->Right) + growth.x) &
    samples.MayHaveAny(LoadLanes(this->Bottom) - growth.y, LoadLanes(this->Top) + growth.y);
}

VITRINE_FOR_EACH_PROCESSOR
ScreenRectangle FaceBlock::RectangleAround(unsigned faces) const
{
  const LaneMask bits = LaneMask{} + static_cast<std::int32_t>(faces);
  const LaneMask isWanted = (bits & LaneMask{ 1, 2, 4, 8, 16, 32, 64, 128 }) != LaneMask{};
  const Lanes before = AllLanes(-BeyondAll), behind = AllLanes(BeyondAll);
  return { LeastLane(Chosen(isWanted, LoadLanes(this->Left), behind)),
    GreatestLane(Chosen(isWanted, LoadLanes(this->Right), before)),
    LeastLane(Chosen(isWanted, LoadLanes(this->Bottom), behind)),
    GreatestLane(Chosen(isWanted, LoadLanes(this->Top), before)),
    GreatestLane(Chosen(isWanted, LoadLanes(this->Nearest), before)) };
}

}
