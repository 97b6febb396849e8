#include "Core/lists/ResolveProgram.h"

#include "Core/lists/SortingNetwork.h"

#include <cassert>

namespace vitrine
{
namespace
{

std::string Register(int i)
{
  return "f" + std::to_string(i);
}

// Returns `macro(f) ` for each register from `first` to `end` - 1.
std::string ForEach(const std::string& macro, int first, int end)
{
  std::string text;
  for (int i = first; i < end; ++i)
  {
    text += macro + "(" + Register(i) + ")" + ((i - first) % 8 == 7 ? "\n" : " ");
  }
  return text + "\n";
}

std::string Pair(const std::string& macro, int a, int b)
{
  return macro + "(" + Register(a) + ", " + Register(b) + ")\n";
}

std::string DeclarePages(int count)
{
  std::string text;
  for (int page = 0; page < count; ++page)
  {
    text += "DECLARE_PAGE(p" + std::to_string(page) + ")\n";
  }
  return text;
}

// Returns `macro(f, p, i)` for `count` registers from `first` on: slot i of page p. If `begin` is not empty, `begin(p)`
// precedes each page.
std::string ForEachSlot(
  const std::string& begin, const std::string& macro, int first, int count, int pageSize)
{
  std::string text;
  for (int i = 0; i < count; ++i)
  {
    const std::string page = "p" + std::to_string(i / pageSize);
    const int slot = i % pageSize;
    text += slot == 0 && !begin.empty() ? begin + "(" + page + ")\n" : "";
    text += macro + "(" + Register(first + i) + ", " + page + ", " + std::to_string(slot) + ")\n";
  }
  return text;
}

// Returns text that moves each register down by one, and clears the last.
std::string MoveDownByOne(const std::string& move, const std::string& clear, int size)
{
  std::string text;
  for (int i = 0; i + 1 < size; ++i)
  {
    text += Pair(move, i, i + 1);
  }
  return text + ForEach(clear, size - 1, size);
}

// Returns one round of odd-even transposition, which visits each pair of neighbours once.
std::string NeighbourPairs(const std::string& macro, int size)
{
  std::string text;
  for (int parity = 0; parity < 2; ++parity)
  {
    for (int i = parity; i + 1 < size; i += 2)
    {
      text += Pair(macro, i, i + 1);
    }
  }
  return text;
}

SortingNetwork Shifted(SortingNetwork network, int by)
{
  for (Comparator& c : network.Comparators)
  {
    c.Low += by;
    c.High += by;
  }
  return network;
}

// Merges the sorted block in registers [block, 2 block) into the sorted block in [0, block), which keeps the nearest
// half. The minima of one block and the other reversed are a bitonic sequence, which half-cleaners sort.
std::string KeepNearest(const std::string& macro, int block)
{
  std::string text;
  for (int i = 0; i < block; ++i)
  {
    text += Pair(macro, i, 2 * block - 1 - i);
  }
  for (int stride = block / 2; stride > 0; stride /= 2)
  {
    for (int i = 0; i < block; ++i)
    {
      if ((i & stride) == 0)
      {
        text += Pair(macro, i, i + stride);
      }
    }
  }
  return text;
}

}

ResolveText UnrollResolve(int size, int pageSize)
{
  assert(size > 0 && pageSize > 0 && size % pageSize == 0);
  ResolveText text;
  text.Declare = ForEach("DECLARE", 0, size);
  for (int first = 0; first < size; first += pageSize)
  {
    text.Load += first > 0 ? "NEXT_PAGE\n" : "";
    for (int slot = 0; slot < pageSize; ++slot)
    {
      text.Load += "LOAD(" + Register(first + slot) + ", " + std::to_string(slot) + ")\n";
    }
  }
  text.Sort = EmitGlsl(BestKnownNetwork(size), "COMPARE_EXCHANGE", "f");
  text.OrderTies = NeighbourPairs("ORDER_TIE", size);
  text.Blend = ForEach("BLEND", 0, size);
  text.Advance = MoveDownByOne("MOVE", "CLEAR", size);
  return text;
}

SlotResolveText UnrollSlotResolve(int size, int group)
{
  assert(group > 0 && size > group && size % group == 0);
  const std::string move = "MOVE_SLOT";
  SlotResolveText text;
  text.Declare = ForEach("DECLARE_SLOT", 0, size);
  for (int i = size; i-- > group;)
  {
    text.MoveUp += Pair(move, i, i - group);
  }
  for (int i = 0; i < group; ++i)
  {
    text.Load += "LOAD_SLOT(" + Register(i) + ", " + std::to_string(i) + ")\n";
    text.Rotate += "KEEP_SLOT(" + Register(i) + ", kept" + std::to_string(i) + ")\n";
  }
  text.Sort = EmitGlsl(BestKnownNetwork(size), "COMPARE_EXCHANGE_SLOTS", "f");
  for (int i = 0; i + 1 < size; ++i)
  {
    text.FindTies += Pair("FIND_TIE", i, i + 1);
  }
  for (int i = 0; i + 1 < group; ++i)
  {
    text.OrderTies += Pair("ORDER_SLOTS_TIE", i, i + 1);
  }
  text.OrderTieOfGroups = Pair("ORDER_SLOTS_TIE", group - 1, group);
  text.Blend = ForEach("BLEND_SLOT", 0, group);
  for (int i = 0; i + group < size; ++i)
  {
    text.MoveDown += Pair(move, i, i + group);
  }
  text.Rotate += text.MoveDown;
  for (int i = 0; i < group; ++i)
  {
    text.Rotate += move + "(" + Register(size - group + i) + ", kept" + std::to_string(i) + ")\n";
  }
  text.MoveDown += ForEach("CLEAR_SLOT", size - group, size);
  text.Advance = MoveDownByOne(move, "CLEAR_SLOT", size);
  return text;
}

LongResolveText UnrollLongResolve(int block)
{
  assert(block > 1 && (block & (block - 1)) == 0);
  const std::string compare = "COMPARE_EXCHANGE_FULL";
  LongResolveText text;
  text.Declare = ForEach("DECLARE", 0, 2 * block);
  text.ClearNearest = ForEach("CLEAR", 0, block);
  text.LoadBlock = ForEach("LOAD", block, 2 * block);
  text.SortBlock = EmitGlsl(Shifted(BestKnownNetwork(block), block), compare, "f");
  text.MergeBlock = KeepNearest(compare, block);
  text.Blend = ForEach("BLEND", 0, block);
  text.CountSame = ForEach("COUNT_SAME", 0, block);
  text.LastRegister = Register(block - 1);
  return text;
}

SortRunsText UnrollSortRuns(int size, int pageSize)
{
  assert(size > 0 && pageSize > 0 && size % pageSize == 0);
  SortRunsText text;
  text.Declare = ForEach("DECLARE", 0, size) + DeclarePages(size / pageSize);
  text.Load = ForEachSlot("TAKE_PAGE", "LOAD", 0, size, pageSize);
  text.Sort = EmitGlsl(BestKnownNetwork(size), "COMPARE_EXCHANGE_FULL", "f");
  text.Store = ForEachSlot("", "STORE", 0, size, pageSize);
  return text;
}

SortLongRunsText UnrollSortLongRuns(int block, int pageSize)
{
  assert(pageSize > 0 && block % pageSize == 0);
  const LongResolveText blocks = UnrollLongResolve(block);
  SortLongRunsText text;
  text.Declare = blocks.Declare + DeclarePages(block / pageSize);
  text.ClearNearest = blocks.ClearNearest;
  text.Load = ForEachSlot("TAKE_PAGE", "LOAD", block, block, pageSize);
  text.Sort = blocks.SortBlock;
  text.Merge = blocks.MergeBlock;
  text.Store = ForEachSlot("", "STORE", block, block, pageSize);
  text.StoreNearest = ForEachSlot("TAKE_PAGE", "STORE", 0, block, pageSize);
  return text;
}

MergeRunsText UnrollMergeRuns(int runs, int groupSize)
{
  assert(groupSize > 0 && runs > 0 && runs % groupSize == 0);
  MergeRunsText text;
  text.FindNearest = "run = g0;\n";
  for (int group = 0; group < runs / groupSize; ++group)
  {
    const std::string nearest = "g" + std::to_string(group);
    text.Declare += "DECLARE_RUN(" + nearest + ")\n";
    text.FindNearest += group > 0 ? "TAKE_NEARER(run, " + nearest + ")\n" : "";
    const int first = group * groupSize;
    text.PutBack +=
      "if (number / " + std::to_string(groupSize) + "u == " + std::to_string(group) + "u)\n{\n";
    std::string takeNearest = nearest + " = r" + std::to_string(first) + ";\n";
    for (int i = first; i < first + groupSize; ++i)
    {
      const std::string run = "r" + std::to_string(i);
      text.Declare += "DECLARE_RUN(" + run + ")\n";
      text.PutBack += "PUT_BACK(" + run + ", " + std::to_string(i) + "u)\n";
      takeNearest += i > first ? "TAKE_NEARER(" + nearest + ", " + run + ")\n" : "";
    }
    text.PutBack += takeNearest + "}\n";
  }
  return text;
}

}
