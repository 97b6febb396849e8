#include "OctreeScenes.h"

#include "Core/octree/OctreeQueries.h"
#include "Core/octree/OctreeStore.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace
{

using namespace octree_scenes;
using vitrine::ItemsTouching;
using vitrine::OctreeStore;
using vitrine::OrderFromEye;
using vitrine::WalkFrontToBack;

// A folder that is there while this is.
class Folder
{
public:
  Folder()
  {
    static std::atomic<int> number{ 0 };
    this->Path = std::filesystem::path(testing::TempDir()) /
      ("octree-" + std::to_string(std::random_device()()) + "-" + std::to_string(number++));
    std::filesystem::create_directory(this->Path);
  }
  ~Folder() { std::filesystem::remove_all(this->Path); }

  std::filesystem::path Path;

  std::filesystem::path File() const { return this->Path / "octree.pages"; }

  std::string Content() const
  {
    std::ifstream stream(this->File(), std::ios::binary);
    return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
  }

  void SetContent(const std::string& content) const
  {
    std::ofstream(this->File(), std::ios::binary) << content;
  }
};

// The leaves that a walk comes by, one after another.
struct WalkRecorder
{
  std::vector<std::uint32_t> Items;
  std::vector<Box> Nodes;

  bool Enter(const OctreeNode& node)
  {
    this->Nodes.push_back(node.Bounds);
    return true;
  }
  void Visit(const OctreeNode&, const std::uint32_t* items, std::uint32_t count)
  {
    this->Items.insert(this->Items.end(), items, items + count);
  }
};

WalkRecorder WalkFrom(const Octree& tree, const glm::vec3& eye)
{
  WalkRecorder recorder;
  WalkFrontToBack(tree, OrderFromEye(eye), recorder);
  return recorder;
}

std::uint32_t CountOf(const std::vector<Box>& boxes)
{
  return static_cast<std::uint32_t>(boxes.size());
}

TEST(OctreeStore, WalkOfATreeTenTimesTheBudgetIsTheSame)
{
  const unsigned seed = 50;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const std::vector<Box> boxes = RandomBoxes(Kinds::Small, 40000, random);
  const Octree tree(ViewOf(boxes));
  const Folder folder;
  OctreeStore::Write(tree, folder.Path, 4096);

  const std::size_t total = OctreeStore(folder.Path, 0, CountOf(boxes)).TotalBytes();
  EXPECT_GT(total, tree.Bytes() / 2);
  const std::size_t budget = total / 10;
  const auto store = std::make_shared<OctreeStore>(folder.Path, budget, CountOf(boxes));
  const Octree stored = OctreeStore::TreeOf(store);
  EXPECT_EQ(store->ReadCount(), 0u);
  EXPECT_LT(stored.Bytes(), tree.Bytes() / 10);
  for (int trial = 0; trial < 3; ++trial)
  {
    const glm::vec3 eye = RandomPoint(random, -1, 1);
    const WalkRecorder expected = WalkFrom(tree, eye);
    const WalkRecorder found = WalkFrom(stored, eye);
    EXPECT_EQ(found.Items, expected.Items);
    EXPECT_EQ(found.Nodes, expected.Nodes);
    EXPECT_LE(store->ResidentBytes(), budget);
    EXPECT_GT(store->ResidentBytes(), budget / 2);
  }
  CheckTree(stored, boxes);
}

TEST(OctreeStore, PagesAreReadOnceWhereTheBudgetHoldsThem)
{
  const unsigned seed = 51;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const std::vector<Box> boxes = RandomBoxes(Kinds::Small, 5000, random);
  const Folder folder;
  OctreeStore::Write(Octree(ViewOf(boxes), 8), folder.Path, 2048);
  const auto store = std::make_shared<OctreeStore>(folder.Path, 1u << 30, CountOf(boxes));
  const Octree stored = OctreeStore::TreeOf(store);
  const Box corner{ glm::vec3(-1), glm::vec3(-0.9f) };
  ItemsTouching(stored, ViewOf(boxes), corner);
  const std::uint64_t few = store->ReadCount();
  EXPECT_GT(few, 0u);
  WalkFrom(stored, glm::vec3(0));
  const std::uint64_t all = store->ReadCount();
  EXPECT_GT(all, 4 * few);
  WalkFrom(stored, glm::vec3(0));
  EXPECT_EQ(store->ReadCount(), all);
  EXPECT_EQ(store->ResidentBytes(), store->TotalBytes());
}

TEST(OctreeStore, WhatWasNeededLastStays)
{
  const unsigned seed = 52;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const std::vector<Box> boxes = RandomBoxes(Kinds::Small, 20000, random);
  const Folder folder;
  OctreeStore::Write(Octree(ViewOf(boxes), 8), folder.Path, 4096);
  const std::size_t total = OctreeStore(folder.Path, 0, CountOf(boxes)).TotalBytes();
  const auto store = std::make_shared<OctreeStore>(folder.Path, total / 4, CountOf(boxes));
  const Octree stored = OctreeStore::TreeOf(store);
  const Box corner{ glm::vec3(-1), glm::vec3(-0.9f) };
  ItemsTouching(stored, ViewOf(boxes), corner);
  const std::uint64_t first = store->ReadCount();
  // Asked for again and again, the corner's pages outlast those of all places that are asked for once.
  std::uint64_t reads = first;
  for (int i = 0; i < 200; ++i)
  {
    const glm::vec3 place = RandomPoint(random, -1, 1);
    ItemsTouching(stored, ViewOf(boxes), { place, place + 0.05f });
    reads = store->ReadCount();
    ItemsTouching(stored, ViewOf(boxes), corner);
    ASSERT_EQ(store->ReadCount(), reads);
  }
  EXPECT_GT(reads, first + 100);
}

TEST(OctreeStore, KeepsTreesOfAllKinds)
{
  const unsigned seed = 53;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (const Kinds kind : AllKinds())
  {
    for (const std::size_t count : { 0, 1, 700 })
    {
      const std::vector<Box> boxes = RandomBoxes(kind, count, random);
      const Folder folder;
      OctreeStore::Write(Octree(ViewOf(boxes), 2), folder.Path, 500);
      CheckTree(OctreeStore::Open(folder.Path, 2000, CountOf(boxes)), boxes);
    }
  }
}

TEST(OctreeStore, TreeThatWasChangedIsWrittenAsItIs)
{
  const unsigned seed = 54;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::vector<Box> boxes = RandomBoxes(Kinds::Mixed, 2000, random);
  Octree tree(ViewOf(boxes), 8);
  for (std::uint32_t item = 0; item < 1000; ++item)
  {
    const Octree::MovedItem move{ item, boxes[item] };
    boxes[item] = RandomBox(Kinds::Mixed, random);
    tree.Move(&move, 1, ViewOf(boxes));
  }
  const Folder folder;
  OctreeStore::Write(tree, folder.Path, 2048);
  CheckTree(OctreeStore::Open(folder.Path, 10000, 2000), boxes);
}

TEST(OctreeStore, IsWalkedByTwoThreadsAtOnce)
{
  const unsigned seed = 55;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const std::vector<Box> boxes = RandomBoxes(Kinds::Small, 10000, random);
  const Octree tree(ViewOf(boxes), 8);
  const Folder folder;
  OctreeStore::Write(tree, folder.Path, 2048);
  const Octree stored = OctreeStore::Open(folder.Path, 20000, CountOf(boxes));
  WalkRecorder here;
  WalkRecorder there;
  std::thread other([&] { there = WalkFrom(stored, glm::vec3(1)); });
  here = WalkFrom(stored, glm::vec3(-1));
  other.join();
  EXPECT_EQ(here.Items, WalkFrom(tree, glm::vec3(-1)).Items);
  EXPECT_EQ(there.Items, WalkFrom(tree, glm::vec3(1)).Items);
}

// The message with which opening and walking a tree fails; empty where it does not.
std::string FailureOf(const Folder& folder, std::uint32_t itemCount)
{
  try
  {
    WalkFrom(OctreeStore::Open(folder.Path, 0, itemCount), glm::vec3(0));
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}

TEST(OctreeStore, SaysWhatIsWrongWithAFile)
{
  const unsigned seed = 56;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const std::vector<Box> boxes = RandomBoxes(Kinds::Small, 1000, random);
  const Folder folder;
  EXPECT_NE(FailureOf(folder, 1000).find("cannot be opened"), std::string::npos);
  OctreeStore::Write(Octree(ViewOf(boxes), 8), folder.Path, 2048);
  EXPECT_EQ(FailureOf(folder, 1000), "");
  EXPECT_NE(FailureOf(folder, 999).find("other items"), std::string::npos);
  EXPECT_EQ(FailureOf(folder, 1000).find(".part"), std::string::npos);
  const std::string content = folder.Content();
  folder.SetContent("");
  EXPECT_NE(FailureOf(folder, 1000).find("not an octree"), std::string::npos);
  folder.SetContent("ply\nformat ascii 1.0\n" + std::string(1000, 'x'));
  EXPECT_NE(FailureOf(folder, 1000).find("not an octree"), std::string::npos);
  folder.SetContent(content.substr(0, content.size() - 1));
  EXPECT_NE(FailureOf(folder, 1000).find("truncated"), std::string::npos);
  folder.SetContent(content.substr(0, 60));
  EXPECT_NE(FailureOf(folder, 1000).find("truncated"), std::string::npos);
  std::string damaged = content;
  damaged[damaged.size() - 5] ^= 1;
  folder.SetContent(damaged);
  EXPECT_NE(FailureOf(folder, 1000).find("damaged"), std::string::npos);
  EXPECT_NE(FailureOf(folder, 1000).find(folder.File().string()), std::string::npos);
  EXPECT_THROW(OctreeStore::Write(Octree(), folder.Path / "missing"), std::runtime_error);
}

TEST(OctreeStore, NoByteOfAFileCanBeChangedUnnoticed)
{
  const unsigned seed = 57;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const std::vector<Box> boxes = RandomBoxes(Kinds::Hostile, 20, random);
  const Folder folder;
  OctreeStore::Write(Octree(ViewOf(boxes), 2), folder.Path, 300);
  const std::string content = folder.Content();
  for (std::size_t i = 0; i < content.size(); ++i)
  {
    std::string damaged = content;
    damaged[i] = static_cast<char>(damaged[i] ^ (1u << random() % 8));
    folder.SetContent(damaged);
    ASSERT_NE(FailureOf(folder, 20), "") << i;
    if (i % 16 != 0)
    {
      continue;
    }
    folder.SetContent(content.substr(0, i));
    ASSERT_NE(FailureOf(folder, 20), "") << i;
  }
}

}
