/**
 * Counts calls of OpenGL by VTK and Vitrine on their way to the driver.
 */
#ifndef VITRINE_TEST_CALL_COUNTER_H
#define VITRINE_TEST_CALL_COUNTER_H

#include <map>
#include <ostream>
#include <string>

/** Numbers of calls. */
struct CallCounts
{
  int Queries =
    0; // glGet... and glIs... of state, limits and objects, and glCheckFramebufferStatus
  int BlockingReads = 0;             // of buffers and pictures into the memory of the CPU
  int Reallocations = 0;             // of buffers and images
  int Uploads = 0;                   // into buffers, but of vertices and indices
  std::map<std::string, int> ByCall; // all of these, by function and what it is asked for

  /** A line for each call of ByCall. */
  std::string List() const;
};

std::ostream& operator<<(std::ostream& os, const CallCounts& counts);

/** Counts while it lives. Make it after a first frame, since VTK loads OpenGL's functions then. One at a time. */
class CallCounter
{
public:
  CallCounter();
  ~CallCounter();
  CallCounter(const CallCounter&) = delete;
  void operator=(const CallCounter&) = delete;

  const CallCounts& Counts() const;

private:
  struct Hooks;
  Hooks* Hooked;
};

#endif
