#ifndef VITRINE_CORE_THREADS_WORKER_THREADS_H
#define VITRINE_CORE_THREADS_WORKER_THREADS_H

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <vector>

namespace vitrine
{

/**
 * Threads that wait for work from one frame to the next. A thread that is begun only then is put where the busy one is that begins it, and may
 * not run before that is done: on machines that slept between two frames most often. They wait as long as the process runs, and so must this. A process that is
 * forked has none of them, and does all work itself, unless it was forked while they were at work: then it may wait for them forever.
 */
class WorkerThreads
{
public:
  /** Those that all work of this process may share. */
  static WorkerThreads& OfProcess();

  /**
   * Calls some work in this thread and, at the same time, in others, and returns once all calls have. May be called within work, and by several threads.
   * @param helpers  how many others at most: those that come while this one is at it
   * @throws what one of the calls throws
   */
  void Share(const std::function<void()>& work, std::size_t helpers);

private:
  struct Task
  {
    const std::function<void()>& Work;
    std::size_t Wanted; ///< helpers that have not come
    std::size_t Running = 0;
    std::exception_ptr Thrown = nullptr;
  };

  void Begin(std::size_t count);
  void Help();
  void Call(Task& task);

  std::mutex Lock;
  std::condition_variable HasTasks, HasReturned;
  std::vector<Task*> Tasks; ///< that want helpers
  std::size_t Begun = 0;    ///< threads
};

}

#endif
