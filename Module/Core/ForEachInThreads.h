#ifndef VITRINE_CORE_FOR_EACH_IN_THREADS_H
#define VITRINE_CORE_FOR_EACH_IN_THREADS_H

#include "Core/WorkerThreads.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>

namespace vitrine
{

/** To wake more threads takes longer than what they save of work of a few milliseconds. */
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
  const std::size_t threads = std::min(
    { count, MostThreads, std::size_t{ std::max(1u, std::thread::hardware_concurrency()) } });
  WorkerThreads::OfProcess().Share(workOn, std::max<std::size_t>(threads, 1) - 1);
}

}

#endif
