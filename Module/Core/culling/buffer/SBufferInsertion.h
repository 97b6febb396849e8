#ifndef VITRINE_CORE_CULLING_BUFFER_S_BUFFER_INSERTION_H
#define VITRINE_CORE_CULLING_BUFFER_S_BUFFER_INSERTION_H

#include "Core/culling/buffer/SBuffer.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vitrine
{

/** The depth order of a segment relative to a stored span, as far as known without comparing depths. */
enum class SpanOrder : std::uint8_t
{
  NotKnown,
  Nearer,
  Farther
};

/** The order policy that knows nothing: depths are always compared. */
struct NoOrders
{
  /** Returns the order of the segment relative to a span between two columns. */
  static SpanOrder Of(const Span&, float, float) { return SpanOrder::NotKnown; }

  /**
   * Receives the result of a comparison: the segment's slope, the span, the two columns, and the segment's depth minus
   * the span's at each of them.
   */
  static void Learn(float, const Span&, float, float, float, float) {}
};

/**
 * The insertion of one segment into one tile. It walks the span list from left to right.
 * @tparam Orders  an order policy with the interface of NoOrders
 */
template <class Orders>
class SBuffer::Insertion
{
public:
  Insertion(
    SBuffer& buffer, Orders& orders, std::uint32_t& first, const Segment& segment, float slope)
    : Buffer(buffer)
    , Known(orders)
    , Link(&first)
    , New{ segment.Left, segment.Right, segment.LeftDepth, slope, segment.Face, NoSpan }
  {
  }

  /** Inserts the segment between two columns. Returns true if the list changed. */
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
  // Shorter pieces between a crossing and an end are dropped. They are not worth a span.
  static constexpr float ShortestPiece = 1.0f / 64.0f;

  Span* There() const { return *this->Link == NoSpan ? nullptr : &this->Buffer.Pool[*this->Link]; }

  void SkipTo(float x)
  {
    for (Span* there = this->There(); there && there->Right <= x; there = this->There())
    {
      this->Link = &there->Next;
      this->Last = nullptr;
    }
  }

  /** Keeps the nearer of the segment and the span between Left and `end`. */
  void Meet(Span& there, float end)
  {
    switch (this->Known.Of(there, this->Left, end))
    {
      case SpanOrder::Nearer:
        this->Take(there, end);
        break;
      case SpanOrder::Farther:
        this->Left = end;
        break;
      default:
        this->Compare(there, end);
        break;
    }
  }

  void Compare(Span& there, float end)
  {
    const float left = this->New.DepthAt(this->Left) - there.DepthAt(this->Left);
    const float right = this->New.DepthAt(end) - there.DepthAt(end);
    this->Buffer.Counted.Comparisons += 2;
    this->Known.Learn(this->New.Slope, there, this->Left, end, left, right);
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

  /** Handles a crossing: the segment is nearer on one side only. */
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

  /** Replaces `there` between Left and `end` by a piece of the segment. */
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

  /**
   * Cuts the interval from Left to `end` out of `there`. A remainder on the right becomes a new span. Afterwards Link
   * points between both parts. Returns false if the pool is exhausted.
   */
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

  /** Puts a piece from Left to `right` into a gap. It extends the last piece if that ends at Left. */
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
  Orders& Known;
  std::uint32_t* Link;  ///< The link to the first span that does not lie left of Left.
  Span New;             ///< The whole segment.
  Span* Last = nullptr; ///< The piece before Link, if it belongs to this segment.
  float Left = 0.0f;    ///< Everything left of this column is done.
  bool IsChanged = false;
};

/**
 * Calls work(span, first, last) for each span of a tile that covers samples between `left` and `right`. Here `first`
 * and `last` are the first and the last of the covered samples.
 * @param work  returns true to continue
 * @returns     true if the spans cover all samples and `work` always returned true
 */
template <class Work>
VITRINE_INLINE bool SBuffer::ForEachCovered(
  std::uint32_t first, float left, float right, const Work& work) const
{
  float next = left; // A query of one sample has left == right.
  for (std::uint32_t i = first; i != NoSpan; i = this->Pool[i].Next)
  {
    const Span& span = this->Pool[i];
    if (span.Right < next)
    {
      continue; // The span ends before the next sample.
    }
    const float last = span.Right < right ? this->Grid.UpTo(span.Right) : right;
    if (span.Left > next || !work(span, next, last))
    {
      return false;
    }
    if (last >= right)
    {
      return true;
    }
    next = this->Grid.Behind(last);
  }
  return false;
}

template <class Orders>
VITRINE_INLINE void SBuffer::InsertBy(Orders& orders, int line, const Segment& segment)
{
  assert(!this->AtSamples && line >= 0 && line < this->LineCount);
  const float left = std::max(segment.Left, 0.0f);
  const float right = std::min(segment.Right, static_cast<float>(this->ColumnCount));
  const float length = segment.Right - segment.Left;
  const float slope = (segment.RightDepth - segment.LeftDepth) / length;
  const float greatest = std::max(segment.LeftDepth, segment.RightDepth);
  if (!(left < right && this->Grid.From(left) <= this->Grid.UpTo(right)) ||
    !std::isfinite(length) || !std::isfinite(slope) || !std::isfinite(greatest))
  {
    return;
  }
  ++this->Counted.Inserted;
  const int last = this->Tiles.TileOf(right);
  for (int i = this->Tiles.TileOf(left); i <= last; ++i)
  {
    const std::size_t tile = this->Tiles.At(line, i);
    if (this->Tiles[tile] >= greatest)
    {
      continue;
    }
    this->Tiles.Touch(i);
    const float tileLeft = static_cast<float>(i * TileWidth);
    const float tileRight = std::min(tileLeft + TileWidth, static_cast<float>(this->ColumnCount));
    if (Insertion<Orders>(*this, orders, this->Firsts[tile], segment, slope)
          .Run(std::max(left, tileLeft), std::min(right, tileRight)))
    {
      float least = 2.0f;
      const bool isFull = this->ForEachCovered(this->Firsts[tile], this->Grid.From(tileLeft),
        this->Grid.UpTo(tileRight),
        [&least](const Span& span, float first, float last)
        {
          least = std::min(least, std::min(span.DepthAt(first), span.DepthAt(last)));
          return true;
        });
      this->Tiles[tile] = isFull ? least : TileDepths::NotFull;
    }
  }
}

}

#endif
