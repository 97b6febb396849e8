/** How long frames take, on the CPU or on the device, whichever is longer. */
#ifndef VITRINE_FRAME_FRAME_CLOCK_H
#define VITRINE_FRAME_FRAME_CLOCK_H

#include "gl/HeldContext.h"
#include "gl/VitrineOpenGL.h"

#include <array>
#include <chrono>
#include <deque>
#include <vector>

class vtkRenderer;

namespace vitrine
{

/**
 * Measures frames by time stamps of the device (glQueryCounter), which are read when the device has them, so nothing
 * waits. Without such queries, the time on the CPU counts alone.
 */
class FrameClock
{
public:
  struct Frame
  {
    double Budget = 0.0; ///< what was told of the frame
    double Milliseconds = 0.0;
  };

  FrameClock() = default;
  ~FrameClock();
  FrameClock(const FrameClock&) = delete;
  void operator=(const FrameClock&) = delete;

  /** Begin a frame of a renderer, whose context is current. Returns the frames that the device has finished. */
  std::vector<Frame> Begin(vtkRenderer* renderer);

  void End(double budget);

  /** Release the queries. */
  void Release();

private:
  struct Pending
  {
    Frame Told;
    std::array<GLuint, 2> Stamps{};
  };

  void Hold(vtkRenderer* renderer);
  std::array<GLuint, 2> NewStamps();
  std::vector<Frame> TakeFinished();

  HeldContext Context;
  bool HasStamps = false; // The device has queries of time stamps.
  std::deque<Pending> Frames;
  std::vector<std::array<GLuint, 2>> Unused;
  std::array<GLuint, 2> Current{};
  std::chrono::steady_clock::time_point Start;
};

}

#endif
