// Parts that come first because they hid much in the last frame.
#include "PartScenes.h"

#include "Core/culling/walk/LastOwners.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
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
using vitrine::LastOwners;
using vitrine::PartCuller;
using vitrine::PartStates;
using vitrine::SBuffer;
using vitrine::ScreenRectangle;

/** A wall, and a plate behind it that comes nearer beside the view, so that it is visited first. */
struct PlateBehindAWall
{
  PlateBehindAWall()
  {
    Triangles wall, plate;
    wall.AddQuad({ -60, -60, -20 }, { 60, -60, -20 }, { 60, 60, -20 }, { -60, 60, -20 });
    plate.AddQuad({ -70, -3, -5 }, { 10, -3, -60 }, { 10, 3, -60 }, { -70, 3, -5 });
    this->Wall = this->Scene.Add(wall);
    this->Plate = this->Scene.Add(plate);
  }

  vitrine::CullCounts Cull(PartCuller& culler, const View& view)
  {
    this->Scene.Visible.assign(2, 1);
    this->Scene.Cull(culler, view);
    return culler.Counts();
  }

  PartScene Scene;
  std::uint32_t Wall, Plate;
};

}

TEST(LastOwners, AreThoseThatHaveMuchAtTheEnd)
{
  SBuffer lines(40, 20);
  const ScreenRectangle anywhere{ 0, 40, 0, 20, 0.9f };
  PartStates states;
  states.Begin({ 1, 1, 1, 1 });
  LastOwners owners;
  owners.Begin(4);
  const std::uint32_t second = owners.AddInserted(2, anywhere);
  const std::uint32_t first = owners.AddInserted(0, anywhere);
  const std::uint32_t third = owners.AddInserted(3, anywhere);
  for (int line = 0; line < 20; ++line)
  {
    lines.Insert(line, { 0, 30, 0.3f, 0.3f, first });
    lines.Insert(line, { 0, 28, 0.5f, 0.5f, second });
    lines.Insert(line, { 39, 39.5f, 0.5f, 0.5f, third });
  }
  owners.End(lines, states);
  ASSERT_EQ(owners.Owners().size(), 2u);
  EXPECT_EQ(owners.Owners()[0].Part, 2u) << "in the order of their insertion";
  EXPECT_EQ(owners.Owners()[1].Part, 0u);
  owners.Begin(4);
  lines.Clear();
  owners.End(lines, states);
  EXPECT_TRUE(owners.Owners().empty()) << "nothing was inserted in this frame";
}

// A span may lie between samples.
TEST(LastOwners, ShowSurelyWhereTheyHaveSamples)
{
  const ScreenRectangle anywhere{ 0, 40, 0, 20, 0.9f };
  for (const bool isBySample : { false, true })
  {
    SCOPED_TRACE(isBySample);
    const vitrine::SampleGrid samples = vitrine::SampleGrid::AtCentres(1);
    SBuffer lines =
      isBySample ? SBuffer::WithFewSamples(40, 20, samples) : SBuffer(40, 20, samples);
    PartStates states;
    LastOwners owners;
    states.Begin({ 1, 1, 1, 1 });
    owners.Begin(4);
    const std::uint32_t behind = owners.AddInserted(3, anywhere);
    const std::uint32_t before = owners.AddInserted(1, anywhere);
    const std::uint32_t beside = owners.AddInserted(2, anywhere);
    lines.Insert(3, { 5, 8, 0.3f, 0.3f, behind });
    lines.Insert(3, { 4, 9, 0.5f, 0.5f, before });
    lines.Insert(4, { 4, 5, 0.5f, 0.5f, beside });
    owners.End(lines, states);
    EXPECT_FALSE(states.Has(3, PartStates::HasSamples)) << "it stands behind";
    EXPECT_EQ(states.Has(1, PartStates::HasSamples), isBySample);
    EXPECT_EQ(states.Has(2, PartStates::HasSamples), isBySample) << "one sample is enough";
    states.Begin({ 1, 1, 1, 1 });
    owners.Begin(4);
    EXPECT_FALSE(states.Has(1, PartStates::HasSamples)) << "in this frame it has none yet";
    EXPECT_EQ(states.Has(1, PartStates::HadSamples), isBySample);
    lines.Clear();
    owners.End(lines, states);
    EXPECT_FALSE(states.Has(1, PartStates::HasSamples));
    states.Begin({ 1, 1, 1, 1 });
    EXPECT_FALSE(states.Has(1, PartStates::HadSamples)) << "that was in the frame before";
  }
}

