// Prefix sums over pictures of any size, without drawing: the room of each list begins where that before it ends.
#include "Shaders/SharedLayout.h"
#include "TestMessages.h"
#include "TestScene.h"
#include "gl/MemoryBarriers.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "transparency/abuffer/ListHeads.h"
#include "transparency/abuffer/PackedScan.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace
{

using vitrine::BlockRange;

constexpr int Side = VITRINE_BLOCK_SIZE;
constexpr std::uint64_t Largest = 0xffffffffu;

struct Case
{
  const char* Name;
  BlockRange Blocks;                       // of an image that ends with them
  std::function<std::uint32_t(int)> Value; // of a pixel, or of a block, by its number
  std::uint32_t Capacity = 0xffffffffu;
};

void PrintTo(const Case& c, std::ostream* os)
{
  *os << c.Name;
}

std::uint32_t Few(int i)
{
  return static_cast<std::uint32_t>(i) * 2654435761u >> 28;
}

// Levels of sums have 128 times fewer values each: 1, 2, 3 and 4 of them, full and not.
const Case Cases[] = {
  { "OneBlock", { { 0, 0 }, { 1, 1 } }, Few },
  { "LessThanASumHolds", { { 0, 0 }, { 127, 1 } }, Few },
  { "AsManyAsASumHolds", { { 0, 0 }, { 128, 1 } }, Few },
  { "OneMoreThanASumHolds", { { 0, 0 }, { 1, 129 } }, Few },
  { "AsManyAsTwoLevelsHold", { { 0, 0 }, { 128, 128 } }, Few },
  { "OneRowMoreThanTwoLevelsHold", { { 0, 0 }, { 128, 129 } }, Few },
  { "APartOfThePicture", { { 5, 3 }, { 17, 11 } }, Few },
  { "Nothing", { { 0, 0 }, { 20, 20 } }, [](int) { return 0u; } },
  { "OneLongList", { { 0, 0 }, { 20, 20 } }, [](int i) { return i == 77 ? 60000u : 0u; } },
  { "NoRoomForTheLast", { { 0, 0 }, { 20, 20 } }, Few, 7001 },
  { "NoRoomAtAll", { { 0, 0 }, { 20, 20 } }, Few, 0 },
  { "MoreThan2To24", { { 0, 0 }, { 20, 20 } }, [](int i) { return 3000u + Few(i); } },
  { "MoreThan2To32", { { 0, 0 }, { 128, 40 } }, [](int i) { return 0xfff0u + Few(i) % 15u; },
    1u << 20 },
};

// Places in order, none beyond `capacity`, and the sum of all that was asked for.
struct Rooms
{
  explicit Rooms(std::uint32_t capacity)
    : Capacity(capacity)
  {
  }
  // Where the next list begins, and its room.
  std::array<std::uint32_t, 2> Take(std::uint32_t length)
  {
    const std::uint32_t begin = this->Bounded(this->Total);
    this->Total = std::min(this->Total + length, Largest);
    return { begin, this->Bounded(this->Total) - begin };
  }
  std::uint32_t Bounded(std::uint64_t place) const
  {
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(place, this->Capacity));
  }
  std::uint32_t Capacity;
  std::uint64_t Total = 0;
};

class PackedScan : public testing::TestWithParam<std::tuple<Case, bool>>
{
protected:
  PackedScan()
  {
    WatchOpenGL(this->Scene.Window);
    this->Scene.Render();
    this->Layout.Packed = true;
    this->Layout.FramebufferFetch = std::get<1>(GetParam());
    this->Target.Width = this->Width();
    this->Target.Height = this->Height();
  }
  ~PackedScan() override
  {
    this->Scan.Release();
    this->Heads.Release();
  }

  static const Case& Parameters() { return std::get<0>(GetParam()); }
  static const BlockRange& Blocks() { return Parameters().Blocks; }
  static int Width() { return Side * (Blocks().First[0] + Blocks().Count[0]); }
  static int Height() { return Side * (Blocks().First[1] + Blocks().Count[1]); }

