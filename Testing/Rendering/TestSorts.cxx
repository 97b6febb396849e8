// Every sort of every size on the device, against std::sort: keys in order, each with its own payload.
#include "TestMessages.h"
#include "TestScene.h"
#include "gl/Capabilities.h"
#include "study/shaders/SortLayout.h"
#include "study/sorts/SortHarness.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>

namespace
{

using vitrine::ListSort;
using vitrine::SortElement;
using vitrine::SortHarness;
using vitrine::SortList;

constexpr std::uint64_t Seed = 65536;

std::uint32_t BitsOf(float depth)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &depth, sizeof(bits));
  return bits;
}

const std::uint32_t Infinity = BitsOf(std::numeric_limits<float>::infinity());

// A list whose keys are as `key` has them for each index; payloads differ, so that they tell elements apart.
template <class Key>
SortList MakeList(int length, TestRandom& random, Key key)
{
  SortList list;
  const auto first = static_cast<std::uint32_t>(random.Next());
  for (int i = 0; i < length; ++i)
  {
    list.push_back({ key(i), first + 2654435761u * static_cast<std::uint32_t>(i) });
  }
  return list;
}

std::uint32_t RandomDepth(TestRandom& random)
{
  return BitsOf(static_cast<float>(random.Unit()));
}

// Lists of every length from 0 to `capacity`, of every kind that a sort might stumble over.
std::vector<SortList> ListsOfAllKinds(int capacity)
{
  TestRandom random(Seed);
  std::vector<SortList> lists;
  for (int length = 0; length <= capacity; ++length)
  {
    for (int trial = 0; trial < 20; ++trial)
    {
      lists.push_back(MakeList(length, random, [&](int) { return RandomDepth(random); }));
      lists.push_back(MakeList(
        length, random, [&](int) { return static_cast<std::uint32_t>(random.Next() % 3); }));
      lists.push_back(MakeList(length, random,
        [&](int) { return random.Next() % 4 == 0 ? Infinity : RandomDepth(random); }));
    }
    lists.push_back(MakeList(length, random, [&](int i) { return BitsOf(static_cast<float>(i)); }));
    lists.push_back(
      MakeList(length, random, [&](int i) { return BitsOf(static_cast<float>(length - i)); }));
    lists.push_back(MakeList(length, random, [](int) { return BitsOf(0.5f); }));
    lists.push_back(MakeList(length, random, [](int) { return Infinity; }));
    lists.push_back(MakeList(length, random, [](int) { return 0u; }));
    lists.push_back(MakeList(length, random, [](int) { return 0xfffffffeu; }));
    lists.push_back(MakeList(length, random, [&](int i) { return i == 0 ? Infinity : 0u; }));
  }
  return lists;
}

// Of zeros and ones all that are as long as 2^12 of them allow.
std::vector<SortList> ZeroOneLists(int capacity)
{
  const int length = std::min(capacity, 12);
  TestRandom random(Seed);
  std::vector<SortList> lists;
  for (std::uint32_t ones = 0; ones < 1u << length; ++ones)
  {
    lists.push_back(MakeList(length, random, [&](int i) { return ones >> i & 1u; }));
  }
  return lists;
}

bool KeyLess(const SortElement& a, const SortElement& b)
{
  return a.Key < b.Key;
}

// std::sort's own, with equal keys ordered by payload: what has to be there, in whatever order among equals.
SortList Canonical(SortList list)
{
  std::sort(list.begin(), list.end(),
    [](const SortElement& a, const SortElement& b)
    { return a.Key < b.Key || (a.Key == b.Key && a.Payload < b.Payload); });
  return list;
}

bool Same(const SortList& a, const SortList& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const SortElement& x, const SortElement& y)
    { return x.Key == y.Key && x.Payload == y.Payload; });
}

void ExpectSorted(const std::vector<SortList>& lists, const std::vector<SortList>& sorted)
{
  ASSERT_EQ(sorted.size(), lists.size());
  for (std::size_t l = 0; l < lists.size(); ++l)
  {
    ASSERT_TRUE(std::is_sorted(sorted[l].begin(), sorted[l].end(), KeyLess))
      << "list " << l << " of " << lists[l].size();
    ASSERT_TRUE(Same(Canonical(lists[l]), Canonical(sorted[l])))
      << "list " << l << " of " << lists[l].size() << " has lost or mixed up elements";
  }
}

std::vector<std::array<std::uint32_t, 2>> ChecksumsOf(
  const std::vector<SortList>& lists, int capacity)
{
  std::vector<std::array<std::uint32_t, 2>> checksums;
  for (const SortList& list : lists)
  {
    checksums.push_back(vitrine::ListChecksum(list, capacity));
  }
  return checksums;
}

class Sorts : public testing::Test
{
protected:
  Sorts()
  {
    WatchOpenGL(this->Window);
    this->Harness.emplace(vtkOpenGLRenderWindow::SafeDownCast(this->Window));
  }
  ~Sorts() override { this->Harness.reset(); }
  void SetUp() override
  {
    const std::string missing = this->Harness->FindMissingFeature();
    if (!missing.empty())
    {
      GTEST_SKIP() << missing;
    }
  }
  vtkNew<vtkRenderWindow> Window;
  std::optional<SortHarness> Harness;
};

//------------------------------------------------------------------------------
struct SortCase
{
  ListSort Sort;
  int Capacity;
};

std::vector<SortCase> AllCases()
{
  std::vector<SortCase> cases;
  for (const ListSort sort : vitrine::AllListSorts)
  {
    for (const int capacity : { 2, 4, 8, 16, 32, 64 })
    {
      cases.push_back({ sort, capacity });
    }
  }
  return cases;
}

