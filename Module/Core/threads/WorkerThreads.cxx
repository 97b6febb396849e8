#include "Core/threads/WorkerThreads.h"

#include <algorithm>
#include <system_error>
#include <thread>

namespace vitrine
{

WorkerThreads& WorkerThreads::OfProcess()
{
  static WorkerThreads* const threads = new WorkerThreads;
  return *threads;
}

void WorkerThreads::Share(const std::function<void()>& work, std::size_t helpers)
{
  Task task{ work, helpers };
  if (helpers > 0)
  {
    const std::lock_guard<std::mutex> lock(this->Lock);
    this->Begin(helpers);
    this->Tasks.push_back(&task);
    this->HasTasks.notify_all();
  }
  this->Call(task);
  std::unique_lock<std::mutex> lock(this->Lock);
  this->Tasks.erase(std::remove(this->Tasks.begin(), this->Tasks.end(), &task), this->Tasks.end());
  this->HasReturned.wait(lock, [&] { return task.Running == 0; });
  if (task.Thrown)
  {
    std::rethrow_exception(task.Thrown);
  }
}

/** Starts threads until there are `count`, or as many as the system permits. */
void WorkerThreads::Begin(std::size_t count)
{
  try
  {
    for (; this->Begun < count; ++this->Begun)
    {
      std::thread([this] { this->Help(); }).detach();
    }
  }
  catch (const std::system_error&)
  {
    // The existing threads do all the work.
  }
}

/** The loop of a thread, which runs as long as the process. */
void WorkerThreads::Help()
{
  std::unique_lock<std::mutex> lock(this->Lock);
  while (true)
  {
    this->HasTasks.wait(lock, [&] { return !this->Tasks.empty(); });
    Task& task = *this->Tasks.back();
    if (--task.Wanted == 0)
    {
      this->Tasks.pop_back();
    }
    ++task.Running;
    lock.unlock();
    this->Call(task);
    lock.lock();
    --task.Running;
    this->HasReturned.notify_all();
  }
}

void WorkerThreads::Call(Task& task)
{
  try
  {
    task.Work();
  }
  catch (...)
  {
    const std::lock_guard<std::mutex> lock(this->Lock);
    task.Thrown = std::current_exception();
  }
}

}
