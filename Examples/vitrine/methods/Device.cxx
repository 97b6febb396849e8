#include "methods/Device.h"

#include "gl/Capabilities.h"
#include "gl/DeviceTraits.h"
#include "gl/VitrineOpenGL.h"

#include "vtkRenderWindow.h"

#include <algorithm>
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

bool HasOneOf(const std::vector<const char*>& extensions)
{
  return std::any_of(extensions.begin(), extensions.end(), vitrine::HasExtension);
}

std::vector<DeviceFeature> FindFeatures()
{
  return { { "framebuffer_fetch", HasOneOf({ vitrine::FramebufferFetchExtension }) },
    { "interlock",
      HasOneOf({ "GL_ARB_fragment_shader_interlock", "GL_NV_fragment_shader_interlock",
        "GL_INTEL_fragment_shader_ordering" }) },
    { "ballot",
      HasOneOf({ "GL_ARB_shader_ballot", "GL_NV_shader_thread_group", "GL_KHR_shader_subgroup" }) },
    { "post_depth_coverage",
      HasOneOf({ "GL_ARB_post_depth_coverage", "GL_EXT_post_depth_coverage" }) } };
}
}

Device DescribeDevice(vtkRenderWindow* window)
{
  const std::string capabilities = window->ReportCapabilities();
  Device device;
  device.Vendor = FindCapability(capabilities, "OpenGL vendor string");
  device.Renderer = FindCapability(capabilities, "OpenGL renderer string");
  device.Version = FindCapability(capabilities, "OpenGL version string");
  window->MakeCurrent();
  if (vitrine::MissingFeatures(4, 3, {}).empty())
  {
    device.StorageBlockBytes = vitrine::LargestStorageBlock();
  }
  device.BufferTextureTexels = vitrine::LargestBufferTexture();
  GLint samples = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &samples);
  device.Samples = samples;
  device.Features = FindFeatures();
  device.Switches = vitrine::DeviceSwitches();
  return device;
}

}
