#ifndef VITRINE_CORE_THREADS_FOR_EACH_IN_THREADS_H
#define VITRINE_CORE_THREADS_FOR_EACH_IN_THREADS_H

#include "Core/threads/WorkerThreads.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>

namespace vitrine
{

/** To wake more threads takes longer than what they save of work of a few milliseconds. */
inline constexpr std::size_t MostThreads = 8;

/** How many threads are worth waking for so many pieces of work, the calling one among them. The machine is asked once: that takes as long as to cull ten parts. */
inline std::size_t ThreadsFor(std::size_t count)
{
  static const std::size_t processors = std::max(1u, std::thread::hardware_concurrency());
  return std::min({ count, MostThreads, processors });
}

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
  WorkerThreads::OfProcess().Share(workOn, std::max<std::size_t>(ThreadsFor(count), 1) - 1);
}

}

#endif
