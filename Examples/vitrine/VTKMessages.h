/**
 * What VTK says, as single lines.
 */
#ifndef VITRINE_VTK_MESSAGES_H
#define VITRINE_VTK_MESSAGES_H

#include <string>
#include <vector>

namespace program
{

/** Have VTK's errors and warnings come as one line each on stderr, the same line only once. */
void InstallMessageLines();

/** While it lives, VTK's messages are kept instead of shown. */
class MessageCapture
{
public:
  MessageCapture();
  ~MessageCapture();
  MessageCapture(const MessageCapture&) = delete;
  MessageCapture& operator=(const MessageCapture&) = delete;

  /** Show all other errors and warnings after all. Those that contain one of the reasons are reported elsewhere. */
  void ShowAllBut(const std::vector<std::string>& reasons);

  const std::vector<std::string>& Errors() const { return this->ErrorLines; }
  const std::vector<std::string>& Warnings() const { return this->WarningLines; }

private:
  friend class MessageWindow;
  std::vector<std::string> ErrorLines;
  std::vector<std::string> WarningLines;
  MessageCapture* Outer;
};

/** The lines that have none of the reasons in them, other than empty ones. */
std::vector<std::string> LinesWithout(
  const std::vector<std::string>& lines, const std::vector<std::string>& reasons);

}
#endif
