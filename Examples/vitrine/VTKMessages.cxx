#include "VTKMessages.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <algorithm>
#include <cctype>
#include <iostream>
#include <iterator>
#include <set>

namespace program
{

namespace
{
MessageCapture* Current = nullptr;

/** "ERROR: In FILE, line N\nvtkClass (0x...): text\n\n" becomes "vtkClass: text". */
std::string ToLine(const std::string& message)
{
  std::string text = message;
  const std::size_t head = text.find(", line ");
  if (head != std::string::npos)
  {
    const std::size_t end = text.find('\n', head);
    text.erase(0, end == std::string::npos ? text.size() : end + 1);
  }
  const std::size_t address = text.find(" (0x");
  if (address != std::string::npos && text.find(')', address) != std::string::npos)
  {
    text.erase(address, text.find(')', address) + 1 - address);
  }
  std::replace_if(
    text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  const std::size_t last = text.find_last_not_of(' ');
  return text.substr(0, last + 1);
}
}

/** Where VTK sends its messages. */
class MessageWindow : public vtkOutputWindow
{
public:
  static MessageWindow* New();
  vtkTypeMacro(MessageWindow, vtkOutputWindow);

  void DisplayErrorText(const char* text) override
  {
    this->Take(text, Current ? &Current->ErrorLines : nullptr);
  }
  void DisplayWarningText(const char* text) override
  {
    this->Take(text, Current ? &Current->WarningLines : nullptr);
  }
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }
  void DisplayText(const char* text) override { this->DisplayWarningText(text); }

private:
  void Take(const char* text, std::vector<std::string>* kept)
  {
    const std::string line = ToLine(text);
    if (kept)
    {
      kept->push_back(line);
    }
    else if (this->Shown.insert(line).second)
    {
      std::cerr << "vitrine: " << line << "\n";
    }
  }

  std::set<std::string> Shown;
};
vtkStandardNewMacro(MessageWindow);

void InstallMessageLines()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // it repeats what comes to the window
  vtkNew<MessageWindow> window;
  vtkOutputWindow::SetInstance(window);
}

MessageCapture::MessageCapture()
  : Outer(Current)
{
  Current = this;
}

MessageCapture::~MessageCapture()
{
  Current = this->Outer;
}

void MessageCapture::ShowAllBut(const std::vector<std::string>& reasons)
{
  Current = this->Outer;
  for (const std::string& line : LinesWithout(this->ErrorLines, reasons))
  {
    vtkOutputWindow::GetInstance()->DisplayErrorText(line.c_str());
  }
  for (const std::string& line : LinesWithout(this->WarningLines, reasons))
  {
    vtkOutputWindow::GetInstance()->DisplayWarningText(line.c_str());
  }
  Current = this;
}

std::vector<std::string> LinesWithout(
  const std::vector<std::string>& lines, const std::vector<std::string>& reasons)
{
  std::vector<std::string> others;
  std::copy_if(lines.begin(), lines.end(), std::back_inserter(others),
    [&reasons](const std::string& line)
    {
      return std::none_of(reasons.begin(), reasons.end(),
        [&line](const std::string& reason)
        { return !reason.empty() && line.find(reason) != std::string::npos; });
    });
  return others;
}

}
