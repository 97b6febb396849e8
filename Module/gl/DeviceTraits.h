/** The traits of a device by which methods choose their paths. */
#ifndef VITRINE_GL_DEVICE_TRAITS_H
#define VITRINE_GL_DEVICE_TRAITS_H

#include <string>

namespace vitrine
{

/** The extension with which a fragment shader reads the framebuffer at its own pixel. */
inline constexpr const char* FramebufferFetchExtension = "GL_EXT_shader_framebuffer_fetch";

/** The extension with which a shader with early tests gets the samples that passed them. */
inline constexpr const char* PostDepthCoverageExtension = "GL_ARB_post_depth_coverage";

/** The features of a context's device. Another trait is a line here, and a word in the source file. */
struct DeviceTraits
{
  bool FramebufferFetch =
    false; ///< Methods store lists by framebuffer fetch. Otherwise they use atomics.
  bool PostDepthCoverage = false; ///< A shader with early tests gets the samples that passed them.
  bool Software = false;          ///< Shaders run on the CPU: IsSoftwareRasteriser().
};

/**
 * Ask the current context. Each word of the environment variable VITRINE_DEVICE ("no-fetch,no-software") takes a trait
 * away, so that other paths can be tested and measured on one device. Words that do not exist have no effect here.
 */
DeviceTraits FindDeviceTraits();

/** Returns an error message if VITRINE_DEVICE has a word that does not exist, or an empty string. */
std::string FindProblemOfDeviceSwitches();

/** Returns the value of VITRINE_DEVICE, or an empty string. */
std::string DeviceSwitches();

}
#endif
