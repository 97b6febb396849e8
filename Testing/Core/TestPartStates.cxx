// What is known of parts from frame to frame.

#include "Core/culling/walk/PartStates.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace
{

using vitrine::PartStates;

}

TEST(PartStates, AreThoseThatAreDrawnOnceAFrameBegins)
{
  PartStates states;
  EXPECT_EQ(states.Begin({ 1, 0, 1, 1, 0 }), 3u);
  EXPECT_EQ(states.Count(), 5u);
  const std::vector<std::uint8_t> expected{ 1, 0, 1, 1, 0 };
  for (std::uint32_t part = 0; part < expected.size(); ++part)
  {
    EXPECT_EQ(states[part], expected[part]) << part;
  }
  EXPECT_TRUE(states.Has(2, PartStates::IsDrawn));
  EXPECT_FALSE(states.Has(4, PartStates::IsDrawn));
}

TEST(PartStates, AreSetOneByOne)
{
  PartStates states;
  states.Begin({ 1, 1 });
  states.Set(1, PartStates::IsVisited);
  states.Set(1, PartStates::IsShown);
  states.Set(1, PartStates::IsShown);
  EXPECT_TRUE(states.Has(1, PartStates::IsVisited));
  EXPECT_TRUE(states.Has(1, PartStates::IsShown));
  EXPECT_EQ(states[0], PartStates::IsDrawn) << "another part";
  states.Set(1, PartStates::IsShown, false);
  EXPECT_EQ(states[1], PartStates::IsDrawn | PartStates::IsVisited);
}

TEST(PartStates, KeepWhatIsMeantForTheNextFrameAlone)
{
  PartStates states;
  states.Begin({ 1, 1, 1 });
  for (const std::uint8_t bit :
    { PartStates::IsVisited, PartStates::IsShown, PartStates::WasSmall, PartStates::WasIdle })
  {
    states.Set(0, bit);
    states.Set(1, bit);
  }
  EXPECT_EQ(states.Begin({ 1, 0, 1, 1 }), 3u);
  const std::uint8_t kept = PartStates::WasSmall | PartStates::WasIdle;
  EXPECT_EQ(states[0], PartStates::IsDrawn | kept);
  EXPECT_EQ(states[1], kept);
  EXPECT_EQ(states[2], PartStates::IsDrawn);
  EXPECT_EQ(states[3], PartStates::IsDrawn) << "a new one";
  EXPECT_EQ(states.Begin({ 1 }), 1u);
  EXPECT_EQ(states.Count(), 1u);
  EXPECT_EQ(states.Begin({ 1, 1 }), 2u);
  EXPECT_EQ(states[1], PartStates::IsDrawn) << "one that was gone";
}
