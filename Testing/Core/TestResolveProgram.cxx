// The generated parts of the resolve shaders, read back and carried out on numbers.
#include "Core/lists/ResolveProgram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <random>
#include <regex>
#include <string>
#include <vector>

namespace
{

struct Call
{
  std::string Macro;
  std::vector<std::string> Operands;

  // The number in an operand such as "f12".
  int Number(std::size_t operand) const
  {
    return std::stoi(
      this->Operands[operand].substr(this->Operands[operand].find_first_of("0123456789")));
  }
};

// The calls `MACRO(a, b)` and the bare words in generated text.
std::vector<Call> Calls(const std::string& text)
{
  static const std::regex word(R"((\w+)(\(([^)]*)\))?)");
  static const std::regex operand(R"(\w+)");
  std::vector<Call> calls;
  for (std::sregex_iterator it(text.begin(), text.end(), word), end; it != end; ++it)
  {
    const std::string operands = (*it)[3];
    Call call{ (*it)[1], {} };
    for (std::sregex_iterator o(operands.begin(), operands.end(), operand); o != end; ++o)
    {
      call.Operands.push_back(o->str());
    }
    calls.push_back(call);
  }
  return calls;
}

void CompareExchange(const std::string& text, const std::string& macro, std::vector<int>& registers)
{
  for (const Call& call : Calls(text))
  {
    ASSERT_EQ(call.Macro, macro);
    ASSERT_EQ(call.Operands.size(), 2u);
    int& near = registers.at(call.Number(0));
    int& far = registers.at(call.Number(1));
    if (near > far)
    {
      std::swap(near, far);
    }
  }
}

std::vector<int> RandomKeys(std::mt19937& random, int count)
{
  std::vector<int> keys(count);
  for (int& key : keys)
  {
    key = static_cast<int>(random() % 50);
  }
  return keys;
}

void ExpectOneEach(const std::string& text, const std::string& macro, int first, int end)
{
  const std::vector<Call> calls = Calls(text);
  ASSERT_EQ(static_cast<int>(calls.size()), end - first);
  for (int i = first; i < end; ++i)
  {
    EXPECT_EQ(calls[i - first].Macro, macro);
    EXPECT_EQ(calls[i - first].Operands, std::vector<std::string>{ "f" + std::to_string(i) });
  }
}

class ShortResolve : public testing::TestWithParam<int>
{
};

TEST_P(ShortResolve, DeclaresAndBlendsEachRegisterFrontToBack)
{
  const vitrine::ResolveText text = vitrine::UnrollResolve(GetParam(), 1);
  ExpectOneEach(text.Declare, "DECLARE", 0, GetParam());
  ExpectOneEach(text.Blend, "BLEND", 0, GetParam());
}

TEST_P(ShortResolve, LoadsEachSlotOfEachPageOnce)
{
  for (const int pageSize : { 1, 2, 4, 8 })
  {
    int loaded = 0;
    int slot = 0;
    for (const Call& call : Calls(vitrine::UnrollResolve(GetParam(), pageSize).Load))
    {
      if (call.Macro == "NEXT_PAGE")
      {
        EXPECT_EQ(slot, pageSize);
        slot = 0;
        continue;
      }
      ASSERT_EQ(call.Macro, "LOAD");
      EXPECT_EQ(call.Number(0), loaded++);
      EXPECT_EQ(call.Number(1), slot++);
    }
    EXPECT_EQ(loaded, GetParam());
    EXPECT_EQ(slot, pageSize);
  }
}

TEST_P(ShortResolve, Sorts)
{
  std::mt19937 random(1);
  const std::string sort = vitrine::UnrollResolve(GetParam(), 1).Sort;
  for (int round = 0; round < 200; ++round)
  {
    std::vector<int> keys = RandomKeys(random, GetParam());
    if (round % 2 == 1)
    {
      std::replace_if(
        keys.begin(), keys.end(), [](int key) { return key > 20; },
        std::numeric_limits<int>::max()); // registers without a fragment
    }
    CompareExchange(sort, "COMPARE_EXCHANGE", keys);
    EXPECT_TRUE(std::is_sorted(keys.begin(), keys.end()));
  }
}

// Rounds of exchanges between neighbours order any run of equals, however long.
TEST_P(ShortResolve, OrdersTiesInAsManyRoundsAsItTakes)
{
  std::vector<int> keys(GetParam());
  std::iota(keys.rbegin(), keys.rend(), 0);
  const std::string ties = vitrine::UnrollResolve(GetParam(), 1).OrderTies;
  int rounds = 0;
  while (!std::is_sorted(keys.begin(), keys.end()) && rounds < GetParam())
  {
    CompareExchange(ties, "ORDER_TIE", keys);
    ++rounds;
  }
  EXPECT_LT(rounds, GetParam());
}

TEST_P(ShortResolve, AdvancesRegistersByOne)
{
  std::vector<int> registers(GetParam());
  std::iota(registers.begin(), registers.end(), 0);
  for (const Call& call : Calls(vitrine::UnrollResolve(GetParam(), 1).Advance))
  {
    const bool clears = call.Macro == "CLEAR";
    registers.at(call.Number(0)) = clears ? -1 : registers.at(call.Number(1));
  }
  std::vector<int> expected(GetParam());
  std::iota(expected.begin(), expected.end(), 1);
  expected.back() = -1;
  EXPECT_EQ(registers, expected);
}

INSTANTIATE_TEST_SUITE_P(
  Bins, ShortResolve, testing::Values(8, 16, 24, 32, 48, 64), testing::PrintToStringParamName());

void MoveSlots(const std::string& text, std::vector<int>& registers)
{
  std::array<int, 64> kept{};
  for (const Call& call : Calls(text))
  {
    if (call.Macro == "KEEP_SLOT")
    {
      kept.at(call.Number(1)) = registers.at(call.Number(0));
    }
    else if (call.Macro == "CLEAR_SLOT")
    {
      registers.at(call.Number(0)) = -1;
    }
    else
    {
      ASSERT_EQ(call.Macro, "MOVE_SLOT");
      const bool isKept = call.Operands[1].rfind("kept", 0) == 0;
      registers.at(call.Number(0)) =
        isKept ? kept.at(call.Number(1)) : registers.at(call.Number(1));
    }
  }
}

TEST(SlotResolve, MovesRegistersByAGroup)
{
  for (const int size : { 16, 32, 64 })
  {
    const int group = 8;
    const vitrine::SlotResolveText text = vitrine::UnrollSlotResolve(size, group);
    std::vector<int> ascending(size);
    std::iota(ascending.begin(), ascending.end(), 0);

    std::vector<int> up = ascending;
    MoveSlots(text.MoveUp, up);
    EXPECT_TRUE(std::equal(up.begin() + group, up.end(), ascending.begin()));

    std::vector<int> down = ascending;
    MoveSlots(text.MoveDown, down);
    EXPECT_TRUE(std::equal(ascending.begin() + group, ascending.end(), down.begin()));
    EXPECT_EQ(std::count(down.begin(), down.end(), -1), group);

    std::vector<int> advanced = ascending;
    MoveSlots(text.Advance, advanced);
    EXPECT_TRUE(std::equal(ascending.begin() + 1, ascending.end(), advanced.begin()));
    EXPECT_EQ(advanced.back(), -1);

    std::vector<int> rotated = ascending;
    for (int turn = 0; turn < size / group; ++turn)
    {
      EXPECT_EQ(rotated.front(), turn * group);
      MoveSlots(text.Rotate, rotated);
    }
    EXPECT_EQ(rotated, ascending);
  }
}

TEST(LongResolve, KeepsTheNearestBlock)
{
  std::mt19937 random(2);
  for (const int block : { 2, 4, 8, 32 })
  {
    const vitrine::LongResolveText text = vitrine::UnrollLongResolve(block);
    ExpectOneEach(text.Declare, "DECLARE", 0, 2 * block);
    ExpectOneEach(text.ClearNearest, "CLEAR", 0, block);
    ExpectOneEach(text.LoadBlock, "LOAD", block, 2 * block);
    ExpectOneEach(text.Blend, "BLEND", 0, block);
    ExpectOneEach(text.CountSame, "COUNT_SAME", 0, block);
    EXPECT_EQ(text.LastRegister, "f" + std::to_string(block - 1));
    for (int round = 0; round < 100; ++round)
    {
      std::vector<int> all;
      std::vector<int> registers(2 * block, std::numeric_limits<int>::max());
      for (int blocks = 0; blocks < 5; ++blocks)
      {
        const std::vector<int> loaded = RandomKeys(random, block);
        all.insert(all.end(), loaded.begin(), loaded.end());
        std::copy(loaded.begin(), loaded.end(), registers.begin() + block);
        CompareExchange(text.SortBlock, "COMPARE_EXCHANGE_FULL", registers);
        CompareExchange(text.MergeBlock, "COMPARE_EXCHANGE_FULL", registers);
      }
      std::sort(all.begin(), all.end());
      EXPECT_TRUE(std::equal(registers.begin(), registers.begin() + block, all.begin()))
        << "block " << block;
    }
  }
}

// A register, page and slot of a call such as `LOAD(f3, p1, 1)`.
using MacroPlace = std::array<int, 3>;

// The places of `macro`, in order, where `begin` stands before each page.
std::vector<MacroPlace> Places(
  const std::string& text, const std::string& begin, const std::string& macro)
{
  std::vector<MacroPlace> places;
  int pages = 0;
  for (const Call& call : Calls(text))
  {
    if (call.Macro == begin)
    {
      EXPECT_EQ(call.Number(0), pages++);
      continue;
    }
    EXPECT_EQ(call.Macro, macro);
    places.push_back({ call.Number(0), call.Number(1), call.Number(2) });
    EXPECT_TRUE(begin.empty() || places.back()[1] == pages - 1);
  }
  return places;
}

// Each slot of each page once, in registers from `first` on.
std::vector<MacroPlace> AllPlaces(int first, int size, int pageSize)
{
  std::vector<MacroPlace> places;
  for (int i = 0; i < size; ++i)
  {
    places.push_back({ first + i, i / pageSize, i % pageSize });
  }
  return places;
}

TEST(SortRuns, LoadSortAndStoreEachSlotOfEachPageOnce)
{
  std::mt19937 random(3);
  for (const int pageSize : { 1, 2, 4, 8 })
  {
    constexpr int size = 32;
    const vitrine::SortRunsText text = vitrine::UnrollSortRuns(size, pageSize);
    EXPECT_EQ(Places(text.Load, "TAKE_PAGE", "LOAD"), AllPlaces(0, size, pageSize));
    EXPECT_EQ(Places(text.Store, "", "STORE"), AllPlaces(0, size, pageSize));
    std::vector<int> keys = RandomKeys(random, size);
    CompareExchange(text.Sort, "COMPARE_EXCHANGE_FULL", keys);
    EXPECT_TRUE(std::is_sorted(keys.begin(), keys.end()));
  }
}

// Blocks pass through the upper registers, and the nearest stays in the lower ones.
TEST(SortLongRuns, LoadAndStoreEachSlotOfEachPageOnce)
{
  for (const int pageSize : { 1, 2, 4, 8 })
  {
    constexpr int block = 32;
    const vitrine::SortLongRunsText text = vitrine::UnrollSortLongRuns(block, pageSize);
    EXPECT_EQ(Places(text.Load, "TAKE_PAGE", "LOAD"), AllPlaces(block, block, pageSize));
    EXPECT_EQ(Places(text.Store, "", "STORE"), AllPlaces(block, block, pageSize));
    EXPECT_EQ(Places(text.StoreNearest, "TAKE_PAGE", "STORE"), AllPlaces(0, block, pageSize));
    ExpectOneEach(text.ClearNearest, "CLEAR", 0, block);
  }
}

TEST(MergeRuns, PutEachRunBackIntoItsGroup)
{
  const vitrine::MergeRunsText text = vitrine::UnrollMergeRuns(4, 2);
  EXPECT_EQ(text.Declare,
    "DECLARE_RUN(g0)\nDECLARE_RUN(r0)\nDECLARE_RUN(r1)\n"
    "DECLARE_RUN(g1)\nDECLARE_RUN(r2)\nDECLARE_RUN(r3)\n");
  EXPECT_EQ(text.FindNearest, "run = g0;\nTAKE_NEARER(run, g1)\n");
  EXPECT_EQ(text.PutBack,
    "if (number / 2u == 0u)\n{\nPUT_BACK(r0, 0u)\nPUT_BACK(r1, 1u)\n"
    "g0 = r0;\nTAKE_NEARER(g0, r1)\n}\n"
    "if (number / 2u == 1u)\n{\nPUT_BACK(r2, 2u)\nPUT_BACK(r3, 3u)\n"
    "g1 = r2;\nTAKE_NEARER(g1, r3)\n}\n");
}

}
