#include "Core/ranks/OpaquePixels.h"
#include "Core/ranks/SentLists.h"
#include "Core/ranks/TileOwners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace
{

using vitrine::Message;
using vitrine::OpaquePixels;
using vitrine::PixelLists;
using vitrine::PixelRegion;
using vitrine::TileOwners;

constexpr int PictureWidth = 150;
constexpr int PictureHeight = 70;
const PixelRegion WholePicture{ 0, 0, PictureWidth, PictureHeight };

const vitrine::OwnedPixels& AllPixels()
{
  static const TileOwners all(WholePicture, PictureWidth, 1);
  return all.PixelsOf(0);
}

// The nodes of a pixel. Their order does not matter.
using NodeSet = std::multiset<std::vector<std::uint32_t>>;

PixelLists MakeLists(std::mt19937& random, int texelWords, bool hasThirdWords)
{
  PixelLists lists;
  lists.Nodes.TexelWords = texelWords;
  lists.Nodes.HasThirdWords = hasThirdWords;
  std::uint32_t next = 3; // Nodes before belong to nobody.
  for (int pixel = 0; pixel < PictureWidth * PictureHeight; ++pixel)
  {
    const std::uint32_t count = pixel % 7 == 0 ? 0 : random() % 4;
    lists.Starts.push_back(next);
    lists.Counts.push_back(count);
    next += count + random() % 2; // Some room is left over.
  }
  lists.Nodes.Resize(next);
  std::generate(lists.Nodes.Texels.begin(), lists.Nodes.Texels.end(), std::ref(random));
  std::generate(lists.Nodes.ThirdWords.begin(), lists.Nodes.ThirdWords.end(), std::ref(random));
  return lists;
}

void AddNodes(const PixelLists& lists, int pixel, NodeSet& nodes)
{
  for (std::uint32_t i = 0; i < lists.Counts[pixel]; ++i)
  {
    const std::size_t at = lists.Starts[pixel] + i;
    const auto first = lists.Nodes.Texels.begin() + at * lists.Nodes.TexelWords;
    std::vector<std::uint32_t> node(first, first + lists.Nodes.TexelWords);
    if (lists.Nodes.HasThirdWords)
    {
      node.push_back(lists.Nodes.ThirdWords[at]);
    }
    nodes.insert(node);
  }
}

// Returns the messages that rank `to` gets from all ranks.
std::vector<Message> SendTo(int to, const std::vector<PixelLists>& ranks, const TileOwners& owners)
{
  std::vector<Message> messages;
  for (std::size_t rank = 0; rank < ranks.size(); ++rank)
  {
    messages.emplace_back();
    if (static_cast<int>(rank) != to)
    {
      vitrine::PackLists(ranks[rank], owners.PixelsOf(to), messages.back());
    }
  }
  return messages;
}

}

TEST(TileOwners, GiveEachPixelToOneRank)
{
  for (int ranks = 1; ranks <= 17; ++ranks)
  {
    const PixelRegion region{ 5, 40, 140, 90 };
    const TileOwners owners(region, PictureWidth, ranks);
    std::map<std::uint32_t, int> owner;
    for (int rank = 0; rank < ranks; ++rank)
    {
      for (const std::uint32_t pixel : owners.PixelsOf(rank))
      {
        EXPECT_TRUE(owner.emplace(pixel, rank).second);
        const int x = pixel % PictureWidth;
        const int y = pixel / PictureWidth;
        EXPECT_TRUE(x >= 5 && x < 145 && y >= 40 && y < 130);
        EXPECT_EQ(owners.OwnerOf(x / TileOwners::TileSize, y / TileOwners::TileSize), rank);
      }
    }
    EXPECT_EQ(owner.size(), std::size_t(region.Width) * region.Height);
    EXPECT_TRUE(owners.Divide(region, PictureWidth, ranks));
    EXPECT_FALSE(owners.Divide(WholePicture, PictureWidth, ranks));
  }
}

TEST(TileOwners, ShareWindowsFairly)
{
  for (const int ranks : { 2, 3, 4, 8, 16 })
  {
    const TileOwners owners({ 0, 0, 1280, 720 }, 1280, ranks);
    for (int rank = 0; rank < ranks; ++rank)
    {
      EXPECT_NEAR(owners.PixelsOf(rank).size() * ranks / (1280.0 * 720.0), 1.0, 0.06) << ranks;
    }
  }
}

