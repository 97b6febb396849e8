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
 * Threads that wait for work from one frame to the next. A thread started on demand would begin on the processor of the
 * busy thread that creates it, and might not run before that is done. This happened most on machines that slept between
 * two frames.
 *
 * The threads and this object live as long as the process. A forked process has none of the threads and does all work
 * itself. If it was forked while they were at work, it may wait for them forever.
 */
class WorkerThreads
{
public:
  /** Returns the threads that the whole process shares. */
  static WorkerThreads& OfProcess();

  /**
   * Calls `work` in this thread and at the same time in others. Returns when all calls have returned. It may be called
   * within `work`, and by several threads.
   * @param helpers  largest number of other threads; only those that come before this thread is done take part
   * @throws         what one of the calls throws
   */
  void Share(const std::function<void()>& work, std::size_t helpers);

private:
  struct Task
  {
    const std::function<void()>& Work;
    std::size_t Wanted; ///< Helpers that have not come yet.
    std::size_t Running = 0;
    std::exception_ptr Thrown = nullptr;
  };

  void Begin(std::size_t count);
  void Help();
  void Call(Task& task);

  std::mutex Lock;
  std::condition_variable HasTasks, HasReturned;
  std::vector<Task*> Tasks; ///< Tasks that want helpers.
  std::size_t Begun = 0;    ///< Number of started threads.
};

}

#endif
