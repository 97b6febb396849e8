// Work that threads share: by whom it is done, and until when.
#include "Core/threads/WorkerThreads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

using vitrine::WorkerThreads;

namespace
{

/** Holds up to so many calls until all have come. */
class Meeting
{
public:
  explicit Meeting(int count)
    : Missing(count)
  {
  }

  void Wait()
  {
    for (--this->Missing; this->Missing > 0;)
    {
      std::this_thread::yield();
    }
  }

private:
  std::atomic<int> Missing;
};

/** The threads that did some work, which does not go on before so many are at it. */
std::set<std::thread::id> ThreadsOf(WorkerThreads& workers, int count)
{
  std::mutex lock;
  std::set<std::thread::id> threads;
  Meeting all(count);
  workers.Share(
    [&]
    {
      all.Wait();
      const std::lock_guard<std::mutex> own(lock);
      threads.insert(std::this_thread::get_id());
    },
    static_cast<std::size_t>(count) - 1);
  return threads;
}

}

TEST(WorkerThreads, StayForTheNextCall)
{
  // Those of another object than the process's are as many as have been asked for.
  static WorkerThreads& workers = *new WorkerThreads;
  const std::set<std::thread::id> first = ThreadsOf(workers, 3);
  EXPECT_EQ(first.size(), 3u);
  EXPECT_EQ(first.count(std::this_thread::get_id()), 1u);
  for (int i = 0; i < 20; ++i)
  {
    EXPECT_EQ(ThreadsOf(workers, 3), first);
  }
}

TEST(WorkerThreads, AreWaitedForOnceThisOneIsDone)
{
  for (int i = 0; i < 20; ++i)
  {
    const std::thread::id own = std::this_thread::get_id();
    Meeting both(2);
    std::atomic<bool> isOwnDone{ false };
    std::atomic<int> done{ 0 };
    WorkerThreads::OfProcess().Share(
      [&]
      {
        both.Wait();
        if (std::this_thread::get_id() == own)
        {
          isOwnDone = true;
          return;
        }
        while (!isOwnDone)
        {
          std::this_thread::yield();
        }
        std::this_thread::yield();
        ++done;
      },
      1);
    EXPECT_EQ(done, 1);
  }
}

// Those that do not come are not waited for.
TEST(WorkerThreads, LeaveWorkToWhoHasSome)
{
  std::atomic<int> calls{ 0 };
  WorkerThreads::OfProcess().Share([&] { ++calls; }, 0);
  EXPECT_EQ(calls, 1);
  WorkerThreads::OfProcess().Share([&] { ++calls; }, 3);
  EXPECT_GE(calls, 2);
  EXPECT_LE(calls, 5);
}

TEST(WorkerThreads, ShareWorkWithinWork)
{
  std::atomic<int> calls{ 0 };
  WorkerThreads& workers = WorkerThreads::OfProcess();
  Meeting all(2);
  workers.Share(
    [&]
    {
      all.Wait();
      workers.Share([&] { ++calls; }, 1);
    },
    1);
  EXPECT_GE(calls, 2) << "each calls at least once";
  EXPECT_LE(calls, 4);
}

TEST(WorkerThreads, ServeSeveralAtOnce)
{
  std::vector<std::thread> others;
  for (int i = 0; i < 4; ++i)
  {
    others.emplace_back([] { EXPECT_EQ(ThreadsOf(WorkerThreads::OfProcess(), 2).size(), 2u); });
  }
  for (std::thread& other : others)
  {
    other.join();
  }
}

TEST(WorkerThreads, PassOnWhatIsThrownByAny)
{
  for (const bool isOwn : { false, true })
  {
    const std::thread::id own = std::this_thread::get_id();
    Meeting both(2);
    EXPECT_THROW(WorkerThreads::OfProcess().Share(
                   [&]
                   {
                     both.Wait();
                     if ((std::this_thread::get_id() == own) == isOwn)
                     {
                       throw std::runtime_error("one of them");
                     }
                   },
                   1),
      std::runtime_error);
  }
}
