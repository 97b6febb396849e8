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

  /** Replace the line. */
  void Show(const std::string& text);

private:
  bool IsShown;
};

}
#endif
