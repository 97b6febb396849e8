// What is known of errors before a frame, and how guesses are made and taken back.
#include "Core/budget/MethodChooser.h"

#include <gtest/gtest.h>

#include <cmath>

using vitrine::FrameChoice;
using vitrine::GuaranteedError;
using vitrine::GuessDelay;
using vitrine::MethodChooser;
using vitrine::PictureKind;
using vitrine::StoredColors;
using vitrine::StoredFrame;

namespace
{

constexpr double OneStep = 1.0 / 255.0;

PictureKind Plain()
{
  return {};
}

StoredFrame FactsOfPasses(int passes)
{
  return { 1000, 4, passes, 1 };
}

// A chooser after a frame of few layers.
MethodChooser AfterAFrame()
{
  MethodChooser chooser;
  const FrameChoice first = chooser.Choose(8.0 * OneStep, Plain());
  StoredFrame facts = FactsOfPasses(1);
  facts.LayersMax = 4;
  chooser.NoteFrame(first, facts);
  return chooser;
}

TEST(GuaranteedErrors, AreThoseOfRoundingAndStorage)
{
  // Half a step of the picture and of 51,840 of colours, and a share of 2^-13 of alphas.
  EXPECT_NEAR(GuaranteedError(StoredColors::HalfFloat, Plain()) / OneStep,
    0.5 + 127.5 / 51840.0 + 255.0 / 8192.0, 0.01);
  EXPECT_LE(GuaranteedError(StoredColors::HalfFloat, Plain()), vitrine::LeastBudget);
  // Half a level of 405, and a share of 2^-9.
  EXPECT_NEAR(GuaranteedError(StoredColors::Compact, Plain()) / OneStep,
    0.5 + 127.5 / 405.0 + 255.0 / 512.0, 0.1);
}

TEST(GuaranteedErrors, LeaveTheRestToColors)
{
  EXPECT_EQ(vitrine::ColorErrorToSpare(vitrine::LeastBudget, Plain()), 0.0);
  EXPECT_NEAR(vitrine::ColorErrorToSpare(2.0 * OneStep, Plain()), 1.4 * OneStep, 1e-9);
  PictureKind curved;
  curved.EncodesSRGB = true;
  const double spare = vitrine::ColorErrorToSpare(4.0 * OneStep, curved);
  EXPECT_GT(spare, 0.0);
  EXPECT_NEAR(
    GuaranteedError(StoredColors::HalfFloat, curved) + vitrine::ErrorOfColors(spare, curved),
    4.0 * OneStep, 1e-9);
}

TEST(GuaranteedErrors, GrowWithWhatAddsToThem)
{
  const double plain = GuaranteedError(StoredColors::HalfFloat, Plain());
  PictureKind multisampled;
  multisampled.Samples = 4;
  EXPECT_NEAR(
    GuaranteedError(StoredColors::HalfFloat, multisampled) - plain, 0.5 * OneStep, 0.01 * OneStep);
  PictureKind tolerant;
  tolerant.Coincidence = true;
  EXPECT_NEAR(GuaranteedError(StoredColors::HalfFloat, tolerant) - plain, OneStep / 3.0, 1e-6);
  PictureKind additive;
  additive.Additive = true;
  PictureKind floating;
  floating.EightBit = false;
  floating.FixedPoint = false;
  EXPECT_TRUE(std::isinf(GuaranteedError(StoredColors::HalfFloat, additive)));
  EXPECT_TRUE(std::isinf(GuaranteedError(StoredColors::HalfFloat, floating)));
  PictureKind curved;
  curved.EightBit = false;
  curved.EncodesSRGB = true;
  EXPECT_GT(GuaranteedError(StoredColors::HalfFloat, curved), 0.9 * OneStep);
  EXPECT_NEAR(GuaranteedError(StoredColors::Compact, multisampled) -
      GuaranteedError(StoredColors::Compact, Plain()),
    0.5 * OneStep, 0.01 * OneStep);
  for (const PictureKind& kind : { tolerant, additive, floating, curved })
  {
    EXPECT_TRUE(std::isinf(GuaranteedError(StoredColors::Compact, kind)));
  }
}

TEST(GuessDelays, DoubleUpToALimitAndShrinkAgain)
{
  GuessDelay delay;
  EXPECT_TRUE(delay.IsOver());
  for (const int frames : { 32, 64, 128, 256, 512, 1024, 1024 })
  {
    delay.Begin();
    for (int i = 0; i < frames; ++i)
    {
      EXPECT_FALSE(delay.IsOver());
      delay.CountFrame();
    }
    EXPECT_TRUE(delay.IsOver());
  }
  for (int i = 0; i < 1024; ++i)
  {
    delay.CountFrame();
  }
  delay.Begin();
  for (int i = 0; i < 32; ++i)
  {
    delay.CountFrame();
  }
  EXPECT_TRUE(delay.IsOver());
}

TEST(MethodChoosers, TakeCompactNodesWhereTheBudgetAllows)
{
  MethodChooser chooser = AfterAFrame();
  EXPECT_EQ(NameOf(chooser.Choose(0.6 * OneStep, Plain())), "prefix-sum-predicted");
  EXPECT_EQ(NameOf(chooser.Choose(1.0 * OneStep, Plain())), "prefix-sum-predicted");
  EXPECT_EQ(NameOf(chooser.Choose(2.0 * OneStep, Plain())), "prefix-sum-predicted-compact");
  PictureKind multisampled;
  multisampled.Samples = 4;
  EXPECT_EQ(NameOf(chooser.Choose(1.5 * OneStep, multisampled)), "prefix-sum-predicted");
  EXPECT_EQ(NameOf(chooser.Choose(2.0 * OneStep, multisampled)), "prefix-sum-predicted-compact");
  EXPECT_FALSE(chooser.Choose(2.0 * OneStep, Plain()).IsChecked());
}

TEST(MethodChoosers, LeavePredictionIfItOftenFails)
{
  MethodChooser chooser;
  chooser.NoteFrame(chooser.Choose(OneStep, Plain()), FactsOfPasses(2)); // the first frame counts
  for (int frame = 0; frame < 10; ++frame)
  {
    EXPECT_TRUE(chooser.Choose(OneStep, Plain()).IsPacked);
    chooser.NoteFrame(chooser.Choose(OneStep, Plain()), FactsOfPasses(1));
  }
  chooser.NoteFrame(chooser.Choose(OneStep, Plain()), FactsOfPasses(2));
  EXPECT_TRUE(chooser.Choose(OneStep, Plain()).IsPacked); // once is not often
  chooser.NoteFrame(chooser.Choose(OneStep, Plain()), FactsOfPasses(2));
  EXPECT_FALSE(chooser.Choose(OneStep, Plain()).IsPacked);
}

TEST(MethodChoosers, HideWhatIsDeepIfEnoughIsHidden)
{
  MethodChooser chooser;
  StoredFrame facts = { 1000, 40, 1, 1, false, 150 };
  chooser.NoteFrame(chooser.Choose(2.0 * OneStep, Plain()), facts);
  FrameChoice choice = chooser.Choose(2.0 * OneStep, Plain());
  EXPECT_NEAR(choice.HiddenLight,
    (2.0 * OneStep - GuaranteedError(StoredColors::Compact, Plain())) / 16.0, 1e-9);
  EXPECT_TRUE(choice.IsChecked());
  EXPECT_EQ(choice.Colors, StoredColors::Compact);
  chooser.NoteFrame(choice, facts); // finds depths
  facts.IsCut = true;
  facts.Fragments = 500;
  for (int frame = 0; frame < 10; ++frame)
  {
    choice = chooser.Choose(2.0 * OneStep, Plain());
    EXPECT_GT(choice.HiddenLight, 0.0);
    chooser.NoteFrame(choice, facts);
  }
  facts.IsCut = false;
  facts.Fragments = 1000;
  chooser.NoteFrame(choice, facts);
  facts.IsCut = true;
  facts.Fragments = 900;
  for (int frame = 0; frame < 3; ++frame)
  {
    choice = chooser.Choose(2.0 * OneStep, Plain());
    EXPECT_GT(choice.HiddenLight, 0.0);
    chooser.NoteFrame(choice, facts);
  }
  EXPECT_EQ(chooser.Choose(2.0 * OneStep, Plain()).HiddenLight, 0.0); // a tenth is not enough
}

TEST(MethodChoosers, HideNothingIfAFrameTellsThatTooLittleIsHidden)
{
  MethodChooser chooser;
  StoredFrame facts = { 1000, 40, 1, 1, false, 149 };
  chooser.NoteFrame(chooser.Choose(2.0 * OneStep, Plain()), facts);
  const FrameChoice look = chooser.Choose(2.0 * OneStep, Plain());
  EXPECT_GT(look.HiddenLight, 0.0);
  chooser.NoteFrame(look, facts);
  EXPECT_EQ(chooser.Choose(2.0 * OneStep, Plain()).HiddenLight, 0.0);
}

TEST(MethodChoosers, AskAgainWhetherEnoughIsHidden)
{
  MethodChooser chooser;
  StoredFrame facts = { 1000, 40, 1, 1, false, 600 };
  chooser.NoteFrame(chooser.Choose(2.0 * OneStep, Plain()), facts);
  for (int round = 0; round < 2; ++round)
  {
    facts.IsCut = false;
    facts.Fragments = 1000;
    chooser.NoteFrame(chooser.Choose(2.0 * OneStep, Plain()), facts);
    facts.IsCut = true;
    facts.Fragments = 400; // another view has few fragments, of which none need be hidden
    int frames = 0;
    for (; !chooser.Choose(2.0 * OneStep, Plain()).StoresAll && frames < 10000; ++frames)
    {
      chooser.NoteFrame(chooser.Choose(2.0 * OneStep, Plain()), facts);
    }
    EXPECT_EQ(frames, 256);
  }
  facts = { 400, 40, 1, 1, false, 0 };
  chooser.NoteFrame(chooser.Choose(2.0 * OneStep, Plain()), facts);
  EXPECT_EQ(chooser.Choose(2.0 * OneStep, Plain()).HiddenLight, 0.0);
}

TEST(MethodChoosers, HideNothingWhereAllFragmentsAreAskedFor)
{
  MethodChooser chooser;
  PictureKind kind;
  kind.KeepsAll = true;
  chooser.NoteFrame(chooser.Choose(2.0 * OneStep, kind), { 1000, 40, 1, 1, false, 900 });
  EXPECT_EQ(chooser.Choose(2.0 * OneStep, kind).HiddenLight, 0.0);
}

TEST(MethodChoosers, HideNothingAfterAWrongGuess)
{
  MethodChooser chooser;
  chooser.NoteFrame(chooser.Choose(2.0 * OneStep, Plain()), { 1000, 40, 1, 1 });
  EXPECT_GT(chooser.Choose(2.0 * OneStep, Plain()).HiddenLight, 0.0);
  chooser.NoteExceeded();
  EXPECT_EQ(chooser.Choose(2.0 * OneStep, Plain()).HiddenLight, 0.0);
}

TEST(MethodChoosers, LinkListsIfMemoryIsShort)
{
  MethodChooser chooser;
  StoredFrame facts = FactsOfPasses(3);
  facts.Bands = 2;
  chooser.NoteFrame(chooser.Choose(OneStep, Plain()), facts);
  EXPECT_FALSE(chooser.Choose(OneStep, Plain()).IsPacked);
}

TEST(MethodChoosers, TellWhatTheyChoseAndWhy)
{
  MethodChooser chooser = AfterAFrame();
  chooser.NoteFrame(chooser.Choose(2.0 * OneStep, Plain()), FactsOfPasses(1));
  const auto plan = chooser.Plan(2.0 * OneStep, Plain());
  ASSERT_EQ(plan.size(), 4u);
  EXPECT_TRUE(plan[0].IsChosen);
  EXPECT_EQ(plan[0].Method, "prefix-sum-predicted-compact");
  EXPECT_EQ(plan[0].Bytes, 16 * 1000);
  EXPECT_EQ(plan[0].Passes, 1.0);
  for (std::size_t i = 1; i < plan.size(); ++i)
  {
    EXPECT_FALSE(plan[i].IsChosen);
    EXPECT_GT(plan[i].Bytes, plan[0].Bytes);
    EXPECT_NE(plan[i].Reason, "");
  }
}

}
