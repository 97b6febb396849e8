#include "methods/Device.h"

#include "vtkRenderWindow.h"

#include <sstream>

namespace program
{

namespace
{
/** What follows `label` in the lines of a window's capabilities. */
std::string FindCapability(const std::string& capabilities, const std::string& label)
{
  std::istringstream lines(capabilities);
  std::string line;
  while (std::getline(lines, line))
  {
    if (line.compare(0, label.size(), label) == 0)
    {
      const std::size_t begin = line.find_first_not_of(" :", label.size());
      return begin == std::string::npos ? "" : line.substr(begin);
    }
  }
  return "";
}
}

Device DescribeDevice(vtkRenderWindow* window)
{
  const std::string capabilities = window->ReportCapabilities();
  return { FindCapability(capabilities, "OpenGL vendor string"),
    FindCapability(capabilities, "OpenGL renderer string"),
    FindCapability(capabilities, "OpenGL version string") };
}

}
