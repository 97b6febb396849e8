#include "gl/StageTimer.h"

#include "gl/Capabilities.h"

#include <algorithm>
#include <cstring>

namespace vitrine
{

namespace
{

// A device that is further behind than this has lost a query.
constexpr std::size_t MostFramesBehind = 8;

}

//------------------------------------------------------------------------------
void StageTimer::SetOn(bool on)
{
  this->IsOn = on;
  this->Times.clear();
}

void StageTimer::BeginFrame()
{
  this->Collect();
  if (this->IsOn)
  {
    this->Frames.emplace_back();
  }
}

void StageTimer::Collect()
{
  while (!this->Frames.empty() && this->HasResults(this->Frames.front()))
  {
    if (this->IsOn && !this->Frames.front().empty())
    {
      this->Read(this->Frames.front());
    }
    this->Recycle(this->Frames.front());
    this->Frames.pop_front();
  }
  while (this->Frames.size() > MostFramesBehind)
  {
    this->Recycle(this->Frames.front());
    this->Frames.pop_front();
  }
}

void StageTimer::Release()
{
  for (const Frame& frame : this->Frames)
  {
    this->Recycle(frame);
  }
  this->Frames.clear();
  if (!this->Unused.empty())
  {
    glDeleteQueries(static_cast<GLsizei>(this->Unused.size()), this->Unused.data());
    this->Unused.clear();
  }
  this->Support = SupportType::UNKNOWN;
  this->Times.clear();
}

//------------------------------------------------------------------------------
bool StageTimer::CanBegin()
{
  if (this->Support == SupportType::UNKNOWN)
  {
    this->Support = HasTimeQueries(GL_TIME_ELAPSED) ? SupportType::YES : SupportType::NO;
  }
  if (this->Support == SupportType::NO)
  {
    return false;
  }
  GLint active = 0;
  glGetQueryiv(GL_TIME_ELAPSED, GL_CURRENT_QUERY, &active);
  return active == 0;
}

GLuint StageTimer::UnusedQuery()
{
  GLuint query = 0;
  if (this->Unused.empty())
  {
    glGenQueries(1, &query);
    return query;
  }
  query = this->Unused.back();
  this->Unused.pop_back();
  return query;
}

// Queries end in turn, so the last one has its result when all have.
bool StageTimer::HasResults(const Frame& frame) const
{
  GLint available = 1;
  if (!frame.empty())
  {
    glGetQueryObjectiv(frame.back().second, GL_QUERY_RESULT_AVAILABLE, &available);
  }
  return available != 0;
}

void StageTimer::Read(const Frame& frame)
{
  this->Times.clear();
  for (const auto& [stage, query] : frame)
  {
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
    const double seconds = 1e-9 * static_cast<double>(nanoseconds);
    const auto found = std::find_if(this->Times.begin(), this->Times.end(),
      [name = stage](const auto& each) { return std::strcmp(each.first, name) == 0; });
    if (found == this->Times.end())
    {
      this->Times.emplace_back(stage, seconds);
    }
    else
    {
      found->second += seconds;
    }
  }
}

void StageTimer::Recycle(const Frame& frame)
{
  for (const auto& [stage, query] : frame)
  {
    this->Unused.push_back(query);
  }
}

//------------------------------------------------------------------------------
StageTimer::Section::Section(StageTimer& timer, const char* stage)
  : IsTimed(timer.IsOn && !timer.Frames.empty() && timer.CanBegin())
{
  if (this->IsTimed)
  {
    timer.Frames.back().emplace_back(stage, timer.UnusedQuery());
    glBeginQuery(GL_TIME_ELAPSED, timer.Frames.back().back().second);
  }
}

StageTimer::Section::~Section()
{
  if (this->IsTimed)
  {
    glEndQuery(GL_TIME_ELAPSED);
  }
}

}
