#include "stability/PictureChanges.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{

using program::Flicker;
using program::FlickerMeter;
using program::LargestDifference;
using vitrine::Image;

const float Step = 1.0f / 255.0f;
const float NaN = std::numeric_limits<float>::quiet_NaN();

/** A picture one pixel high. */
Image Row(std::vector<float> values)
{
  return { static_cast<int>(values.size() / 3), 1, std::move(values) };
}

/** A method's pictures and truth's, in turn. */
Flicker Follow(const std::vector<Image>& method, const std::vector<Image>& truth)
{
  FlickerMeter meter;
  for (std::size_t i = 0; i < method.size(); ++i)
  {
    meter.Add(method[i], truth[i]);
  }
  return meter.Result();
}
}

TEST(LargestDifference, IsOfAnyChannelAsShown)
{
  EXPECT_EQ(LargestDifference(Row({}), Row({})), 0.0);
  EXPECT_DOUBLE_EQ(
    LargestDifference(Row({ 0, 0, 0, 0, 0, 0 }), Row({ 0, 0.25, 0, 0, 0, 0.5 })), 0.5);
  EXPECT_EQ(LargestDifference(Row({ -3, 1, 7 }), Row({ 0, 4, 1 })), 0.0); // beyond black and white
}

TEST(LargestDifference, IsAllOfItWhereOneIsNoNumber)
{
  EXPECT_EQ(LargestDifference(Row({ 0, NaN, 0 }), Row({ 0, 0, 0 })), 1.0);
  EXPECT_EQ(LargestDifference(Row({ 0, 1, 0 }), Row({ 0, NaN, 0 })), 1.0);
  EXPECT_EQ(LargestDifference(Row({ 0, NaN, 0 }), Row({ 0, NaN, 0 })), 0.0);
}

TEST(FlickerMeter, TellsNoChangeOfOnePicture)
{
  for (const Flicker& flicker :
    { Follow({}, {}), Follow({ Row({ 0, 0, 0.5f }) }, { Row({ 0, 0, 0 }) }) })
  {
    EXPECT_EQ(flicker.Method.Largest, 0.0);
    EXPECT_EQ(flicker.Method.Typical, 0.0);
    EXPECT_EQ(flicker.Method.ChangedPixels, 0.0);
    EXPECT_EQ(flicker.Truth.Largest, 0.0);
    EXPECT_EQ(flicker.Excess, 0.0);
  }
}

TEST(FlickerMeter, TellsTheErrorOfEveryPicture)
{
  const Image black = Row({ 0, 0, 0 });
  EXPECT_EQ(Follow({ Row({ 0, 0.5, 0 }) }, { black }).Error, 0.5);
  EXPECT_EQ(Follow({ black, Row({ 0, 0.5, 0 }), black }, { black, black, black }).Error, 0.5);
}

TEST(FlickerMeter, ExcessIsOfOneValueWhateverOthersDo)
{
  // a silhouette moves over one pixel in both; the method changes another one, where truth stands still
  const Flicker flicker =
    Follow({ Row({ 0, 0, 0, 0.5, 0.5, 0.5 }), Row({ 1, 1, 1, 0.5, 0.25, 0.5 }) },
      { Row({ 0, 0, 0, 0.5, 0.5, 0.5 }), Row({ 1, 1, 1, 0.5, 0.5, 0.5 }) });
  EXPECT_EQ(flicker.Method.Largest, 1.0);
  EXPECT_EQ(flicker.Truth.Largest, 1.0);
  EXPECT_EQ(flicker.Excess, 0.25);
}

TEST(FlickerMeter, LessChangeThanTruthIsNoExcess)
{
  const Flicker flicker =
    Follow({ Row({ 0, 0, 0 }), Row({ 0, 0.25, 0 }) }, { Row({ 0, 0, 0 }), Row({ 0, 0.75, 0 }) });
  EXPECT_EQ(flicker.Excess, 0.0);
  EXPECT_EQ(flicker.Error, 0.5);
}

TEST(FlickerMeter, TypicalIsTheMedianOfTheSteps)
{
  const std::vector<Image> method = { Row({ 0, 0, 0 }), Row({ 0.25, 0, 0 }), Row({ 0.25, 1, 0 }),
    Row({ 0.25, 1, 0.5 }) };
  const std::vector<Image> still(method.size(), Row({ 0, 0, 0 }));
  const Flicker flicker = Follow(method, still);
  EXPECT_EQ(flicker.Method.Largest, 1.0);
  EXPECT_EQ(flicker.Method.Typical, 0.5);
  EXPECT_EQ(flicker.Truth.Typical, 0.0);
}

TEST(FlickerMeter, NoStepLeadsFromOneRunToTheNext)
{
  FlickerMeter meter;
  for (const float place : { 0.0f, 0.5f })
  {
    meter.BeginRun();
    meter.Add(Row({ place, 0, 0 }), Row({ 0, 0, 0 }));
    meter.Add(Row({ place + 0.125f, 0, 0 }), Row({ 0.125f, 0, 0 }));
  }
  const Flicker flicker = meter.Result();
  EXPECT_EQ(flicker.Method.Largest, 0.125);
  EXPECT_EQ(flicker.Method.Typical, 0.125);
  EXPECT_EQ(flicker.Truth.Largest, 0.125);
  EXPECT_EQ(flicker.Excess, 0.0);
  EXPECT_EQ(flicker.Error, 0.5);
}

TEST(FlickerMeter, CountsPixelsOfWhichAnyChannelChangesByMoreThanAStep)
{
  const Image before = Row({ 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 });
  const Image after =
    Row({ Step, Step, Step, 0, 2 * Step, 0, 2 * Step, 2 * Step, 2 * Step, 0, 0, 0 });
  const Flicker flicker = Follow({ before, after }, { before, before });
  EXPECT_EQ(flicker.Method.ChangedPixels, 0.5);
  EXPECT_EQ(flicker.Truth.ChangedPixels, 0.0);
  EXPECT_EQ(Follow({ before, before }, { before, after }).Truth.ChangedPixels, 0.5);
}

TEST(FlickerMeter, ChangedPixelsAreTheMedianOfTheSteps)
{
  const Image black = Row({ 0, 0, 0, 0, 0, 0 });
  const Image half = Row({ 1, 0, 0, 0, 0, 0 });
  const Image other = Row({ 0, 0, 0, 1, 0, 0 });
  // the steps change none, one and both of the pixels
  const Flicker flicker = Follow({ black, black, half, other }, { black, black, black, black });
  EXPECT_EQ(flicker.Method.ChangedPixels, 0.5);
}
