/** Times that a frame's stages take on the device. */
#ifndef VITRINE_GL_STAGE_TIMER_H
#define VITRINE_GL_STAGE_TIMER_H

#include "gl/VitrineOpenGL.h"

#include <deque>
#include <utility>
#include <vector>

namespace vitrine
{

/**
 * Times sections of frames by queries of GL_TIME_ELAPSED. The results are read when the device has them, so nothing
 * waits. A timer that is off makes no OpenGL call.
 *
 * Sections must not be nested, since OpenGL has one such query at a time. A section that begins while another query is
 * active is not timed. The time of a section includes the time that the device waits for the CPU within it.
 */
class StageTimer
{
public:
  /** Names of stages and their times in seconds, in the order in which they first began. */
  using StageTimes = std::vector<std::pair<const char*, double>>;

  /** Turn the timer on, or off. If it is off there are no times. */
  void SetOn(bool on);

  /** Begin a frame. Calls Collect(). */
  void BeginFrame();

  /** Read the results of frames that the device has finished. The context must be current. */
  void Collect();

  /** The times of the latest frame whose results were read. Sections of the same name are added up. */
  const StageTimes& Latest() const { return this->Times; }

  /** Release the queries. Their context must be current. */
  void Release();

  /** Times a stage of the current frame during its lifetime. The name must outlive the timer. */
  class Section
  {
  public:
    Section(StageTimer& timer, const char* stage);
    ~Section();
    Section(const Section&) = delete;
    void operator=(const Section&) = delete;

  private:
    bool IsTimed;
  };

private:
  using Frame = std::vector<std::pair<const char*, GLuint>>; // Stages and their queries.

  bool CanBegin();
  GLuint UnusedQuery();
  bool HasResults(const Frame& frame) const;
  void Read(const Frame& frame);
  void Recycle(const Frame& frame);

  enum class SupportType
  {
    UNKNOWN,
    YES,
    NO
  };

  bool IsOn = false;
  SupportType Support = SupportType::UNKNOWN;
  std::deque<Frame> Frames; // Frames whose results have not been read. The current one is the last.
  std::vector<GLuint> Unused;
  StageTimes Times;
};

}
#endif