TEST(LastOwners, AreNearWhereTheyHaveHardlyMoved)
{
  const LastOwners::Owner owner{ 0, { 100, 140, 50, 60, 0.5f } };
  EXPECT_TRUE(owner.IsNear({ 110, 152, 54, 64, 0.9f }));
  EXPECT_FALSE(owner.IsNear({ 120, 140, 50, 60, 0.5f }));
  EXPECT_FALSE(owner.IsNear({ 100, 160, 50, 60, 0.5f }));
  EXPECT_FALSE(owner.IsNear({ 100, 140, 30, 60, 0.5f }));
  EXPECT_FALSE(owner.IsNear({ 100, 140, 50, 80, 0.5f }));
  EXPECT_FALSE(owner.IsNear({ NAN, 140, 50, 60, 0.5f }));
  EXPECT_TRUE(owner.IsStill({ 101.2f, 140, 50.3f, 60, 0.9f }));
  EXPECT_FALSE(owner.IsStill({ 101.4f, 140, 50, 60, 0.5f }));
  EXPECT_FALSE(owner.IsStill({ 100, 140, 50, 60.5f, 0.5f }));
  EXPECT_FALSE(owner.IsStill({ 100, 140, NAN, 60, 0.5f }));
}

TEST(LastOwners, HadNothingUntilTheyAreTriedAgain)
{
  const ScreenRectangle there{ 10, 20, 5, 15, 0.5f }, elsewhere{ 30, 40, 5, 15, 0.5f };
  SBuffer lines(40, 20);
  PartStates states;
  states.Begin({ 1, 1, 1 });
  states.Set(0, PartStates::IsShown);
  states.Set(1, PartStates::IsShown);
  LastOwners owners;
  const auto insertsSecond = [&]
  {
    lines.Insert(3, { 5, 8, 0.3f, 0.3f, owners.AddInserted(1, there) });
    owners.End(lines, states);
    owners.KeepIdlers(states);
    lines.Clear();
  };
  const auto insertsBoth = [&]
  {
    owners.Begin(2);
    owners.AddInserted(0, there);
    insertsSecond();
  };
  int frames = 0, tried = 0;
  for (insertsBoth(); frames < 64; ++frames)
  {
    owners.Begin(2);
    EXPECT_FALSE(owners.HadNothing(1, there)) << "it had three columns";
    const bool isIdle = owners.HadNothing(0, there);
    tried += !isIdle;
    if (!isIdle)
    {
      owners.AddInserted(0, there);
    }
    insertsSecond();
    EXPECT_TRUE(states.Has(0, PartStates::WasIdle));
    EXPECT_FALSE(states.Has(1, PartStates::WasIdle));
  }
  EXPECT_EQ(tried, frames / 16);

  insertsBoth();
  insertsBoth(); // one of two frames that follow each other is none in which it is tried
  owners.Begin(2);
  EXPECT_FALSE(owners.HadNothing(0, elsewhere)) << "it has moved";
  owners.End(lines, states);
  owners.KeepIdlers(states);
  EXPECT_FALSE(states.Has(0, PartStates::WasIdle)) << "it need not be looked for any more";
  for (int frame = 0; frame < 2; ++frame)
  {
    owners.Begin(2);
    EXPECT_FALSE(owners.HadNothing(0, there)) << "it was not met in the frame before";
    owners.End(lines, states);
    owners.KeepIdlers(states);
  }
}

// Parts may be taken away while it is known what they were inserted for.
TEST(LastOwners, AreForgottenWithTheirStates)
{
  SBuffer lines(40, 20);
  PartStates states;
  states.Begin({ 1, 1, 1 });
  states.Set(2, PartStates::IsShown);
  LastOwners owners;
  owners.Begin(3);
  owners.AddInserted(2, { 10, 20, 5, 15, 0.5f });
  owners.End(lines, states);
  owners.KeepIdlers(states);
  EXPECT_TRUE(states.Has(2, PartStates::WasIdle));
  states.Begin({ 1 });
  owners.Begin(1);
  owners.End(lines, states);
  owners.KeepIdlers(states);
  EXPECT_EQ(states.Count(), 1u);
  states.Begin({ 1, 1, 1 });
  EXPECT_FALSE(states.Has(2, PartStates::WasIdle));
  EXPECT_FALSE(owners.HadNothing(2, { 10, 20, 5, 15, 0.5f }));
}

// What shows though it covers nothing is shown without being inserted, but for one of sixteen frames.
TEST(LastOwners, AreNotInsertedInVainAgain)
{
  PartScene scene;
  scene.AddBox({ -1, -1e-4, -30 }, { 1, 1e-4, -29 }); // thinner than a line
  PartCuller culler(FrameColumns, FrameLines);
  std::uint32_t inserted = 0;
  for (int frame = 0; frame < 33; ++frame)
  {
    scene.Visible = { 1 };
    scene.Cull(culler, AheadView(false));
    EXPECT_TRUE(scene.Visible[0]);
    inserted += culler.Counts().Inserted;
  }
  EXPECT_EQ(inserted, 3u);
}

TEST(LastOwners, ComeBeforeWhatTheyHide)
{
  PlateBehindAWall both;
  PartCuller culler(FrameColumns, FrameLines);
  EXPECT_EQ(both.Cull(culler, AheadView(false)).Inserted, 2u) << "the plate comes first";
  EXPECT_FALSE(both.Scene.Visible[both.Plate]);
  EXPECT_EQ(both.Cull(culler, AheadView(false)).Inserted, 1u);
  EXPECT_TRUE(both.Scene.Visible[both.Wall]);
  EXPECT_FALSE(both.Scene.Visible[both.Plate]);
}