  vtkOpenGLRenderWindow* Window() const
  {
    return vtkOpenGLRenderWindow::SafeDownCast(this->Scene.Window);
  }

  // Call `visit` for the index of each pixel, in the order of their lists.
  static void VisitPixels(const std::function<void(std::size_t)>& visit)
  {
    for (int block = 0; block < Blocks().Size(); ++block)
    {
      const int x = Side * (Blocks().First[0] + block % Blocks().Count[0]);
      const int y = Side * (Blocks().First[1] + block / Blocks().Count[0]);
      for (int i = 0; i < Side * Side; ++i)
      {
        visit(static_cast<std::size_t>(y + i / Side) * Width() + x + i % Side);
      }
    }
  }

  // Heads as a fill without room leaves them: the words of a pixel are 0 and its number of fragments, shifted.
  void WriteCounts(const std::vector<std::uint32_t>& counts)
  {
    ASSERT_EQ(this->Heads.Prepare(
                this->Window()->GetState(), this->Target, this->Layout.FramebufferFetch, 0u, Side),
      "");
    std::vector<std::uint32_t> words;
    for (int y = 0; y < Height(); ++y)
    {
      const std::uint32_t* row = &counts[static_cast<std::size_t>(y) * Width()];
      if (this->Layout.FramebufferFetch)
      {
        std::for_each(row, row + Width(),
          [&](std::uint32_t n) {
            words.insert(words.end(), { 0u, n << VITRINE_COUNT_SHIFT });
          });
      }
      else
      {
        words.insert(words.end(), Width(), 0u);
        std::transform(row, row + Width(), std::back_inserter(words),
          [](std::uint32_t n) { return n << VITRINE_COUNT_SHIFT; });
      }
    }
    this->Fill(this->Heads.Image(), words);
  }

  void Fill(const vitrine::Image2D& image, const std::vector<std::uint32_t>& words)
  {
    const bool isPairs =
      image.Handle() == this->Heads.Image().Handle() && this->Layout.FramebufferFetch;
    const int width = image.Handle() == this->Heads.Image().Handle() ? Width() : Width() / Side;
    const auto height = static_cast<int>(words.size()) / width / (isPairs ? 2 : 1);
    const vitrine::ScopedTextureUnit unit(
      this->Window()->GetState(), GL_TEXTURE_2D, image.Handle());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, isPairs ? GL_RG_INTEGER : GL_RED_INTEGER,
      GL_UNSIGNED_INT, words.data());
  }

  // Expect the rooms of lists as long as `length` says of the pixel with that index.
  void ExpectRooms(const std::function<std::uint32_t(std::size_t)>& length)
  {
    const std::vector<std::uint32_t> heads = this->Heads.Read(this->Window()->GetState());
    Rooms rooms(Parameters().Capacity);
    int wrong = 0;
    VisitPixels(
      [&](std::size_t pixel)
      {
        const auto [begin, room] = rooms.Take(length(pixel));
        wrong += heads[2 * pixel] != begin || heads[2 * pixel + 1] != room;
      });
    EXPECT_EQ(wrong, 0) << "of " << heads.size() / 2;
    EXPECT_EQ(this->Scan.ReadTotal(), rooms.Total);
  }

  TestScene Scene = TestScene(4, 4);
  vitrine::RenderTarget Target;
  vitrine::ListLayout Layout;
  vitrine::ListHeads Heads;
  vitrine::PackedScan Scan;
};

TEST_P(PackedScan, PlacesWhatWasCounted)
{
  std::vector<std::uint32_t> counts(static_cast<std::size_t>(Width()) * Height());
  int number = 0;
  VisitPixels([&](std::size_t pixel) { counts[pixel] = Parameters().Value(number++); });
  this->WriteCounts(counts);
  ASSERT_EQ(this->Scan.PlaceCounted(this->Window(), this->Layout, this->Heads,
              PixelsOf(Blocks(), Side), Parameters().Capacity),
    "");
  this->ExpectRooms([&](std::size_t pixel) { return counts[pixel]; });
}

