#ifndef VITRINE_CORE_THREADS_FOR_EACH_IN_THREADS_H
#define VITRINE_CORE_THREADS_FOR_EACH_IN_THREADS_H

#include "Core/threads/WorkerThreads.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>

namespace vitrine
{

/**
 * Largest number of threads for one piece of work. For work of a few milliseconds, waking more threads takes longer
 * than they save.
 */
inline constexpr std::size_t MostThreads = 8;

/**
 * Returns how many threads are worth waking for `count` pieces of work, including the calling thread. The number of
 * processors is read once, because reading it takes as long as culling ten parts.
 */
inline std::size_t ThreadsFor(std::size_t count)
{
  static const std::size_t processors = std::max(1u, std::thread::hardware_concurrency());
  return std::min({ count, MostThreads, processors });
}

/**
 * Calls work(i) for each i below `count`, in as many threads as ThreadsFor() says. The calling thread is one of them.
 * Returns when all calls have returned.
 * @param work  is called once for each number
 * @throws      what a call throws
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
