#ifndef VITRINE_STUDY_FACES_FACE_ORDER_H
#define VITRINE_STUDY_FACES_FACE_ORDER_H

#include "Core/culling/buffer/SBufferInsertion.h"
#include "study/faces/ConvexFace.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/** What a face covers of the middle of a line, and which faces are across the sides that it ends at. */
struct FaceSegment
{
  Segment Covered{};
  std::uint32_t LeftNeighbour = NoNeighbour;
  std::uint32_t RightNeighbour = NoNeighbour;
};

/** Which of the statements a FaceOrder goes by. */
struct FaceOrderStatements
{
  bool OneOrder = true; ///< 1: two faces have one order wherever they overlap
  bool SharedEnds =
    true; ///< 2: spans that share an end have one order towards a third that passes there
  bool Neighbours = true; ///< 3: so have faces that share a side
};

/** Counts since Forget(). */
struct FaceOrderCounts
{
  std::uint64_t Lookups = 0;      ///< of pairs of faces
  std::uint64_t EndChecks = 0;    ///< whether two spans share an end
  std::uint64_t ByOneOrder = 0;   ///< overlaps that were decided by statement 1
  std::uint64_t BySharedEnds = 0; ///< by statement 2
  std::uint64_t ByNeighbours = 0; ///< by statement 3
};

/**
 * Knows which of two faces is in front, so that an s-buffer need not compare their depths. (A. V. Boreskov, the hierarchical
 * s-buffer, statements 1 to 3)
 *
 * The statements hold for flat convex faces that do not cross, for one eye. Of a pair that is seen to cross this is kept, and
 * depths are compared each time. Statements 2 and 3 take it besides that no third face touches what two have in common.
 * Where faces do cross or touch, what an s-buffer holds may be farther than what is there, but never nearer: it is one of
 * the two faces in any case. So this is for insertions; the verdict on what is hidden compares depths.
 *
 * Orders are kept in a table of fixed size, in which a pair may take the place of another.
 */
class FaceOrder
{
public:
  /** Of a face that is inserted towards one that is there. */
  enum class Order : std::uint8_t
  {
    NotKnown,
    Nearer,
    Farther,
    Crossing ///< each in a place of its own
  };

  explicit FaceOrder(const FaceOrderStatements& statements = {});

  /** Nothing is known: the eye or the faces are others. */
  void Forget();

  /** What is asked for next is of this segment. */
  void Begin(const FaceSegment& segment);

  /** Of the segment towards a span that covers from `left` to `right`. */
  SpanOrder Of(const Span& there, float left, float right);

  /** By how much the segment is nearer than the span at both places. */
  void Learn(
    float slope, const Span& there, float left, float right, float leftNearer, float rightNearer);

  const FaceOrderCounts& Counts() const { return this->Counted; }

private:
  struct Entry
  {
    std::uint64_t Pair;
    Order OfLower; ///< of the face with the lower number towards the other
  };

  /** Where the last overlap ended. */
  struct OverlapEnd
  {
    float Column;
    float Depth; ///< of what was there
    std::uint32_t Face;
    Order Known;
  };

  Entry& EntryOf(std::uint64_t pair);
  Order Recall(std::uint32_t face, std::uint32_t there);
  void Remember(std::uint32_t there, Order order);
  Order OfNeighbours(std::uint32_t there, float left, float right);
  Order OfSharedEnd(const Span& there, float left);
  Order Derive(const Span& there, float left, float right);

  FaceOrderStatements Statements;
  std::vector<Entry> Table;
  FaceSegment Inserted;
  OverlapEnd Last{};
  FaceOrderCounts Counted;
};

}

#endif
