#include "Core/culling/SBuffer.h"

#include "Core/culling/Lanes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vitrine
{

namespace
{
// What stands in place of the least depth of a tile; below all depths.
const float NotFull = -1.0f;

// Pieces between a crossing and an end that are shorter are not worth a span.
const float ShortestPiece = 1.0f / 64.0f;

/** As many bits as lines, up to all lanes. */
unsigned LowBits(int lines)
{
  return (1u << std::min(lines, LaneCount)) - 1u;
}
}

/** One segment on its way into one tile: goes over the list from left to right. */
class SBuffer::Insertion
{
public:
  Insertion(SBuffer& buffer, std::uint32_t& first, const Segment& segment, float slope)
    : Buffer(buffer)
    , Link(&first)
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
  , TileStride(static_cast<std::size_t>(lines) + LaneCount)
  , Firsts(this->TileStride * this->TilesPerLine)
  , Leasts(this->Firsts.size())
  , MostSpans(mostSpans)
  , Pool(new Span[mostSpans])
{
  assert(columns > 0 && lines > 0 && mostSpans < NoSpan);
  this->Clear();
}

void SBuffer::Clear()
{
  std::fill(this->Firsts.begin(), this->Firsts.end(), NoSpan);
  std::fill(this->Leasts.begin(), this->Leasts.end(), NotFull);
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

VITRINE_FOR_EACH_PROCESSOR
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
    const std::size_t tile = this->TileAt(line, i);
    if (this->Leasts[tile] >= greatest)
    {
      continue;
    }
    const float tileLeft = static_cast<float>(i * TileWidth);
    const float tileRight = std::min(tileLeft + TileWidth, static_cast<float>(this->ColumnCount));
    if (Insertion(*this, this->Firsts[tile], segment, slope)
          .Run(std::max(left, tileLeft), std::min(right, tileRight)))
    {
      this->Leasts[tile] = this->LeastDepthOf(this->Firsts[tile], tileLeft, tileRight);
    }
  }
}

float SBuffer::LeastDepthOf(std::uint32_t first, float left, float right) const
{
  float covered = left;
  float least = 2.0f;
  for (std::uint32_t i = first; i != NoSpan; i = this->Pool[i].Next)
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

bool SBuffer::TileHides(std::size_t tile, float left, float right, float nearest) const
{
  float covered = left; // the question may be of one place alone
  for (std::uint32_t i = this->Firsts[tile]; i != NoSpan; i = this->Pool[i].Next)
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

/** A bit for each tile of a column of tiles, up to eight from `line` up to `last`, that is not known to be covered by what is nearer. */
VITRINE_INLINE unsigned SBuffer::OpenTiles(int line, int last, int tile, float nearest) const
{
  return ~BitsOf(LoadLanes(&this->Leasts[this->TileAt(line, tile)]) > AllLanes(nearest)) &
    LowBits(last + 1 - line);
}

VITRINE_INLINE bool SBuffer::PartOfTilesHides(
  int first, int last, int tile, float left, float right, float nearest) const
{
  for (int line = first; line <= last; line += LaneCount)
  {
    unsigned open = this->OpenTiles(line, last, tile, nearest);
    for (std::size_t above = this->TileAt(line, tile); open != 0; ++above, open >>= 1)
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
bool SBuffer::Hides(const ScreenRectangle& rectangle) const
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
  const int lastLine = std::min(static_cast<int>(top), this->LineCount - 1);
  const int firstLine = std::min(static_cast<int>(bottom), lastLine);
  const int lastTile = std::min(static_cast<int>(right) / TileWidth, this->TilesPerLine - 1);
  const int firstTile = std::min(static_cast<int>(left) / TileWidth, lastTile);
  const auto sideOf = [](int tile) { return static_cast<float>(tile * TileWidth); };
  const int firstWhole = firstTile + (left > sideOf(firstTile) + this->Grid.Inset() ? 1 : 0);
  const int endOfWhole = lastTile + (right < sideOf(lastTile + 1) - this->Grid.Inset() ? 0 : 1);

  // Where all of a tile is in question its least depth says all; such tiles are looked at first.
  for (int i = firstWhole; i < endOfWhole; ++i)
  {
    for (int line = firstLine; line <= lastLine; line += LaneCount)
    {
      if (this->OpenTiles(line, lastLine, i, rectangle.Nearest) != 0)
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
      !this->PartOfTilesHides(firstLine, lastLine, i, std::max(left, sideOf(i)),
        std::min(right, sideOf(i + 1)), rectangle.Nearest))
    {
      return false;
    }
  }
  return true;
}

std::vector<Span> SBuffer::SpansOf(int line) const
{
  assert(line >= 0 && line < this->LineCount);
  std::vector<Span> spans;
  for (int i = 0; i < this->TilesPerLine; ++i)
  {
    std::uint32_t span = this->Firsts[this->TileAt(line, i)];
    for (; span != NoSpan; span = this->Pool[span].Next)
    {
      spans.push_back(this->Pool[span]);
    }
  }
  return spans;
}

}