TEST(LastOwners, AreTestedLikeAnyOther)
{
  PlateBehindAWall both;
  PartCuller culler(FrameColumns, FrameLines);
  both.Cull(culler, AheadView(false));
  View aside = AheadView(false); // past the wall's end, from behind it
  aside.ToClip =
    aside.ToClip * glm::lookAt(glm::dvec3(0, 0, -40), glm::dvec3(0, 0, -100), glm::dvec3(0, 1, 0));
  aside.Eye = glm::dvec3(0, 0, -40);
  both.Cull(culler, aside);
  EXPECT_FALSE(both.Scene.Visible[both.Wall]);
  EXPECT_TRUE(both.Scene.Visible[both.Plate]);
}

// What had samples is inserted before it is tested.
TEST(LastOwners, AreTestedWhereTheyInsertNoSamples)
{
  PartScene scene;
  Triangles wall;
  wall.AddQuad({ -60, -60, -20 }, { 60, -60, -20 }, { 60, 60, -20 }, { -60, 60, -20 });
  const std::uint32_t box = scene.AddBox({ -2, -2, -32 }, { 2, 2, -30 });
  const std::uint32_t before = scene.Add(wall);
  PartCuller culler(FrameColumns, FrameLines, vitrine::SampleGrid::AtCentres(1));
  scene.Visible = { 1, 0 };
  scene.Cull(culler, AheadView(false));
  EXPECT_TRUE(scene.Visible[box]);
  EXPECT_EQ(culler.Counts().Inserted, 1u);
  scene.Visible = { 1, 1 };
  scene.Cull(culler, AheadView(false));
  EXPECT_TRUE(scene.Visible[before]);
  EXPECT_FALSE(scene.Visible[box]);
  EXPECT_EQ(culler.Counts().Inserted, 2u) << "it was inserted in vain, once";
  scene.Visible = { 1, 1 };
  scene.Cull(culler, AheadView(false));
  EXPECT_FALSE(scene.Visible[box]);
  EXPECT_EQ(culler.Counts().Inserted, 1u) << "it had no samples any more";
}

// Where only a device's rounding may have it reach a row of samples it shows, and has none.
TEST(LastOwners, AreInsertedOnceThoughTheyShowBesideSamples)
{
  PartScene scene;
  scene.AddBox({ -2, -0.15, -32 }, { 2, 0.15, -30 });
  PartCuller culler(FrameColumns, FrameLines, vitrine::SampleGrid::AtCentres(1));
  View view = AheadView(true);
  int shown = 0;
  for (int frame = 0; frame < 1000; ++frame)
  {
    view.ToClip = view.ToClip * glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.001, 0.0));
    scene.Visible = { 1 };
    scene.Cull(culler, view);
    shown += scene.Visible[0];
    ASSERT_LE(culler.Counts().Inserted, 1u) << "in frame " << frame;
  }
  EXPECT_GT(shown, 800);
  EXPECT_LT(shown, 1000);
}

TEST(LastOwners, AreForgottenWhereTheyAreNoMore)
{
  PlateBehindAWall both;
  PartCuller culler(FrameColumns, FrameLines);
  both.Cull(culler, AheadView(false));
  both.Scene.Bounds[both.Wall] = vitrine::Box(); // as of what cannot be hidden
  EXPECT_EQ(both.Cull(culler, AheadView(false)).Inserted, 1u);
  EXPECT_TRUE(both.Scene.Visible[both.Plate]);
  both.Scene.Visible = { 1 };
  both.Scene.Bounds.resize(1);
  both.Scene.Cull(culler, AheadView(false));
  EXPECT_EQ(culler.Counts().Inserted, 0u);
}

// Views that move a little, and jump, in one culler.
TEST(LastOwners, HideNothingThatIsSeenWhereTheViewMoves)
{
  int hidden = 0;
  for (unsigned seed = 1; seed <= 10; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    PartScene scene = coverage::HeapOf(200, random);
    const std::vector<std::uint8_t> drawn = scene.Visible;
    View view = coverage::ViewOfHeap(random);
    PartCuller culler(view.Columns, view.Lines, {}, 1 + static_cast<int>(seed % 3));
    for (int frame = 0; frame < 6; ++frame)
    {
      const glm::dvec3 step = (frame == 3 ? 1.0 : 0.02) * random.Point(-1, 1);
      view.ToClip = view.ToClip * glm::translate(glm::dmat4(1.0), -step);
      view.Eye += view.IsParallel ? glm::dvec3(0.0) : step;
      scene.Visible = drawn;
      scene.Cull(culler, view);
      const SightLines sight(scene, drawn, view);
      for (std::uint32_t i = 0; i < scene.Parts.size(); ++i)
      {
        if (drawn[i] && !scene.Visible[i])
        {
          ++hidden;
          ASSERT_FALSE(sight.Sees(i, 10, random)) << "part " << i << " in frame " << frame;
        }
      }
    }
  }
  EXPECT_GT(hidden, 1000);
}
