/**
 * Ways of drawing lights side by side: what `lights` measures.
 */
#ifndef VITRINE_LIGHTING_MEASUREMENT_H
#define VITRINE_LIGHTING_MEASUREMENT_H

#include "Progress.h"
#include "lighting/LightingMode.h"
#include "methods/Device.h"
#include "methods/Stage.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace program
{

struct LightingPlan
{
  std::vector<std::string> Modes;
  LightingSettings Settings; ///< of all modes
  PictureSize Size = { 640, 480 };
  int Frames = 9;         ///< timed, of each mode
  double Orbit = 30.0;    ///< degrees from the first frame to the last
  bool ShowsHeat = false; ///< in a picture of the last frame
};

/** What was measured of one mode. */
struct ModeResult
{
  std::string Mode;
  std::string Skipped; ///< why it did not draw every frame; the rest is void then
  std::optional<double>
    FirstFrameMilliseconds; ///< with shaders that are built, and buffers that are filled
  std::vector<double> FrameMilliseconds;
  LightingStatistics Statistics; ///< of the last frame
  std::optional<double> Error; ///< the largest of a channel, in the first and the last frame, of 1
};

/** One input by all modes. */
struct LightingRun
{
  std::string Name;
  std::size_t Lights = 0;
  std::string Reference; ///< the mode that errors are against; empty if there is none
  std::vector<ModeResult> Results;
  std::string Unfinished; ///< what is being done; empty when all is done
  std::vector<std::uint8_t>
    Heat; ///< of the last mode that was not skipped, if it is asked for; may be empty
};

/**
 * Draw the scene by every mode, taken in turn frame by frame while the camera goes round.
 * @param changed  is called with what was measured so far, before each thing that is done
 */
LightingRun MeasureLighting(const Scene& scene, const LightingPlan& plan, Progress& progress,
  const std::function<void(const LightingRun&)>& changed);

}
#endif