class EverySort
  : public Sorts
  , public testing::WithParamInterface<SortCase>
{
};

TEST_P(EverySort, SortsAsTheStandardLibraryDoes)
{
  const auto [sort, capacity] = GetParam();
  SCOPED_TRACE(Seed);
  for (const std::vector<SortList>& lists : { ListsOfAllKinds(capacity), ZeroOneLists(capacity) })
  {
    ASSERT_EQ(this->Harness->SetLists(lists, capacity), "");
    const std::optional<std::vector<SortList>> sorted = this->Harness->SortAndRead(sort);
    ASSERT_TRUE(sorted.has_value());
    ExpectSorted(lists, *sorted);
    if (capacity > 32)
    {
      continue; // the other shader takes long to compile
    }
    const std::optional<double> milliseconds = this->Harness->Sort(sort);
    ASSERT_TRUE(milliseconds.has_value());
    EXPECT_GT(*milliseconds, 0.0);
    EXPECT_EQ(this->Harness->ReadChecksums(), ChecksumsOf(*sorted, capacity));
  }
}

std::string CaseName(const testing::TestParamInfo<SortCase>& info)
{
  std::string name = vitrine::NameOf(info.param.Sort) + std::to_string(info.param.Capacity);
  name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
  return name;
}

INSTANTIATE_TEST_SUITE_P(OfEverySize, EverySort, testing::ValuesIn(AllCases()), CaseName);

//------------------------------------------------------------------------------
TEST_F(Sorts, AlwaysBeginWithWhatWasSet)
{
  const std::vector<SortList> lists = { { { 3, 1 }, { 1, 2 }, { 2, 3 } }, {}, { { 9, 4 } } };
  ASSERT_EQ(this->Harness->SetLists(lists, 4), "");
  const std::optional<std::vector<SortList>> sorted = this->Harness->SortAndRead(ListSort::Network);
  ASSERT_TRUE(sorted.has_value());
  EXPECT_TRUE(Same((*sorted)[0], { { 1, 2 }, { 2, 3 }, { 3, 1 } }));
  ASSERT_TRUE(this->Harness->Sort(ListSort::Shell));
  EXPECT_EQ(this->Harness->ReadChecksums(), ChecksumsOf(*sorted, 4));
  ASSERT_TRUE(this->Harness->Copy());
  EXPECT_EQ(this->Harness->ReadChecksums(), ChecksumsOf(lists, 4));
}

// As often as it is repeated a list is sorted with other bits of its keys flipped, and the checksum goes on.
TEST_F(Sorts, RepeatWithKeysInAnotherOrder)
{
  constexpr int capacity = 8;
  constexpr int repeats = 3;
  TestRandom random(Seed);
  std::vector<SortList> lists;
  for (int length = 0; length <= capacity; ++length)
  {
    lists.push_back(MakeList(length, random, [&](int) { return RandomDepth(random); }));
  }
  std::uint32_t shift = 1;
  for (int i = 0; i < capacity; ++i)
  {
    shift *= VITRINE_CHECKSUM_FACTOR;
  }
  std::vector<std::array<std::uint32_t, 2>> expected;
  for (const SortList& list : lists)
  {
    std::array<std::uint32_t, 2> all = { 0, 0 };
    for (std::uint32_t repeat = 0; repeat < repeats; ++repeat)
    {
      SortList flipped = list;
      for (SortElement& element : flipped)
      {
        element.Key ^= repeat * VITRINE_CHECKSUM_FACTOR & 0x7fffffffu;
      }
      const auto checksum = vitrine::ListChecksum(Canonical(flipped), capacity);
      all = { all[0] * shift + checksum[0], all[1] + checksum[1] };
    }
    expected.push_back(all);
  }
  ASSERT_EQ(this->Harness->SetLists(lists, capacity), "");
  for (const ListSort sort : vitrine::AllListSorts)
  {
    SCOPED_TRACE(vitrine::NameOf(sort));
    ASSERT_TRUE(this->Harness->Sort(sort, repeats).has_value());
    EXPECT_EQ(this->Harness->ReadChecksums(), expected);
  }
}

TEST_F(Sorts, RefuseWhatTheyCannotSort)
{
  const std::vector<SortList> one = { { { 1, 1 } } };
  for (const int capacity : { -4, 0, 1, 3, 6, 65, 128 })
  {
    EXPECT_EQ(this->Harness->SetLists(one, capacity),
      "storage for " + std::to_string(capacity) + " elements is no power of two from 2 to 64");
  }
  EXPECT_EQ(this->Harness->SetLists({}, 4), "there are no lists");
  EXPECT_EQ(this->Harness->SetLists({ SortList(5, { 1, 1 }) }, 4),
    "a list of 5 elements does not fit into storage for 4");
  EXPECT_EQ(this->Harness->SetLists({ { { 0xffffffffu, 1 } } }, 4),
    "the key 0xffffffff marks unused elements and cannot be sorted");
  EXPECT_FALSE(this->Harness->Sort(ListSort::Shell).has_value());
  EXPECT_FALSE(this->Harness->SortAndRead(ListSort::Shell).has_value());
  EXPECT_TRUE(this->Harness->ReadChecksums().empty());
}

TEST_F(Sorts, RefuseMoreThanTheDriverHolds)
{
  const std::int64_t bytes = 64 * sizeof(SortElement);
  const auto count = static_cast<std::size_t>(vitrine::LargestStorageBlock() / bytes + 1);
  EXPECT_EQ(this->Harness->SetLists(std::vector<SortList>(count), 64),
    std::to_string(count) + " lists are more than the driver's buffers hold");
}

}
