/**
 * The device that draws.
 */
#ifndef VITRINE_DEVICE_H
#define VITRINE_DEVICE_H

#include <string>

class vtkRenderWindow;

namespace program
{

/** What the device says of itself. */
struct Device
{
  std::string Vendor;
  std::string Renderer;
  std::string Version;
};

/** The device of a window that has a context. */
Device DescribeDevice(vtkRenderWindow* window);

}
#endif
