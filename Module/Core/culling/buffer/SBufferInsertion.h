#ifndef VITRINE_CORE_CULLING_BUFFER_S_BUFFER_INSERTION_H
#define VITRINE_CORE_CULLING_BUFFER_S_BUFFER_INSERTION_H

#include "Core/culling/FaceOrder.h"
#include "Core/culling/buffer/SBuffer.h"

#include <algorithm>

namespace vitrine
{

/** Of segments of which no order is known. */
struct NoFaceOrder
{
  static FaceOrder::Order Of(const Span&, float, float) { return FaceOrder::Order::NotKnown; }
  static void Learn(float, const Span&, float, float, float, float) {}
};

/**
 * One segment on its way into one tile: goes over the list from left to right.
 * @tparam Orders  FaceOrder or NoFaceOrder, which are asked before two depths are compared
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
  // Pieces between a crossing and an end that are shorter are not worth a span.
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

  /** Take what is nearer of the segment and the span that covers from Left to `end`. */
  void Meet(Span& there, float end)
  {
    switch (this->Known.Of(there, this->Left, end))
    {
      case FaceOrder::Order::Nearer:
        this->Take(there, end);
        break;
      case FaceOrder::Order::Farther:
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
  Orders& Known;
  std::uint32_t* Link;  ///< to the first span that does not lie left of Left
  Span New;             ///< the whole segment
  Span* Last = nullptr; ///< the piece before Link, if it is one of this segment
  float Left = 0.0f;    ///< what lies left of it is done
  bool IsChanged = false;
};

}

#endif
