/**
 * One line on stderr that tells how far long work has got.
 */
#ifndef VITRINE_PROGRESS_H
#define VITRINE_PROGRESS_H

#include <string>

namespace program
{

/** Shows nothing unless stderr is a terminal. Its line is wiped when it goes. */
class Progress
{
public:
  Progress();
  ~Progress();

  /** Put `task` before all lines from now on: of what the work that shows them is a part. */
  void SetTask(const std::string& task);

  /** Wipe the line, for something else to be printed there. */
  void Hide();

  /** Replace the line. */
  void Show(const std::string& text);

private:
  bool IsShown;
  std::string Task;
};

}
#endif
