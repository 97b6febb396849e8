#include "Core/culling/SBuffer.h"

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

// Pieces between a crossing and an end that are shorter are not worth a span.
const float ShortestPiece = 1.0f / 64.0f;
}

/** One segment on its way into one tile: goes over the list from left to right. */
class SBuffer::Insertion
{
public:
  Insertion(SBuffer& buffer, Tile& tile, const Segment& segment, float slope)
    : Buffer(buffer)
    , Link(&tile.First)
    , New{ segment.Left, segment.Right, segment.LeftDepth, slope, segment.Face, NoSpan }
  {
  }

  /** Returns whether anything changed. */
  bool Run(float left, float right)
  {
    this->Left = left;
    while (this->Left < right)
    {
      this->SkipTo(this->Left);
      Span* there = this->There();
      if (!there || there->Left >= right)
      {
        this->Put(right);
      }
      else if (there->Left > this->Left)
      {
        this->Put(there->Left);
      }
      else
      {
        this->Meet(*there, std::min(right, there->Right));
      }
    }
    return this->IsChanged;
  }

private:
  Span* There() const { return *this->Link == NoSpan ? nullptr : &this->Buffer.Pool[*this->Link]; }

  void SkipTo(float x)
  {
    for (Span* there = this->There(); there && there->Right <= x; there = this->There())
    {
      this->Link = &there->Next;
      this->Last = nullptr;
    }
  }

  /** Compare with the span that covers from Left to `end`, and take what is nearer. */
  void Meet(Span& there, float end)
  {
    const float left = this->New.DepthAt(this->Left) - there.DepthAt(this->Left);
    const float right = this->New.DepthAt(end) - there.DepthAt(end);
    this->Buffer.Counted.Comparisons += 2;
    if (left <= 0.0f && right <= 0.0f)
    {
      this->Left = end;
    }
    else if (left >= 0.0f && right >= 0.0f)
    {
      this->Take(there, end);
    }
    else
    {
      this->Cross(there, end, left, right);
    }
  }

  /** Nearer on one side of a crossing alone. */
  void Cross(Span& there, float end, float left, float right)
  {
    const float crossing = this->Left + (end - this->Left) * (left / (left - right));
    if (left > 0.0f && crossing - this->Left >= ShortestPiece)
    {
      this->Take(there, std::min(crossing, end));
    }
    else if (right > 0.0f && end - crossing >= ShortestPiece)
    {
      this->Left = std::max(crossing, this->Left);
      this->Take(there, end);
    }
    this->Left = end;
  }

  /** Put a piece in the place of what `there` covers from Left to `end`. */
  void Take(Span& there, float end)
  {
    if (there.Left < this->Left)
    {
      if (!this->CutBefore(there, end))
      {
        this->Left = end;
        return;
      }
    }
    else if (end < there.Right)
    {
      there.Depth = there.DepthAt(end);
      there.Left = end;
    }
    else
    {
      const std::uint32_t gone = *this->Link;
      *this->Link = there.Next;
      this->Buffer.Free(gone);
    }
    this->Put(end);
  }

  /** Leave of `there` what lies left of Left, and right of `end` as a span of its own; the link is between them then. */
  bool CutBefore(Span& there, float end)
  {
    if (end < there.Right)
    {
      const std::uint32_t rest = this->Buffer.Allocate();
      if (rest == NoSpan)
      {
        return false;
      }
      Span& other = this->Buffer.Pool[rest];
      other = there;
      other.Depth = there.DepthAt(end);
      other.Left = end;
      there.Next = rest;
    }
    there.Right = this->Left;
    this->Link = &there.Next;
    this->Last = nullptr;
    return true;
  }

  /** A piece from Left to `right`, where nothing is now; longer, if the last one ends there. */
  void Put(float right)
  {
    this->IsChanged = true;
    if (this->Last && this->Last->Right == this->Left)
    {
      this->Last->Right = right;
    }
    else if (const std::uint32_t place = this->Buffer.Allocate(); place != NoSpan)
    {
      this->Last = &this->Buffer.Pool[place];
      *this->Last = this->New;
      this->Last->Left = this->Left;
      this->Last->Right = right;
      this->Last->Depth = this->New.DepthAt(this->Left);
      this->Last->Next = *this->Link;
      *this->Link = place;
      this->Link = &this->Last->Next;
    }
    this->Left = right;
  }

  SBuffer& Buffer;
  std::uint32_t* Link;  ///< to the first span that does not lie left of Left
  Span New;             ///< the whole segment
  Span* Last = nullptr; ///< the piece before Link, if it is one of this segment
  float Left = 0.0f;    ///< what lies left of it is done
  bool IsChanged = false;
};

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
    if (Insertion(*this, tile, segment, slope)
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
