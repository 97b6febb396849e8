#include "Progress.h"

#include <iostream>
#include <unistd.h>

namespace program
{

namespace
{
const char* const WipeLine = "\r\x1b[K";
}

Progress::Progress()
  : IsShown(isatty(STDERR_FILENO) == 1)
{
}

Progress::~Progress()
{
  this->Hide();
}

void Progress::Hide()
{
  if (this->IsShown)
  {
    std::cerr << WipeLine << std::flush;
  }
}

void Progress::SetTask(const std::string& task)
{
  this->Task = task;
}

void Progress::Show(const std::string& text)
{
  if (this->IsShown)
  {
    std::cerr << WipeLine << this->Task << text << std::flush;
  }
}

}
