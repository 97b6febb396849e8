#ifndef VITRINE_CORE_REVEAL_FRONT_STACKS_H
#define VITRINE_CORE_REVEAL_FRONT_STACKS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace vitrine
{

/**
 * What stands in front of a part, in each of its pixels. The layers of a pixel form a stack: how many layers each part
 * has there. Pixels with the same stack are kept once.
 *
 * A part in front is called a column here, as in a linear programme. Columns are numbered in the order in which they
 * are met.
 */
class FrontStacks
{
public:
  /** A part within a stack. */
  struct Entry
  {
    std::uint32_t Column;
    std::uint32_t Layers; // at least 1
  };

  static constexpr std::uint32_t NoStack = std::numeric_limits<std::uint32_t>::max();

  /**
   * Adds what is in front of a pixel of the part, or of a sample of it.
   * @param layers  the number of the part that each layer belongs to, in any order
   * @param count   the number of layers, which may be 0
   * @return        the stack, or NoStack if there is no layer
   */
  std::uint32_t Add(const std::uint32_t* layers, std::size_t count);

  /**
   * Adds a stack of parts that may come together in front of a pixel when the view turns.
   * @param entries  columns that are known, in ascending order
   */
  void AddNear(const std::vector<Entry>& entries);

  /** Returns the stacks that remain without the layers of some parts. */
  FrontStacks Without(const std::unordered_set<std::uint32_t>& parts) const;

  /** Returns true for a stack that no pixel has. */
  bool IsNear(std::size_t stack) const { return this->Near[stack]; }
  bool HasNear() const
  {
    return std::find(this->Near.begin(), this->Near.end(), true) != this->Near.end();
  }

  /** Returns the largest number of layers in front. */
  std::size_t MostLayers() const { return this->Most; }

  /** Returns the numbers of the parts that are in front, column by column. */
  const std::vector<std::uint32_t>& Parts() const { return this->PartOfColumn; }

  /** Returns how many different stacks there are, near ones among them. A stack has one layer at least. */
  std::size_t Count() const { return this->Starts.size() - 1; }

  /** Range of the entries of a stack, by columns. */
  const Entry* Begin(std::size_t stack) const { return this->Entries.data() + this->Starts[stack]; }
  const Entry* End(std::size_t stack) const { return this->Begin(stack + 1); }

private:
  std::uint32_t ColumnOf(std::uint32_t part);
  bool IsStack(std::size_t stack) const;
  std::uint32_t FindOrAdd(std::uint64_t hash, bool isNear);

  std::size_t Most = 0;
  std::vector<std::uint32_t> PartOfColumn;
  std::unordered_map<std::uint32_t, std::uint32_t> ColumnOfPart;
  std::vector<std::size_t> Starts = { 0 };
  std::vector<Entry> Entries;
  std::vector<bool> Near;
  std::unordered_multimap<std::uint64_t, std::uint32_t> StacksOfHash;

  // The stack that is being added.
  std::vector<std::uint32_t> LayersOfColumn; // all 0 between two pixels
  std::vector<std::uint32_t> Columns;
};

}

#endif
