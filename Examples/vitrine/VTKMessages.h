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

  const std::vector<std::string>& Errors() const { return this->ErrorLines; }
  const std::vector<std::string>& Warnings() const { return this->WarningLines; }

private:
  friend class MessageWindow;
  std::vector<std::string> ErrorLines;
  std::vector<std::string> WarningLines;
  MessageCapture* Outer;
};

}
#endif
