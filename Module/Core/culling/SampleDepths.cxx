#include "Core/culling/SampleDepths.h"

#include "Core/culling/SBuffer.h"

#include <cassert>

namespace vitrine
{

namespace
{
const unsigned AllBits = (1u << LaneCount) - 1u;
}

SampleDepths::SampleDepths(int columns, int lines, const SampleGrid& grid)
  : CountPerColumn(grid.BinaryPixelsPerColumn())
  , PerColumn(static_cast<float>(CountPerColumn))
  , Width(1.0f / PerColumn)
  , CountPerTile(CountPerColumn * TileDepths::Width)
  , CountPerLine(CountPerColumn * columns)
  , ColumnCount(static_cast<float>(columns))
  , LineCount(static_cast<float>(lines))
  , Stride(CountPerLine + CountPerTile + LaneCount)
  , Depths(static_cast<std::size_t>(Stride) * static_cast<std::size_t>(lines))
  , Faces(Depths.size())
{
  assert(Suit(grid));
  for (int i = 0; i < this->Stride; ++i)
  {
    this->Places.push_back(grid.Place(static_cast<float>(i)));
  }
  this->Clear();
}

void SampleDepths::Clear()
{
  for (auto line = this->Depths.begin(); line != this->Depths.end(); line += this->Stride)
  {
    std::fill(line, line + this->CountPerLine, NotCovered);
    std::fill(line + this->CountPerLine, line + this->Stride, BehindColumns);
  }
}

/** Of up to eight samples on each line. */
VITRINE_INLINE bool SampleDepths::RowsHide(
  const Range& lines, const Range& range, float nearest) const
{
  const LaneMask isAsked = AreFirst(range.Last + 1 - range.First);
  const float* depths = &this->Depths[this->At(lines.First)] + range.First;
  for (int line = lines.First; line <= lines.Last; ++line, depths += this->Stride)
  {
    if (BitsOf(isAsked & ~(LoadLanes(depths) > AllLanes(nearest))) != 0)
    {
      return false;
    }
  }
  return true;
}

/** By the least depths of tiles, those first of which all is asked. */
VITRINE_INLINE bool SampleDepths::TilesHide(
  const TileDepths& tiles, const Range& lines, const Range& range, float nearest) const
{
  const int firstTile = this->TileOf(range.First), lastTile = this->TileOf(range.Last);
  const int firstWhole = firstTile + (range.First > firstTile * this->CountPerTile ? 1 : 0);
  const int endOfWhole = lastTile + (range.Last + 1 < (lastTile + 1) * this->CountPerTile ? 0 : 1);
  for (int line = lines.First; line <= lines.Last; line += LaneCount)
  {
    for (int tile = firstWhole; tile < endOfWhole; ++tile)
    {
      if (tiles.Open(line, lines.Last, tile, nearest) != 0)
      {
        return false;
      }
    }
  }
  const int endOfFirst = std::min(firstWhole * this->CountPerTile, range.Last + 1);
  const int startOfLast = std::max(endOfWhole * this->CountPerTile, endOfFirst);
  for (const Range& part :
    { Range{ range.First, endOfFirst - 1 }, Range{ startOfLast, range.Last } })
  {
    for (int first = part.First; first <= part.Last; first += LaneCount)
    {
      const Range few{ first, std::min(first + LaneCount - 1, part.Last) };
      if (!this->RowsHide(lines, few, nearest))
      {
        return false;
      }
    }
  }
  return true;
}

VITRINE_FOR_EACH_PROCESSOR
bool SampleDepths::Hide(const TileDepths& tiles, const ScreenRectangle& rectangle) const
{
  const float left = std::max(rectangle.Left, 0.0f);
  const float right = std::min(rectangle.Right, this->ColumnCount);
  const float bottom = std::max(rectangle.Bottom, 0.0f);
  const float top = std::min(rectangle.Top, this->LineCount);
  if (!(left <= right && bottom <= top))
  {
    return left > right || bottom > top; // what is no number may be anywhere
  }
  const Range samples = this->Between(left, right);
  const Range rows = this->Between(bottom, top);
  if (samples.First > samples.Last || rows.First > rows.Last)
  {
    return true;
  }
  const Range lines{ this->LineOf(rows.First), this->LineOf(rows.Last) };
  return samples.Last - samples.First < LaneCount
    ? this->RowsHide(lines, samples, rectangle.Nearest)
    : this->TilesHide(tiles, lines, samples, rectangle.Nearest);
}

VITRINE_FOR_EACH_PROCESSOR
bool SampleDepths::Hide(
  int line, float left, float right, const HideableSegment& segment, float& shown) const
{
  const Range range = this->Between(left, right);
  const float* const depths = &this->Depths[this->At(line)];
  for (int i = range.First; i <= range.Last; i += LaneCount)
  {
    const Lanes place = LoadLanes(&this->Places[static_cast<std::size_t>(i)]);
    const Lanes depth = LoadLanes(depths + i);
    const Lanes own = segment.Depth + segment.Slope * (place - segment.Column);
    const LaneMask isHidden = (depth > own) | (depth > AllLanes(segment.Nearest));
    if (const unsigned open = BitsOf(AreFirst(range.Last + 1 - i) & ~isHidden))
    {
      shown = this->Places[static_cast<std::size_t>(i + LowestBit(open))];
      return false;
    }
  }
  return true;
}

float SampleDepths::DepthOfColumn(int line, int column) const
{
  const float* const first = &this->Depths[this->At(line)] + column * this->CountPerColumn;
  return *std::min_element(first, first + this->CountPerColumn);
}

VITRINE_FOR_EACH_PROCESSOR
void SampleDepths::AddColumnsOfFaces(std::vector<float>& columns) const
{
  const auto stride = static_cast<std::size_t>(this->Stride);
  for (std::size_t line = 0; line < this->Depths.size(); line += stride)
  {
    for (int i = 0; i < this->CountPerLine; i += LaneCount)
    {
      const std::size_t first = line + static_cast<std::size_t>(i);
      const std::uint32_t* const faces = &this->Faces[first];
      const LaneMask isSame = LoadMask(faces) == LaneMask{} + static_cast<std::int32_t>(faces[0]);
      const unsigned covered = BitsOf(AreFirst(this->CountPerLine - i) &
        (LoadLanes(&this->Depths[first]) > AllLanes(NotCovered)));
      if ((covered & BitsOf(isSame)) == AllBits) // or each would wait for the one before
      {
        columns[faces[0]] += LaneCount * this->Width;
        continue;
      }
      for (unsigned bits = covered; bits != 0; bits &= bits - 1)
      {
        columns[faces[LowestBit(bits)]] += this->Width;
      }
    }
  }
}

}
