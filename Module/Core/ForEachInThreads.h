#ifndef VITRINE_CORE_FOR_EACH_IN_THREADS_H
#define VITRINE_CORE_FOR_EACH_IN_THREADS_H

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace vitrine
{

/** To begin more threads takes longer than what they save of work of a few milliseconds. */
inline constexpr std::size_t MostThreads = 8;

/**
 * Does something for each number below a count, in as many threads as the machine has processors, but for those beyond MostThreads, of which the calling one is one. Returns once all of it is done.
 * @param work  is called with the numbers, each once; what it throws comes out here
 */
template <class Work>
void ForEachInThreads(std::size_t count, const Work& work)
{
  std::atomic<std::size_t> next{ 0 };
  const auto workOn = [&]
  {
    for (std::size_t i = next++; i < count; i = next++)
    {
      work(i);
    }
  };
  const std::size_t processors =
    std::min<std::size_t>(std::max(1u, std::thread::hardware_concurrency()), MostThreads);
  std::vector<std::future<void>> others;
  for (std::size_t i = 1; i < std::min(count, processors); ++i)
  {
    others.push_back(std::async(std::launch::async, workOn));
  }
  workOn();
  for (std::future<void>& other : others)
  {
    other.get();
  }
}

}

#endif
