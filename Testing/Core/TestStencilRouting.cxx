// Which fragment of a pixel's sequence each sample takes in each pass, by the stencil as OpenGL runs it.
#include "Core/lists/StencilRouting.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{

class Routes : public testing::TestWithParam<int>
{
protected:
  const vitrine::StencilRoute Route{ GetParam() };
};

// The fragments that get through to a sample: EQUAL to the passing value; DECR, which ends at 0.
std::vector<int> FragmentsThrough(int start, int passing, int fragments)
{
  std::vector<int> through;
  int value = start;
  for (int i = 0; i < fragments; ++i)
  {
    if (value == passing)
    {
      through.push_back(i);
    }
    value = value > 0 ? value - 1 : 0;
  }
  return through;
}

TEST_P(Routes, TakeEveryFragmentOnce)
{
  int next = 0;
  for (int pass = 0; pass < this->Route.MostPasses(); ++pass)
  {
    for (int sample = GetParam() - 1; sample >= 0; --sample)
    {
      const std::vector<int> through =
        FragmentsThrough(this->Route.StartValue(sample), this->Route.PassingValue(pass), 1000);
      ASSERT_EQ(through, std::vector<int>{ next }) << "pass " << pass << ", sample " << sample;
      ++next;
    }
  }
  EXPECT_GE(next + GetParam(), 255); // another pass is more than 8 bits reach
}

TEST_P(Routes, StayWithinEightBits)
{
  const int last = this->Route.MostPasses() - 1;
  EXPECT_EQ(this->Route.StartValue(0), 255);
  EXPECT_GE(
    this->Route.StartValue(GetParam() - 1), 1); // 0 is what samples begin with that take nothing
  EXPECT_GE(this->Route.PassingValue(last), 1);
  EXPECT_LE(this->Route.PassingValue(last) - GetParam(), 1);
}

TEST_P(Routes, TakeNoMorePassesThanTheyNeed)
{
  const int k = GetParam();
  EXPECT_EQ(this->Route.PassesFor(0), 0);
  EXPECT_EQ(this->Route.PassesFor(1), 1);
  EXPECT_EQ(this->Route.PassesFor(k), 1);
  EXPECT_EQ(this->Route.PassesFor(k + 1), 2);
  EXPECT_EQ(this->Route.PassesFor(3 * k), 3);
  EXPECT_EQ(this->Route.PassesFor(1000), this->Route.MostPasses());
}

INSTANTIATE_TEST_SUITE_P(Samples, Routes, testing::ValuesIn(vitrine::RoutedSampleCounts()),
  testing::PrintToStringParamName());

}
