#ifndef VITRINE_STUDY_FACES_FACE_ORDER_H
#define VITRINE_STUDY_FACES_FACE_ORDER_H

#include "Core/culling/buffer/SBufferInsertion.h"
#include "study/faces/ConvexFace.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/** The part of a line's middle that a face covers, and the faces across the sides where it ends. */
struct FaceSegment
{
  Segment Covered{};
  std::uint32_t LeftNeighbour = NoNeighbour;
  std::uint32_t RightNeighbour = NoNeighbour;
};

/** Selects the statements that a FaceOrder uses. */
struct FaceOrderStatements
{
  bool OneOrder = true; ///< Statement 1: two faces have one order wherever they overlap.
  /** Statement 2: spans that share an end have one order relative to a third face that passes there. */
  bool SharedEnds = true;
  /** Statement 3: faces that share a side have one order relative to a third face that passes there. */
  bool Neighbours = true;
};

/** Counters since Forget(). */
struct FaceOrderCounts
{
  std::uint64_t Lookups = 0;      ///< Lookups of pairs of faces.
  std::uint64_t EndChecks = 0;    ///< Tests of whether two spans share an end.
  std::uint64_t ByOneOrder = 0;   ///< Overlaps decided by statement 1.
  std::uint64_t BySharedEnds = 0; ///< Overlaps decided by statement 2.
  std::uint64_t ByNeighbours = 0; ///< Overlaps decided by statement 3.
};

/**
 * Knows which of two faces is in front, so that an s-buffer need not compare their depths. (A. V. Boreskov, the
 * hierarchical s-buffer, statements 1 to 3)
 *
 * The statements hold for flat convex faces that do not cross, for one eye. A pair that is seen to cross is remembered
 * as such, and its depths are compared each time. Statements 2 and 3 also assume that no third face touches what two
 * faces share. If faces do cross or touch, an s-buffer may hold a depth farther than the true one. It never holds a
 * nearer one, because the depth is that of one of the two faces. So use this for insertions only, and compare depths to
 * decide what is hidden.
 *
 * Orders are kept in a table of fixed size, in which a pair may replace another.
 */
class FaceOrder
{
public:
  /** The order of an inserted face relative to a stored one. */
  enum class Order : std::uint8_t
  {
    NotKnown,
    Nearer,
    Farther,
    Crossing ///< Each face is nearer in some place.
  };

  explicit FaceOrder(const FaceOrderStatements& statements = {});

  /** Forgets all orders, for another eye or other faces. */
  void Forget();

  /** Sets the segment that the next calls refer to. */
  void Begin(const FaceSegment& segment);

  /** Returns the order of the segment relative to a span between the columns `left` and `right`. */
  SpanOrder Of(const Span& there, float left, float right);

  /** Stores a comparison: the segment's depth minus the span's at both columns. */
  void Learn(
    float slope, const Span& there, float left, float right, float leftNearer, float rightNearer);

  const FaceOrderCounts& Counts() const { return this->Counted; }

private:
  struct Entry
  {
    std::uint64_t Pair;
    Order OfLower; ///< Order of the face with the lower number relative to the other.
  };

  /** The end of the last overlap. */
  struct OverlapEnd
  {
    float Column;
    float Depth; ///< Depth of the stored span.
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
