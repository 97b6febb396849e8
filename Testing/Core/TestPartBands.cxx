// Bands of a screen that are culled by themselves, at the same time.
#include "PartScenes.h"

#include "Core/culling/PartCuller.h"

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

TEST(PartBands, TellWhetherThinFacesOfAPartAreHidden)
{
  PartScene scene;
  scene.AddBox({ -60, -60, -21 }, { 60, 2.0, -20 });
  const std::uint32_t wide = scene.AddBox({ -1, -30, -32 }, { 1, 10, -30 });
  // Depths of a sliver differ by less than those of what stands before it.
  const auto addSlivers = [&](double left, double top, int count)
  {
    Triangles slivers;
    for (int i = 0; i < count; ++i)
    {
      slivers.Add({ left, -3, -31 }, { left, top, -31 }, { left + 6e-3, top, -31 });
    }
    return scene.Add(slivers);
  };
  const double centre = 1.657; // of pixels, two and a half columns from the middle of the screen
  const std::uint32_t high = addSlivers(centre - 3e-3, 10, 1), low = addSlivers(4, 1, 1);
  const std::uint32_t many = addSlivers(-centre - 3e-3, 10, 200),
                      between = addSlivers(-2.65, 10, 1);
  const std::uint32_t thousands = addSlivers(-centre - 3e-3, 10, 1100);
  const std::uint32_t lines = scene.AddBox({ 7, -30, -32 }, { 9, 1, -30 });
  scene.Parts[lines].IsOfFacesAlone = false;
  for (const auto& [count, isAtCentres] :
    { std::pair(1, false), std::pair(4, false), std::pair(1, true), std::pair(4, true) })
  {
    SCOPED_TRACE(count);
    PartCuller culler(
      FrameColumns, FrameLines, isAtCentres ? SampleGrid::AtCentres(1) : SampleGrid(), count);
    View view = AheadView(false);
    view.Snapping = { 1.0f / 64.0f, 1.0f / 64.0f, 0.0f }; // slivers are 0.01 columns wide
    scene.Visible.assign(scene.Parts.size(), 1);
    scene.Cull(culler, view);
    std::vector<PartCuller::BoxedPart> asked;
    for (const std::uint32_t part : { wide, high, low, lines, many, between, thousands })
    {
      asked.push_back({ scene.OccluderOf(part), scene.Bounds[part] });
    }
    asked.push_back({ {}, scene.Bounds[wide] });
    const std::vector<std::uint8_t> hides =
      culler.HideThinFacesOf(asked, view.Projection(scene.Reach));
    ASSERT_EQ(hides.size(), 8u);
    EXPECT_TRUE(hides[0]) << "it has none";
    EXPECT_FALSE(hides[1]);
    EXPECT_TRUE(hides[2]);
    EXPECT_FALSE(hides[3]) << "more is drawn than faces";
    EXPECT_FALSE(hides[4]) << "a sliver among many faces on few cells";
    EXPECT_EQ(hides[5], isAtCentres) << "slivers between samples";
    EXPECT_FALSE(hides[6]) << "a sliver among thousands on few cells";
    EXPECT_FALSE(hides[7]) << "it hides nothing";
    EXPECT_TRUE(culler.HideThinFacesOf({}, view.Projection(scene.Reach)).empty());
  }
}
