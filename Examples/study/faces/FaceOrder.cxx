#include "study/faces/FaceOrder.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

// A larger table saves few more comparisons.
constexpr unsigned TableBits = 12;
constexpr std::uint64_t NoPair = ~std::uint64_t{ 0 };

// Rounding of float sums: of a depth, and of a column, whose error the slope turns into one of depth.
constexpr float DepthRounding = 0x1p-20f;
constexpr float ColumnRounding = 0x1p-21f;

float NoiseAt(float column, float slopes)
{
  return DepthRounding + slopes * ColumnRounding * (1.0f + std::abs(column));
}

std::uint64_t PairOf(std::uint32_t a, std::uint32_t b)
{
  return std::uint64_t{ std::min(a, b) } << 32 | std::max(a, b);
}

FaceOrder::Order Opposite(FaceOrder::Order order)
{
  using Order = FaceOrder::Order;
  return order == Order::Nearer ? Order::Farther : order == Order::Farther ? Order::Nearer : order;
}

SpanOrder ToSpanOrder(FaceOrder::Order order)
{
  using Order = FaceOrder::Order;
  return order == Order::Nearer ? SpanOrder::Nearer
    : order == Order::Farther   ? SpanOrder::Farther
                                : SpanOrder::NotKnown;
}

bool IsOneOrder(FaceOrder::Order order)
{
  return order == FaceOrder::Order::Nearer || order == FaceOrder::Order::Farther;
}

}

FaceOrder::FaceOrder(const FaceOrderStatements& statements)
  : Statements(statements)
{
  this->Forget();
}

void FaceOrder::Forget()
{
  this->Table.assign(std::size_t{ 1 } << TableBits, Entry{ NoPair, Order::NotKnown });
  this->Counted = {};
}

void FaceOrder::Begin(const FaceSegment& segment)
{
  this->Inserted = segment;
  this->Last.Known = Order::NotKnown;
}

SpanOrder FaceOrder::Of(const Span& there, float left, float right)
{
  const Order order = this->Derive(there, left, right);
  if (this->Statements.SharedEnds)
  {
    this->Last = { right, there.DepthAt(right), there.Face, order };
  }
  return ToSpanOrder(order);
}

/** Derives the order by the statements in use. */
FaceOrder::Order FaceOrder::Derive(const Span& there, float left, float right)
{
  if (this->Statements.OneOrder || this->Statements.Neighbours)
  {
    const Order own = this->Recall(this->Inserted.Covered.Face, there.Face);
    if (own == Order::Crossing)
    {
      return Order::NotKnown;
    }
    if (this->Statements.OneOrder && own != Order::NotKnown)
    {
      ++this->Counted.ByOneOrder;
      return own;
    }
  }
  if (const Order order = this->OfNeighbours(there.Face, left, right); IsOneOrder(order))
  {
    ++this->Counted.ByNeighbours;
    this->Remember(there.Face, order);
    return order;
  }
  if (const Order order = this->OfSharedEnd(there, left); IsOneOrder(order))
  {
    ++this->Counted.BySharedEnds;
    this->Remember(there.Face, order);
    return order;
  }
  return Order::NotKnown;
}

/** The span crosses the side that the segment shares with a neighbour, so it has the neighbour's order. */
FaceOrder::Order FaceOrder::OfNeighbours(std::uint32_t there, float left, float right)
{
  if (!this->Statements.Neighbours)
  {
    return Order::NotKnown;
  }
  Order order = Order::NotKnown;
  if (left == this->Inserted.Covered.Left)
  {
    order = this->Recall(this->Inserted.LeftNeighbour, there);
  }
  if (!IsOneOrder(order) && right == this->Inserted.Covered.Right)
  {
    order = this->Recall(this->Inserted.RightNeighbour, there);
  }
  return order;
}

/** A span that continues at the depth where the last one ended has that one's order. */
FaceOrder::Order FaceOrder::OfSharedEnd(const Span& there, float left)
{
  if (!this->Statements.SharedEnds || !IsOneOrder(this->Last.Known) || this->Last.Column != left)
  {
    return Order::NotKnown;
  }
  if (there.Face == this->Last.Face)
  {
    return this->Last.Known;
  }
  ++this->Counted.EndChecks;
  return std::abs(there.DepthAt(left) - this->Last.Depth) <= DepthRounding ? this->Last.Known
                                                                           : Order::NotKnown;
}

void FaceOrder::Learn(
  float slope, const Span& there, float left, float right, float leftNearer, float rightNearer)
{
  const float slopes = std::abs(slope) + std::abs(there.Slope);
  const float leftNoise = NoiseAt(left, slopes);
  const float rightNoise = NoiseAt(right, slopes);
  const bool isNearer = leftNearer > leftNoise || rightNearer > rightNoise;
  const bool isFarther = leftNearer < -leftNoise || rightNearer < -rightNoise;
  if (isNearer || isFarther) // Otherwise they touch at least.
  {
    const Order order = !isFarther ? Order::Nearer : !isNearer ? Order::Farther : Order::Crossing;
    this->Last.Known = std::abs(rightNearer) > rightNoise ? order : Order::NotKnown;
    this->Remember(there.Face, order);
  }
}

/** Returns the table entry of a pair. It may hold another pair. */
FaceOrder::Entry& FaceOrder::EntryOf(std::uint64_t pair)
{
  // This is Knuth's multiplicative hashing: the upper bits of a product with the golden ratio.
  return this->Table[pair * 0x9e3779b97f4a7c15u >> (64 - TableBits)];
}

FaceOrder::Order FaceOrder::Recall(std::uint32_t face, std::uint32_t there)
{
  if (face == NoNeighbour)
  {
    return Order::NotKnown;
  }
  ++this->Counted.Lookups;
  const std::uint64_t pair = PairOf(face, there);
  const Entry& entry = this->EntryOf(pair);
  if (entry.Pair != pair)
  {
    return Order::NotKnown;
  }
  return face < there ? entry.OfLower : Opposite(entry.OfLower);
}

/** Stores the order of the segment's face relative to the face `there`. */
void FaceOrder::Remember(std::uint32_t there, Order order)
{
  if (!this->Statements.OneOrder && !this->Statements.Neighbours)
  {
    return;
  }
  const std::uint32_t face = this->Inserted.Covered.Face;
  const std::uint64_t pair = PairOf(face, there);
  const Order ofLower = face < there ? order : Opposite(order);
  Entry& entry = this->EntryOf(pair);
  const bool isOther = entry.Pair == pair && entry.OfLower != ofLower;
  entry = { pair, isOther ? Order::Crossing : ofLower };
}

}
