#include "Core/culling/buffer/SampleDepths.h"

#include "Core/culling/buffer/SBuffer.h"

#include <cassert>

namespace vitrine
{

namespace
{
const unsigned AllBits = (1u << LaneCount) - 1u;
}

SampleDepths::SampleDepths(int columns, int lines, const SampleGrid& grid)
  : CountPerColumn(grid.BinaryPixelsPerColumn())
  , BitsPerColumn(CountPerColumn / 2)
  , PerColumn(static_cast<float>(CountPerColumn))
  , Width(1.0f / PerColumn)
  , CountPerTile(CountPerColumn * TileDepths::Width)
  , CountPerLine(CountPerColumn * columns)
  , ColumnCount(static_cast<float>(columns))
  , LineCount(static_cast<float>(lines))
  , Stride(lines + LaneCount)
{
  assert(Suit(grid));
  const int tiles = (columns + TileDepths::Width - 1) / TileDepths::Width;
  for (int i = 0; i < tiles * this->CountPerTile; ++i)
  {
    this->Places.push_back(grid.Place(static_cast<float>(i)));
  }
  this->Depths.resize(this->At(tiles * this->CountPerTile, 0), BeyondAll);
  this->Faces.resize(this->Depths.size());
  for (int tile = 0; tile < tiles; ++tile)
  {
    this->Clear(tile);
  }
}

void SampleDepths::Clear(int tile)
{
  for (int i = tile * this->CountPerTile; i < this->EndOf(tile); ++i)
  {
    const auto first = this->Depths.begin() + static_cast<std::ptrdiff_t>(this->At(i, 0));
    std::fill(first, first + (this->Stride - LaneCount), NotCovered);
  }
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
    return left > right || bottom > top; // NaN may be anywhere.
  }
  const Range samples = this->Between(left, right), rows = this->Between(bottom, top);
  if (samples.First > samples.Last || rows.First > rows.Last)
  {
    return true;
  }
  const Range lines{ this->LineOf(rows.First), this->LineOf(rows.Last) };
  if (samples.Last - samples.First < LaneCount)
  {
    return this->ColumnsHide(lines, samples.First, samples.Last + 1, rectangle.Nearest);
  }
  const int firstTile = this->TileOf(samples.First), lastTile = this->TileOf(samples.Last);
  const int firstWhole = firstTile + (samples.First > firstTile * this->CountPerTile ? 1 : 0);
  const int endOfWhole =
    lastTile + (samples.Last + 1 < (lastTile + 1) * this->CountPerTile ? 0 : 1);
  // The least depth of a tile decides for a whole tile, so whole tiles are tested first.
  for (int tile = firstWhole; tile < endOfWhole; ++tile)
  {
    for (int line = lines.First; line <= lines.Last; line += LaneCount)
    {
      if (tiles.Open(line, lines.Last, tile, rectangle.Nearest) != 0)
      {
        return false;
      }
    }
  }
  const int endOfFirst = std::min(firstWhole * this->CountPerTile, samples.Last + 1);
  const int startOfLast = std::max(endOfWhole * this->CountPerTile, endOfFirst);
  return this->ColumnsHide(lines, samples.First, endOfFirst, rectangle.Nearest) &&
    this->ColumnsHide(lines, startOfLast, samples.Last + 1, rectangle.Nearest);
}

/** Returns true if samples `first` to `end` - 1 of all `lines` are covered nearer than `nearest`. */
VITRINE_INLINE bool SampleDepths::ColumnsHide(
  const Range& lines, int first, int end, float nearest) const
{
  for (int line = lines.First; line <= lines.Last; line += LaneCount)
  {
    const float* depths = &this->Depths[this->At(first, line)];
    Lanes least = AllLanes(BeyondAll);
    for (int i = first; i < end; ++i, depths += this->Stride)
    {
      least = LeastOf(LoadLanes(depths), least);
    }
    const unsigned open = ~BitsOf(least > AllLanes(nearest));
    if ((open & TileDepths::LowBits(lines.Last + 1 - line)) != 0)
    {
      return false;
    }
  }
  return true;
}

bool SampleDepths::Hide(
  int line, float left, float right, const HideableSegment& segment, float& shown) const
{
  const Range range = this->Between(left, right);
  for (int i = range.First; i <= range.Last; ++i)
  {
    const float place = this->Places[static_cast<std::size_t>(i)];
    const float depth = this->Depths[this->At(i, line)];
    if (!(depth > segment.DepthAt(place) || depth > segment.Nearest))
    {
      shown = place;
      return false;
    }
  }
  return true;
}

VITRINE_FOR_EACH_PROCESSOR
unsigned SampleDepths::FindOpen(int line, const float* left, const float* right,
  const HideableSegmentLanes& segments, float& shown) const
{
  const Lanes lefts = LoadLanes(left), rights = LoadLanes(right);
  const LaneMask isAsked = lefts <= rights;
  const float first = LeastLane(Chosen(isAsked, lefts, AllLanes(this->ColumnCount)));
  const float last = GreatestLane(Chosen(isAsked, rights, AllLanes(0.0f)));
  const Range range = this->Between(std::min(std::max(first, 0.0f), this->ColumnCount),
    std::min(std::max(last, 0.0f), this->ColumnCount));
  const Lanes nearest = AllLanes(segments.Nearest), start = LoadLanes(segments.Depths);
  for (int i = range.First; i <= range.Last; ++i)
  {
    const float place = this->Places[static_cast<std::size_t>(i)];
    const Lanes depth = LoadLanes(&this->Depths[this->At(i, line)]);
    const Lanes own = start + segments.Slope * (place - segments.Column);
    const LaneMask isOpen =
      (lefts <= place) & (rights >= place) & ~((depth > own) | (depth > nearest));
    if (const unsigned open = BitsOf(isOpen))
    {
      shown = place;
      return open;
    }
  }
  return 0;
}

float SampleDepths::DepthOfColumn(int line, int column) const
{
  float least = BeyondAll;
  for (int i = column * this->CountPerColumn; i < (column + 1) * this->CountPerColumn; ++i)
  {
    least = std::min(least, this->Depths[this->At(i, line)]);
  }
  return least;
}

VITRINE_FOR_EACH_PROCESSOR
void SampleDepths::AddColumnsOfFaces(const TileDepths& tiles, std::vector<float>& columns) const
{
  for (int tile = 0; tile < tiles.CountPerLine(); ++tile)
  {
    const int end = tiles.IsTouched(tile) ? this->EndOf(tile) : 0;
    for (int i = tile * this->CountPerTile; i < end; ++i)
    {
      this->AddColumnsOfFaces(i, columns);
    }
  }
}

/** Adds the columns of one sample of all lines. */
VITRINE_INLINE void SampleDepths::AddColumnsOfFaces(int sample, std::vector<float>& columns) const
{
  const int lines = this->Stride - LaneCount;
  for (int line = 0; line < lines; line += LaneCount)
  {
    const std::size_t first = this->At(sample, line);
    const std::uint32_t* const faces = &this->Faces[first];
    const LaneMask isSame = LoadMask(faces) == LaneMask{} + static_cast<std::int32_t>(faces[0]);
    const unsigned covered =
      BitsOf(FirstLanes(lines - line) & (LoadLanes(&this->Depths[first]) > AllLanes(NotCovered)));
    if ((covered & BitsOf(isSame)) == AllBits) // One addition replaces eight dependent ones.
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
