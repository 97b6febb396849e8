#include "Core/culling/SBuffer.h"

#include "Core/culling/FaceOrder.h"
#include "Core/culling/SBufferInsertion.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vitrine
{

namespace
{
// What Tile::Least says in place of a depth; both are below all depths.
const float NotFull = -1.0f;
const float NotKnown = -2.0f;
}

SBuffer::SBuffer(int columns, int lines, const SampleGrid& samples, std::size_t mostSpans)
  : ColumnCount(columns)
  , LineCount(lines)
  , TilesPerLine((columns + TileWidth - 1) / TileWidth)
  , Grid(samples)
  , Tiles(static_cast<std::size_t>(this->TilesPerLine) * lines)
  , MostSpans(mostSpans)
  , Pool(new Span[mostSpans])
{
  assert(columns > 0 && lines > 0 && mostSpans < NoSpan);
  this->Clear();
}

void SBuffer::Clear()
{
  std::fill(this->Tiles.begin(), this->Tiles.end(), Tile{ NoSpan, NotFull });
  this->Used = 0;
  this->FirstFree = NoSpan;
  this->Counted = {};
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

void SBuffer::Insert(int line, const Segment& segment)
{
  NoFaceOrder none;
  this->InsertBy(none, line, segment);
}

void SBuffer::Insert(int line, const FaceSegment& segment, FaceOrder& order)
{
  order.Begin(segment);
  this->InsertBy(order, line, segment.Covered);
}

template <class Orders>
inline void SBuffer::InsertBy(Orders& orders, int line, const Segment& segment)
{
  assert(line >= 0 && line < this->LineCount);
  const float left = std::max(segment.Left, 0.0f);
  const float right = std::min(segment.Right, static_cast<float>(this->ColumnCount));
  const float length = segment.Right - segment.Left;
  const float slope = (segment.RightDepth - segment.LeftDepth) / length;
  const float greatest = std::max(segment.LeftDepth, segment.RightDepth);
  if (!(left < right) || !std::isfinite(length) || !std::isfinite(slope) ||
    !std::isfinite(greatest))
  {
    return;
  }
  ++this->Counted.Inserted;
  const int last = std::min(static_cast<int>(right) / TileWidth, this->TilesPerLine - 1);
  for (int i = static_cast<int>(left) / TileWidth; i <= last; ++i)
  {
    Tile& tile = this->Tiles[static_cast<std::size_t>(line) * this->TilesPerLine + i];
    if (tile.Least >= greatest)
    {
      continue;
    }
    const float tileLeft = static_cast<float>(i * TileWidth);
    if (Insertion<Orders>(*this, orders, tile, segment, slope)
          .Run(std::max(left, tileLeft), std::min(right, tileLeft + TileWidth)))
    {
      tile.Least = NotKnown;
    }
  }
}

float SBuffer::LeastOf(const Tile& tile, float left, float right) const
{
  float covered = left;
  float least = 2.0f;
  for (std::uint32_t i = tile.First; i != NoSpan; i = this->Pool[i].Next)
  {
    const Span& span = this->Pool[i];
    if (span.Left > covered)
    {
      return NotFull;
    }
    covered = span.Right;
    least = std::min(least, std::min(span.Depth, span.DepthAt(span.Right)));
  }
  return covered >= right ? least : NotFull;
}

bool SBuffer::TileHides(const Tile& tile, float left, float right, float nearest) const
{
  float covered = left; // the question may be of one place alone
  for (std::uint32_t i = tile.First; i != NoSpan; i = this->Pool[i].Next)
  {
    const Span& span = this->Pool[i];
    if (span.Right < covered)
    {
      continue;
    }
    const float end = std::min(right, span.Right);
    if (span.Left > covered ||
      !(std::min(span.DepthAt(covered), span.DepthAt(end)) > nearest)) // as is no number
    {
      return false;
    }
    covered = end;
    if (covered >= right)
    {
      return true;
    }
  }
  return false;
}

bool SBuffer::Hides(const ScreenRectangle& rectangle, float margin)
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
    return false; // not a number: it may be anywhere
  }
  const float nearest = rectangle.Nearest + margin;
  const int lastLine = std::min(static_cast<int>(top), this->LineCount - 1);
  for (int line = std::min(static_cast<int>(bottom), lastLine); line <= lastLine; ++line)
  {
    if (!this->LineHides(line, left, right, nearest))
    {
      return false;
    }
  }
  return true;
}

bool SBuffer::LineHides(int line, float left, float right, float nearest)
{
  const int last = std::min(static_cast<int>(right) / TileWidth, this->TilesPerLine - 1);
  for (int i = std::min(static_cast<int>(left) / TileWidth, last); i <= last; ++i)
  {
    const Tile& tile = this->KnownTile(line, i);
    const float tileLeft = static_cast<float>(i * TileWidth);
    if (!(tile.Least > nearest) &&
      !this->TileHides(
        tile, std::max(left, tileLeft), std::min(right, tileLeft + TileWidth), nearest))
    {
      return false;
    }
  }
  return true;
}

bool SBuffer::Hides(int line, const Segment& segment, float margin) const
{
  const float left = std::max(segment.Left, 0.0f);
  const float right = std::min(segment.Right, static_cast<float>(this->ColumnCount));
  if (left >= right)
  {
    return true;
  }
  const float slope = (segment.RightDepth - segment.LeftDepth) / (segment.Right - segment.Left);
  if (!(left < right) || !std::isfinite(slope))
  {
    return false; // not a number: it may be anywhere
  }
  const int last = std::min(static_cast<int>(right) / TileWidth, this->TilesPerLine - 1);
  float covered = left;
  for (int i = static_cast<int>(left) / TileWidth; i <= last; ++i)
  {
    const Tile& tile = this->Tiles[static_cast<std::size_t>(line) * this->TilesPerLine + i];
    for (std::uint32_t j = tile.First; j != NoSpan && covered < right; j = this->Pool[j].Next)
    {
      const Span& span = this->Pool[j];
      if (span.Right <= covered)
      {
        continue;
      }
      const float end = std::min(right, span.Right);
      const auto isNearer = [&](float x)
      { return span.DepthAt(x) > segment.LeftDepth + slope * (x - segment.Left) + margin; };
      if (span.Left > covered || !isNearer(covered) || !isNearer(end))
      {
        return false;
      }
      covered = end;
    }
  }
  return covered >= right;
}

bool SBuffer::IsCoveredBefore(int line, int tile, float depth)
{
  return this->KnownTile(line, tile).Least >= depth;
}

/** A tile, with its least depth found. */
SBuffer::Tile& SBuffer::KnownTile(int line, int tile)
{
  Tile& known = this->Tiles[static_cast<std::size_t>(line) * this->TilesPerLine + tile];
  if (known.Least == NotKnown)
  {
    const float left = static_cast<float>(tile * TileWidth);
    known.Least =
      this->LeastOf(known, left, std::min(left + TileWidth, static_cast<float>(this->ColumnCount)));
  }
  return known;
}

std::vector<Span> SBuffer::SpansOf(int line) const
{
  assert(line >= 0 && line < this->LineCount);
  std::vector<Span> spans;
  for (int i = 0; i < this->TilesPerLine; ++i)
  {
    std::uint32_t span = this->Tiles[static_cast<std::size_t>(line) * this->TilesPerLine + i].First;
    for (; span != NoSpan; span = this->Pool[span].Next)
    {
      spans.push_back(this->Pool[span]);
    }
  }
  return spans;
}

}
