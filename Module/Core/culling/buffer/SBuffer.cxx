#include "Core/culling/buffer/SBuffer.h"

#include "Core/culling/buffer/SBufferInsertion.h"
#include "Core/geometry/Lanes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vitrine
{

SBuffer::SBuffer(int columns, int lines, const SampleGrid& samples, std::size_t mostSpans)
  : ColumnCount(columns)
  , LineCount(lines)
  , Grid(samples)
  , Tiles(columns, lines)
  , Firsts(Tiles.Count(), NoSpan)
  , MostSpans(mostSpans)
  , Pool(new Span[mostSpans])
{
  assert(columns > 0 && lines > 0 && mostSpans < NoSpan);
}

SBuffer SBuffer::WithFewSamples(int columns, int lines, const SampleGrid& samples)
{
  if (!SampleDepths::Suit(samples))
  {
    return SBuffer(columns, lines, samples);
  }
  SBuffer buffer(columns, lines, samples, 0);
  buffer.Firsts.clear();
  buffer.AtSamples = std::make_unique<SampleDepths>(columns, lines, samples);
  return buffer;
}

void SBuffer::Clear()
{
  for (int tile = 0; tile < this->Tiles.CountPerLine(); ++tile)
  {
    if (this->Tiles.IsTouched(tile))
    {
      this->Clear(tile);
    }
  }
  this->Used = 0;
  this->FirstFree = NoSpan;
  this->Counted = {};
}

/** Clears one tile of all lines. */
void SBuffer::Clear(int tile)
{
  const auto first = this->Firsts.begin() + static_cast<std::ptrdiff_t>(this->Tiles.At(0, tile));
  const auto end = this->Firsts.begin() + static_cast<std::ptrdiff_t>(this->Tiles.At(0, tile + 1));
  std::fill(first, end, NoSpan);
  this->Tiles.Clear(tile);
  if (this->AtSamples)
  {
    this->AtSamples->Clear(tile);
  }
}

std::uint32_t SBuffer::Allocate()
{
  if (this->FirstFree != NoSpan)
  {
    const std::uint32_t span = this->FirstFree;
    this->FirstFree = this->Pool[span].Next;
    return span;
  }
  if (this->Used == this->MostSpans)
  {
    ++this->Counted.Refused;
    return NoSpan;
  }
  return static_cast<std::uint32_t>(this->Used++);
}

void SBuffer::Free(std::uint32_t span)
{
  this->Pool[span].Next = this->FirstFree;
  this->FirstFree = span;
}

/** Inserts a segment into sample depths, which replace spans. */
void SBuffer::InsertAtSamples(int line, const Segment& segment)
{
  assert(line >= 0 && line < this->LineCount);
  const float left = std::max(segment.Left, 0.0f);
  const float right = std::min(segment.Right, static_cast<float>(this->ColumnCount));
  const float slope = (segment.RightDepth - segment.LeftDepth) / (segment.Right - segment.Left);
  if (!(left < right) || !std::isfinite(segment.Right - segment.Left) || !std::isfinite(slope) ||
    !std::isfinite(std::max(segment.LeftDepth, segment.RightDepth)))
  {
    return;
  }
  const SampleDepths::Range range = this->AtSamples->Between(left, right);
  if (range.First <= range.Last)
  {
    ++this->Counted.Inserted;
    this->Counted.Comparisons += static_cast<std::uint64_t>(range.Last + 1 - range.First);
    this->AtSamples->Insert(this->Tiles, line, range, segment.Face,
      [&](float column) { return segment.LeftDepth + slope * (column - segment.Left); });
  }
}

VITRINE_FOR_EACH_PROCESSOR
void SBuffer::Insert(int line, const Segment& segment)
{
  if (this->AtSamples)
  {
    this->InsertAtSamples(line, segment);
    return;
  }
  NoOrders none;
  this->InsertBy(none, line, segment);
}

VITRINE_INLINE bool SBuffer::TileHides(
  std::size_t tile, float left, float right, float nearest) const
{
  return this->ForEachCovered(this->Firsts[tile], left, right,
    [nearest](const Span& span, float first, float last)
    {
      return std::min(span.DepthAt(first), span.DepthAt(last)) > nearest; // NaN hides nothing.
    });
}

VITRINE_INLINE bool SBuffer::PartOfTilesHides(
  int first, int last, int tile, float left, float right, float nearest) const
{
  for (int line = first; line <= last; line += LaneCount)
  {
    unsigned open = this->Tiles.Open(line, last, tile, nearest);
    for (std::size_t above = this->Tiles.At(line, tile); open != 0; ++above, open >>= 1)
    {
      if ((open & 1) != 0 && !this->TileHides(above, left, right, nearest))
      {
        return false;
      }
    }
  }
  return true;
}

VITRINE_FOR_EACH_PROCESSOR
bool SBuffer::SpansHide(const ScreenRectangle& rectangle) const
{
  const float left = this->Grid.From(std::max(rectangle.Left, 0.0f));
  const float right =
    this->Grid.UpTo(std::min(rectangle.Right, static_cast<float>(this->ColumnCount)));
  const float bottom = this->Grid.From(std::max(rectangle.Bottom, 0.0f));
  const float top = this->Grid.UpTo(std::min(rectangle.Top, static_cast<float>(this->LineCount)));
  if (left > right || bottom > top)
  {
    return true;
  }
  if (!(left <= right && bottom <= top))
  {
    return false; // NaN may be anywhere.
  }
  const int lastLine = std::min(static_cast<int>(top), this->LineCount - 1);
  const int firstLine = std::min(static_cast<int>(bottom), lastLine);
  const int firstTile = this->Tiles.TileOf(left), lastTile = this->Tiles.TileOf(right);
  const auto sideOf = [](int tile) { return static_cast<float>(tile * TileWidth); };
  const int firstWhole = firstTile + (left > sideOf(firstTile) + this->Grid.Inset() ? 1 : 0);
  const int endOfWhole = lastTile + (right < sideOf(lastTile + 1) - this->Grid.Inset() ? 0 : 1);

  // The least depth of a tile decides for a whole tile, so whole tiles are tested first.
  for (int i = firstWhole; i < endOfWhole; ++i)
  {
    for (int line = firstLine; line <= lastLine; line += LaneCount)
    {
      if (this->Tiles.Open(line, lastLine, i, rectangle.Nearest) != 0)
      {
        return false;
      }
    }
  }
  for (int i = firstTile; i <= lastTile; ++i)
  {
    if (i == firstWhole && firstWhole < endOfWhole)
    {
      i = endOfWhole;
    }
    if (i <= lastTile &&
      !this->PartOfTilesHides(firstLine, lastLine, i, this->Grid.From(std::max(left, sideOf(i))),
        this->Grid.UpTo(std::min(right, sideOf(i + 1))), rectangle.Nearest))
    {
      return false;
    }
  }
  return true;
}

VITRINE_FOR_EACH_PROCESSOR
unsigned SBuffer::OpenLines(int line, int last, float left, float right, float depth) const
{
  const unsigned all = TileDepths::LowBits(last + 1 - line);
  const float columns = static_cast<float>(this->ColumnCount);
  // NaN selects the whole line.
  const float start = std::min(std::max(0.0f, left), columns);
  const float end = right <= columns ? std::max(start, right) : columns;
  const int lastTile = this->Tiles.TileOf(end);
  unsigned open = 0;
  for (int i = this->Tiles.TileOf(start); i <= lastTile && open != all; ++i)
  {
    open |= all & ~BitsOf(this->Tiles.OfLines(line, i) >= AllLanes(depth));
  }
  return open;
}

/** Tests the samples of one tile. It suffices to compare at both ends, because both depths are linear. */
VITRINE_INLINE bool SBuffer::TileHides(
  std::size_t tile, float left, float right, const HideableSegment& segment, float& shown) const
{
  const float nearest = std::max(segment.DepthAt(left), segment.DepthAt(right));
  if (this->Tiles[tile] > std::min(nearest, segment.Nearest))
  {
    return true;
  }
  shown = left;
  return this->ForEachCovered(this->Firsts[tile], left, right,
    [&](const Span& span, float first, float last)
    {
      const float firstDepth = span.DepthAt(first), lastDepth = span.DepthAt(last);
      const bool isBehind = firstDepth > segment.DepthAt(first);
      shown = isBehind ? last : first;
      if (!(isBehind && lastDepth > segment.DepthAt(last)) &&
        !(std::min(firstDepth, lastDepth) > segment.Nearest))
      {
        return false;
      }
      shown = this->Grid.Behind(last);
      return true;
    });
}

VITRINE_FOR_EACH_PROCESSOR
bool SBuffer::Hides(int line, const HideableSegment& segment, float& shown) const
{
  const float left = this->Grid.From(std::max(segment.Left, 0.0f));
  const float right =
    this->Grid.UpTo(std::min(segment.Right, static_cast<float>(this->ColumnCount)));
  if (left > right)
  {
    return true;
  }
  shown = left;
  if (!(left <= right))
  {
    return false; // NaN may be anywhere.
  }
  if (this->AtSamples)
  {
    return this->AtSamples->Hide(line, left, right, segment, shown);
  }
  const int last = this->Tiles.TileOf(right);
  for (int i = this->Tiles.TileOf(left); i <= last; ++i)
  {
    const float tileLeft = static_cast<float>(i * TileWidth);
    const float first = this->Grid.From(std::max(left, tileLeft));
    const float end = this->Grid.UpTo(std::min(right, tileLeft + TileWidth));
    if (first <= end && !this->TileHides(this->Tiles.At(line, i), first, end, segment, shown))
    {
      return false;
    }
  }
  return true;
}

template <class Work>
void SBuffer::ForEachSpan(std::uint32_t first, const Work& work) const
{
  for (std::uint32_t i = first; i != NoSpan; i = this->Pool[i].Next)
  {
    work(this->Pool[i]);
  }
}

std::vector<Span> SBuffer::SpansOf(int line) const
{
  assert(line >= 0 && line < this->LineCount);
  std::vector<Span> spans;
  if (this->AtSamples)
  {
    this->AtSamples->ForEachOn(line,
      [&](float column, float depth, std::uint32_t face) {
        spans.push_back({ column, column, depth, 0.0f, face, NoSpan });
      });
    return spans;
  }
  for (int i = 0; i < this->Tiles.CountPerLine(); ++i)
  {
    this->ForEachSpan(
      this->Firsts[this->Tiles.At(line, i)], [&](const Span& span) { spans.push_back(span); });
  }
  return spans;
}

void SBuffer::AddColumnsOfFaces(std::vector<float>& columns) const
{
  if (this->AtSamples)
  {
    this->AtSamples->AddColumnsOfFaces(this->Tiles, columns);
    return;
  }
  for (const std::uint32_t first : this->Firsts)
  {
    this->ForEachSpan(
      first, [&](const Span& span) { columns[span.Face] += span.Right - span.Left; });
  }
}

}
