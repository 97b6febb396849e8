/**
 * The device that draws.
 */
#ifndef VITRINE_DEVICE_H
#define VITRINE_DEVICE_H

#include <cstdint>
#include <string>
#include <vector>

class vtkRenderWindow;

namespace program
{

/** Whether the device has a feature on which a method's path may depend. */
struct DeviceFeature
{
  std::string Name; ///< as in JSON
  bool IsThere;
};

/** What the device says of itself. */
struct Device
{
  std::string Vendor;
  std::string Renderer;
  std::string Version;
  std::int64_t StorageBlockBytes =
    0; ///< of the largest shader storage block; 0 without storage blocks
  std::int64_t BufferTextureTexels = 0; ///< of the largest buffer texture
  std::int64_t Samples = 0;             ///< of a pixel, at most
  std::vector<DeviceFeature> Features;  ///< whether switched off or not
  std::string Switches;                 ///< VITRINE_DEVICE
};

/** The device of a window that has a context. */
Device DescribeDevice(vtkRenderWindow* window);

}
#endif