// Lists that are longer than their room count on past its end: of these, too, all are placed anew.
TEST_P(PackedScan, PlacesAgainWhatCountedOn)
{
  std::vector<std::uint32_t> counts(static_cast<std::size_t>(Width()) * Height());
  int number = 0;
  VisitPixels([&](std::size_t pixel) { counts[pixel] = Parameters().Value(number++) / 2; });
  this->WriteCounts(counts);
  ASSERT_EQ(this->Scan.PlaceCounted(this->Window(), this->Layout, this->Heads,
              PixelsOf(Blocks(), Side), Parameters().Capacity),
    "");
  // The fill: every pixel has three fragments more than room.
  std::vector<std::uint32_t> heads = this->Heads.Read(this->Window()->GetState());
  std::vector<std::uint32_t> taken(counts.size());
  VisitPixels(
    [&](std::size_t pixel)
    {
      taken[pixel] = std::min(heads[2 * pixel + 1] + 3, VITRINE_LARGEST_COUNT);
      heads[2 * pixel + 1] |= taken[pixel] << VITRINE_COUNT_SHIFT;
    });
  std::vector<std::uint32_t> words = heads;
  if (!this->Layout.FramebufferFetch)
  {
    for (std::size_t i = 0; i < counts.size(); ++i)
    {
      const std::size_t row = i / Width();
      words[2 * row * Width() + i % Width()] = heads[2 * i];
      words[(2 * row + 1) * Width() + i % Width()] = heads[2 * i + 1];
    }
  }
  this->Fill(this->Heads.Image(), words);
  ASSERT_EQ(this->Scan.PlaceCounted(this->Window(), this->Layout, this->Heads,
              PixelsOf(Blocks(), Side), Parameters().Capacity),
    "");
  this->ExpectRooms([&](std::size_t pixel) { return taken[pixel]; });
}

TEST_P(PackedScan, PlacesWhatIsExpected)
{
  const int columns = Width() / Side;
  const int rows = Height() / Side;
  std::vector<std::uint32_t> longest(
    static_cast<std::size_t>(columns) * rows, 1u << 30); // of others
  const auto inRange = [](int block, int axis)
  {
    return std::clamp(block, Blocks().First[axis], Blocks().First[axis] + Blocks().Count[axis] - 1);
  };
  for (int block = 0; block < Blocks().Size(); ++block)
  {
    const int x = Blocks().First[0] + block % Blocks().Count[0];
    const int y = Blocks().First[1] + block / Blocks().Count[0];
    longest[static_cast<std::size_t>(y) * columns + x] = Parameters().Value(block);
  }
  this->WriteCounts(std::vector<std::uint32_t>(static_cast<std::size_t>(Width()) * Height()));
  vitrine::Image2D image;
  ASSERT_EQ(image.Allocate(GL_R32UI, columns, rows, 0), "");
  this->Fill(image, longest);
  ASSERT_EQ(this->Scan.PlacePredicted(this->Window(), this->Layout, this->Heads, image.Handle(),
              Blocks(), Parameters().Capacity),
    "");
  this->ExpectRooms(
    [&](std::size_t pixel)
    {
      const int x = static_cast<int>(pixel) % Width() / Side;
      const int y = static_cast<int>(pixel) / Width() / Side;
      std::uint32_t room = 0;
      for (int i = 0; i < 9; ++i)
      {
        const int row = inRange(y + i / 3 - 1, 1);
        room = std::max(
          room, longest[static_cast<std::size_t>(row) * columns + inRange(x + i % 3 - 1, 0)]);
      }
      return room;
    });
  image.Release();
}

INSTANTIATE_TEST_SUITE_P(Pictures, PackedScan,
  testing::Combine(testing::ValuesIn(Cases), testing::Bool()),
  [](const auto& info)
  {
    return std::string(std::get<0>(info.param).Name) +
      (std::get<1>(info.param) ? "InOneTexel" : "InTwoRows");
  });

}
