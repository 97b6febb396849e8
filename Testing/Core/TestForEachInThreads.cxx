// What is done in threads: each piece once, and all of it when that returns.
#include "Core/threads/ForEachInThreads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <vector>

using vitrine::ForEachInThreads;

TEST(ForEachInThreads, DoesEachOnce)
{
  for (const std::size_t count : { 0, 1, 2, 3, 7, 64, 5000 })
  {
    SCOPED_TRACE(count);
    std::vector<std::atomic<int>> calls(count + 1);
    ForEachInThreads(count, [&](std::size_t i) { ++calls[i]; });
    for (std::size_t i = 0; i < count; ++i)
    {
      ASSERT_EQ(calls[i], 1) << i;
    }
    EXPECT_EQ(calls[count], 0);
  }
}

TEST(ForEachInThreads, PassesOnWhatIsThrown)
{
  for (const std::size_t thrower : { 0, 1, 63 })
  {
    EXPECT_THROW(ForEachInThreads(64,
                   [&](std::size_t i)
                   {
                     if (i == thrower)
                     {
                       throw std::runtime_error("one of them");
                     }
                   }),
      std::runtime_error);
  }
}
