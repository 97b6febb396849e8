// Bands of a screen that are culled by themselves, at the same time.
#include "PartScenes.h"

#include "Core/culling/walk/PartCuller.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace
{

using coverage::AheadView;
using coverage::FrameColumns;
using coverage::FrameLines;
using coverage::PartScene;
using coverage::Random;
using coverage::SightLines;
using coverage::Triangles;
using coverage::View;
using coverage::WallAt;
using vitrine::PartCuller;
using vitrine::SampleGrid;
using vitrine::ScreenProjection;

PartCuller InBands(int count)
{
  return PartCuller(FrameColumns, FrameLines, SampleGrid(), count);
}

int LinesOf(const PartCuller& culler)
{
  int lines = 0;
  for (std::size_t i = 0; i < culler.BandCount(); ++i)
  {
    lines += culler.Buffer(i).Lines();
  }
  return lines;
}

std::ptrdiff_t CountVisible(const std::vector<std::uint8_t>& visible)
{
  return std::count(visible.begin(), visible.end(), 1);
}

}

TEST(PartBands, AreAllOfTheScreen)
{
  for (const int count : { 1, 2, 3, 4, 7, FrameLines, FrameLines + 9 })
  {
    SCOPED_TRACE(count);
    const PartCuller culler = InBands(count);
    EXPECT_EQ(culler.BandCount(), static_cast<std::size_t>(std::min(count, FrameLines)));
    EXPECT_EQ(LinesOf(culler), FrameLines);
  }
}

TEST(PartBands, HaveAViewOfTheirLines)
{
  const View ahead = AheadView(false);
  const ScreenProjection whole = ahead.Projection(10.0);
  const ScreenProjection band = whole.OfLines(20, 13);
  const glm::dvec3 place(1.0, 0.5, -12.0);
  const glm::dvec4 point = whole.ToScreen(place), ofBand = band.ToScreen(place);
  EXPECT_DOUBLE_EQ(ofBand.x, point.x);
  EXPECT_NEAR(ofBand.y / ofBand.w, point.y / point.w - 20.0, 1e-12);
  EXPECT_DOUBLE_EQ(ofBand.z, point.z);
  EXPECT_DOUBLE_EQ(ofBand.w, point.w);
  const auto marginOf = [](const ScreenProjection& view)
  { return view.Of(glm::dmat4(1.0)).MarginFrom(1.0f).Line; };
  EXPECT_GE(marginOf(whole.OfLines(FrameLines - 13, 13)), marginOf(whole))
    << "a device rounds as much as ever";
}

TEST(PartBands, ShowWhatAnyOfThemShows)
{
  PartScene scene;
  scene.AddBox({ -60, -60, -21 }, { 60, 2.0, -20 }); // what lies above it shows
  const std::uint32_t high = scene.AddBox({ -1, -30, -32 }, { 1, 10, -30 });
  const std::uint32_t low = scene.AddBox({ 3, -30, -32 }, { 5, 1, -30 });
  PartCuller culler = InBands(4);
  scene.Cull(culler, AheadView(false));
  EXPECT_TRUE(scene.Visible[high]);
  EXPECT_FALSE(scene.Visible[low]);
}

TEST(PartBands, OfHeapsHideNothingThatIsSeenAndAboutAsMuchAsOne)
{
  std::ptrdiff_t ofOne = 0, ofBands = 0;
  for (unsigned seed = 1; seed <= 16; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    PartScene scene = coverage::HeapOf(300, random);
    const View view = coverage::ViewOfHeap(random);
    const std::vector<std::uint8_t> drawn = scene.Visible;
    PartCuller whole(view.Columns, view.Lines);
    scene.Cull(whole, view);
    ofOne += CountVisible(drawn) - CountVisible(scene.Visible);
    scene.Visible = drawn;
    PartCuller culler(view.Columns, view.Lines, SampleGrid(), 2 + static_cast<int>(seed % 4));
    scene.Cull(culler, view);
    ofBands += CountVisible(drawn) - CountVisible(scene.Visible);
    const SightLines sight(scene, drawn, view);
    for (std::uint32_t i = 0; i < scene.Parts.size(); ++i)
    {
      if (drawn[i] && !scene.Visible[i])
      {
        ASSERT_FALSE(sight.Sees(i, 60, random)) << "part " << i;
      }
    }
  }
  EXPECT_GT(ofOne, 1500);
  EXPECT_GT(ofBands, 0.9 * static_cast<double>(ofOne));
}

// Parts keep to themselves what they are held to: frame after frame the same is found, whichever thread is the first.
TEST(PartBands, FindTheSameEachTime)
{
  Random random(5);
  PartScene scene = coverage::HeapOf(400, random);
  const std::vector<std::uint8_t> drawn = scene.Visible;
  std::vector<std::vector<std::uint8_t>> found;
  for (int twice = 0; twice < 2; ++twice)
  {
    PartCuller culler = InBands(6);
    for (int frame = 0; frame < 4; ++frame)
    {
      scene.Visible = drawn;
      scene.Cull(culler, AheadView(false));
    }
    found.push_back(scene.Visible);
  }
  EXPECT_EQ(found[0], found[1]);
}

TEST(PartBands, KeepHiddenWhatNoneOfThemShowsWhenVerified)
{
  PartScene scene;
  scene.AddBox({ -60, -60, -21 }, { 60, 2.0, -20 }); // what lies above it shows
  const std::uint32_t high = scene.AddBox({ -1, -30, -32 }, { 1, 10, -30 });
  const std::uint32_t low = scene.AddBox({ 3, -30, -32 }, { 5, 1, -30 });
  const std::uint32_t aside = scene.AddBox({ 3, 30, -32 }, { 5, 31, -30 });
  const std::uint32_t beyond =
    scene.AddBox({ -1, 30, -152 }, { 1, 40, -150 }); // where nothing hides it
  for (const int bands : { 1, 4 })
  {
    PartCuller culler = InBands(bands);
    scene.Visible.assign(scene.Parts.size(), 1);
    scene.Cull(culler, AheadView(false));
    std::vector<vitrine::BoxedPart> asked;
    for (const std::uint32_t part : { high, low, aside, beyond })
    {
      asked.push_back({ part, scene.Bounds[part] });
    }
    const ScreenProjection view = AheadView(false).Projection(scene.Reach);
    EXPECT_EQ(culler.VerifyHidden(asked, scene, view), (std::vector<std::uint8_t>{ 0, 1, 1, 1 }));
    EXPECT_TRUE(culler.VerifyHidden({}, scene, view).empty());
  }
}