TEST(SentLists, HaveTheNodesOfAllRanks)
{
  std::mt19937 random(54);
  for (const int texelWords : { 2, 4 })
  {
    for (const bool hasThirdWords : { false, true })
    {
      std::vector<PixelLists> ranks;
      for (int rank = 0; rank < 3; ++rank)
      {
        ranks.push_back(MakeLists(random, texelWords, hasThirdWords));
      }
      const TileOwners owners(WholePicture, PictureWidth, 3);
      for (int owner = 0; owner < 3; ++owner)
      {
        PixelLists joined;
        ASSERT_EQ(vitrine::JoinLists(ranks[owner], owners.PixelsOf(owner),
                    SendTo(owner, ranks, owners), 100, joined),
          "");
        for (int pixel = 0; pixel < PictureWidth * PictureHeight; ++pixel)
        {
          const bool isOwned = owners.OwnerOf(pixel % PictureWidth / TileOwners::TileSize,
                                 pixel / PictureWidth / TileOwners::TileSize) == owner;
          NodeSet expected;
          NodeSet found;
          for (const PixelLists& lists : ranks)
          {
            if (isOwned)
            {
              AddNodes(lists, pixel, expected);
            }
          }
          AddNodes(joined, pixel, found);
          ASSERT_EQ(found, expected);
        }
      }
    }
  }
}

TEST(SentLists, TakeLittleMoreThanTheirNodes)
{
  PixelLists lists;
  lists.Nodes.HasThirdWords = true;
  for (std::uint32_t pixel = 0; pixel < PictureWidth * PictureHeight; ++pixel)
  {
    lists.Starts.push_back(2 * pixel);
    lists.Counts.push_back(2);
  }
  lists.Nodes.Resize(2 * lists.Counts.size());
  Message message;
  vitrine::PackLists(lists, AllPixels(), message);
  EXPECT_EQ(message.size(), 12 * 2 * lists.Counts.size() + 3); // one run
  message.clear();
  std::fill(lists.Counts.begin(), lists.Counts.end(), 0u);
  vitrine::PackLists(lists, AllPixels(), message);
  EXPECT_TRUE(message.empty());
}

TEST(SentLists, AreRefusedIfTheyDoNotFit)
{
  std::mt19937 random(54);
  const PixelLists lists = MakeLists(random, 2, true);
  Message good;
  vitrine::PackLists(lists, AllPixels(), good);
  PixelLists joined;
  const auto join = [&](const Message& message, std::uint64_t most)
  { return vitrine::JoinLists(lists, AllPixels(), { message }, most, joined); };
  EXPECT_EQ(join(good, 100), "");
  EXPECT_NE(join(good, 6).find("6 fragments of all ranks"), std::string::npos);
  for (std::size_t size = 1; size < good.size(); size += 997)
  {
    EXPECT_NE(join(Message(good.begin(), good.begin() + size), 100), "") << size;
  }
  Message longer = good;
  longer.push_back(0);
  EXPECT_NE(join(longer, 100), "");
  for (int i = 0; i < 300; ++i)
  {
    Message damaged = good;
    damaged[random() % 500] = static_cast<unsigned char>(random()); // a number of nodes
    join(damaged, 100);                                             // must end
  }
}

namespace
{

OpaquePixels MakeOpaque(std::mt19937& random, int colorWords, int samples)
{
  OpaquePixels picture;
  picture.Samples = samples;
  picture.ColorWords = colorWords;
  for (int sample = 0; sample < samples * PictureWidth * PictureHeight; ++sample)
  {
    picture.Depths.push_back(random() % 3 == 0 ? picture.Farthest : random() % 4);
    for (int word = 0; word < colorWords; ++word)
    {
      picture.Colors.push_back(random() % 5);
    }
  }
  return picture;
}

// Depths in the order of messages: all samples of a pixel, and then those of the next.
std::vector<std::uint32_t> InOrder(const OpaquePixels& picture)
{
  std::vector<std::uint32_t> ordered;
  for (const std::uint32_t pixel : AllPixels())
  {
    for (int sample = 0; sample < picture.Samples; ++sample)
    {
      ordered.push_back(picture.Depths[sample * PictureWidth * PictureHeight + pixel]);
    }
  }
  return ordered;
}

}

class OpaquePixelSamples : public testing::TestWithParam<int> // samples
{
};

TEST_P(OpaquePixelSamples, AreTheNearestWhateverTheOrderOfRanks)
{
  std::mt19937 random(54);
  for (const int colorWords : { 1, 4 })
  {
    std::vector<OpaquePixels> ranks;
    std::vector<Message> messages(4);
    for (int rank = 0; rank < 4; ++rank)
    {
      ranks.push_back(MakeOpaque(random, colorWords, GetParam()));
      vitrine::PackOpaque(ranks.back(), AllPixels(), messages[rank]);
    }
    std::vector<OpaquePixels> combined;
    for (const std::vector<int>& order : { std::vector<int>{ 1, 2, 3 }, { 3, 2, 1 } })
    {
      combined.push_back(ranks[0]);
      for (const int rank : order)
      {
        std::vector<std::uint32_t> depths;
        ASSERT_TRUE(vitrine::TakeNearer(messages[rank], AllPixels(), combined.back(), depths));
        EXPECT_EQ(depths, InOrder(ranks[rank]));
      }
    }
    EXPECT_EQ(combined[0].Depths, combined[1].Depths);
    for (std::size_t sample = 0; sample < ranks[0].Depths.size(); ++sample)
    {
      std::uint32_t nearest = ranks[0].Farthest;
      for (const OpaquePixels& rank : ranks)
      {
        nearest = std::min(nearest, rank.Depths[sample]);
      }
      ASSERT_EQ(combined[0].Depths[sample], nearest);
      for (int word = 0; word < colorWords && nearest < ranks[0].Farthest; ++word)
      {
        ASSERT_EQ(combined[0].Colors[sample * colorWords + word],
          combined[1].Colors[sample * colorWords + word]);
      }
    }
    Message told; // Rank 3 learns where others are nearer.
    vitrine::PackDepths(combined[0], AllPixels(), InOrder(ranks[3]), told);
    ASSERT_TRUE(vitrine::TakeDepths(told, AllPixels(), ranks[3]));
    EXPECT_EQ(ranks[3].Depths, combined[0].Depths);
    Message colors;
    vitrine::PackColors(combined[0], AllPixels(), colors);
    ASSERT_TRUE(vitrine::TakeColors(colors, AllPixels(), ranks[2]));
    EXPECT_EQ(ranks[2].Colors, combined[0].Colors);
  }
}

