#include "frame/FrameClock.h"

#include "gl/Capabilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace vitrine
{

namespace
{

// A device that is further behind than this has lost a query.
constexpr std::size_t MostPending = 8;

double MillisecondsBetween(const std::array<GLuint, 2>& stamps)
{
  GLuint64 times[2] = { 0, 0 };
  glGetQueryObjectui64v(stamps[0], GL_QUERY_RESULT, &times[0]);
  glGetQueryObjectui64v(stamps[1], GL_QUERY_RESULT, &times[1]);
  return 1e-6 * static_cast<double>(times[1] - times[0]);
}

}

//------------------------------------------------------------------------------
FrameClock::~FrameClock()
{
  this->Release();
}

//------------------------------------------------------------------------------
void FrameClock::Release()
{
  this->Context.Release(
    [this](vtkOpenGLRenderWindow*)
    {
      for (const Pending& frame : this->Frames)
      {
        this->Unused.push_back(frame.Stamps);
      }
      for (const std::array<GLuint, 2>& stamps : this->Unused)
      {
        glDeleteQueries(2, stamps.data());
      }
    });
  this->Frames.clear();
  this->Unused.clear();
  this->Context.LetGo();
}

//------------------------------------------------------------------------------
void FrameClock::Hold(vtkRenderer* renderer)
{
  vtkWindow* const window = renderer->GetRenderWindow();
  if (this->Context.LivesIn(window))
  {
    return;
  }
  this->Release();
  this->Context.Hold(vtkOpenGLRenderWindow::SafeDownCast(window));
  this->HasStamps = HasTimeQueries(GL_TIMESTAMP);
}

//------------------------------------------------------------------------------
std::vector<FrameClock::Frame> FrameClock::Begin(vtkRenderer* renderer)
{
  this->Hold(renderer);
  std::vector<Frame> finished = this->TakeFinished();
  if (this->HasStamps)
  {
    this->Current = this->NewStamps();
    glQueryCounter(this->Current[0], GL_TIMESTAMP);
  }
  this->Start = std::chrono::steady_clock::now();
  return finished;
}

//------------------------------------------------------------------------------
void FrameClock::End(double budget)
{
  const std::chrono::duration<double, std::milli> passed =
    std::chrono::steady_clock::now() - this->Start;
  if (this->HasStamps)
  {
    glQueryCounter(this->Current[1], GL_TIMESTAMP);
  }
  this->Frames.push_back({ { budget, passed.count() }, this->Current });
}

//------------------------------------------------------------------------------
std::array<GLuint, 2> FrameClock::NewStamps()
{
  std::array<GLuint, 2> stamps{};
  if (this->Unused.empty())
  {
    glGenQueries(2, stamps.data());
    return stamps;
  }
  stamps = this->Unused.back();
  this->Unused.pop_back();
  return stamps;
}

//------------------------------------------------------------------------------
std::vector<FrameClock::Frame> FrameClock::TakeFinished()
{
  std::vector<Frame> finished;
  for (; !this->Frames.empty(); this->Frames.pop_front())
  {
    Pending& first = this->Frames.front();
    if (this->HasStamps)
    {
      GLint available = 0;
      glGetQueryObjectiv(first.Stamps[1], GL_QUERY_RESULT_AVAILABLE, &available);
      const bool isLost = this->Frames.size() > MostPending;
      if (!available && !isLost)
      {
        break;
      }
      this->Unused.push_back(first.Stamps);
      if (!available)
      {
        continue;
      }
      first.Told.Milliseconds =
        std::max(first.Told.Milliseconds, MillisecondsBetween(first.Stamps));
    }
    finished.push_back(first.Told);
  }
  return finished;
}

}
