#include "chart/MethodFamily.h"

#include <gtest/gtest.h>

#include <set>

TEST(MethodFamily, IsWhatTheNameBeginsWith)
{
  EXPECT_EQ(program::FamilyOf("vtk-peeling-4").Name, "vtk-peeling");
  EXPECT_EQ(program::FamilyOf("linked-list-compact").Name, "linked-list");
  EXPECT_EQ(program::FamilyOf("stencil-mask-8").Name, "stencil-mask");
  EXPECT_EQ(program::FamilyOf("automatic").Name, "automatic");
  EXPECT_EQ(program::FamilyOf("truth").Name, "other");
}

TEST(MethodFamily, HasAColourOfItsOwn)
{
  std::set<std::array<unsigned char, 3>> colors;
  for (const program::MethodFamily& family : program::MethodFamilies())
  {
    EXPECT_TRUE(colors.insert(family.Color).second) << family.Name;
  }
}

TEST(MethodFamily, HasAMarkOfItsOwn)
{
  std::set<std::string> markers;
  for (const program::MethodFamily& family : program::MethodFamilies())
  {
    EXPECT_TRUE(markers.insert(family.Marker).second) << family.Name;
  }
}