TEST_P(OpaquePixelSamples, AreRefusedIfTheyDoNotFit)
{
  std::mt19937 random(54);
  OpaquePixels picture = MakeOpaque(random, 1, GetParam());
  const OpaquePixels before = picture;
  Message good;
  vitrine::PackOpaque(picture, AllPixels(), good);
  std::vector<std::uint32_t> depths;
  EXPECT_TRUE(vitrine::TakeNearer({}, AllPixels(), picture, depths));
  EXPECT_EQ(picture.Depths, before.Depths);
  for (std::size_t size = 1; size < good.size(); size += 1009)
  {
    const Message cut(good.begin(), good.begin() + size);
    EXPECT_FALSE(vitrine::TakeNearer(cut, AllPixels(), picture, depths)) << size;
    EXPECT_FALSE(vitrine::TakeDepths(cut, AllPixels(), picture)) << size;
  }
  EXPECT_FALSE(vitrine::TakeColors({}, AllPixels(), picture));
  for (int i = 0; i < 50; ++i)
  {
    Message damaged = good;
    damaged[random() % damaged.size()] = static_cast<unsigned char>(random());
    vitrine::TakeNearer(damaged, AllPixels(), picture, depths); // must end
    vitrine::TakeColors(damaged, AllPixels(), picture);
  }
}

INSTANTIATE_TEST_SUITE_P(Counts, OpaquePixelSamples, testing::Values(1, 4, 5));

// A picker of all ranks joins layers in the same order (JoinLayers() of Core/lists/PixelLayers).
TEST(OpaquePixels, OfOneDepthHaveTheColorWithMoreBlue)
{
  const auto pictureOf = [](float red, float blue)
  {
    constexpr std::size_t pixels = std::size_t(PictureWidth) * PictureHeight;
    const float color[4] = { red, 0.2f, blue, 1.0f };
    OpaquePixels picture;
    picture.ColorWords = 4;
    picture.Depths.assign(pixels, 7u);
    picture.Colors.resize(4 * pixels);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
    {
      std::memcpy(&picture.Colors[4 * pixel], color, sizeof(color));
    }
    return picture;
  };
  const OpaquePixels red = pictureOf(0.9f, 0.1f);
  const OpaquePixels blue = pictureOf(0.1f, 0.9f);
  for (const bool isRedFirst : { false, true })
  {
    OpaquePixels combined = isRedFirst ? red : blue;
    Message message;
    vitrine::PackOpaque(isRedFirst ? blue : red, AllPixels(), message);
    std::vector<std::uint32_t> depths;
    ASSERT_TRUE(vitrine::TakeNearer(message, AllPixels(), combined, depths));
    for (const std::uint32_t pixel : AllPixels())
    {
      ASSERT_EQ(combined.Colors[4 * pixel], blue.Colors[4 * pixel]);
    }
  }
}

// Within a pixel most samples have one colour. A message has it once, and one run for all samples after the first.
TEST(OpaquePixels, TellAColorOnceForTheSamplesOfAPixel)
{
  constexpr std::size_t pixels = std::size_t(PictureWidth) * PictureHeight;
  OpaquePixels picture;
  picture.Samples = 4;
  picture.Depths.assign(4 * pixels, 7u);
  picture.Colors.assign(4 * pixels, 0x11223344u);
  const auto bytesOf = [&](auto* pack)
  {
    Message message;
    pack(picture, AllPixels(), message);
    return message.size();
  };
  EXPECT_EQ(bytesOf(vitrine::PackColors), 1 + 4 * pixels);
  EXPECT_EQ(bytesOf(vitrine::PackOpaque), 1 + 1 + 3 + 4 * 4 * pixels + 1 + 4 * pixels);
  picture.Colors[2 * pixels + AllPixels()[0]] = 5u; // and sample 3 has the first colour again
  EXPECT_EQ(bytesOf(vitrine::PackColors), 1 + 2 + 4 * (pixels + 2));
}
