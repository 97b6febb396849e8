/**
 * Methods side by side: what `compare` measures.
 */
#ifndef VITRINE_COMPARISON_H
#define VITRINE_COMPARISON_H

#include "Progress.h"
#include "methods/Stage.h"
#include "scene/Scene.h"
#include "study/image/ImageError.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace program
{

struct ComparisonSettings
{
  std::vector<std::string> Methods;
  PictureSize Size;
  int Multisamples = 0;
  Coincidence Tolerance; ///< of truth, and of methods that have one
  double Opacity = 1.0;  ///< multiplied into the scene
  View From;             ///< of the first frame
  int Frames = 9;        ///< timed, of each method
  double Orbit = 30.0;   ///< degrees from the first frame to the last
};

/** What was measured of one method. */
struct MethodResult
{
  std::string Method;
  std::string Skipped; ///< why it did not draw every frame; the rest is void then
  std::vector<double> FrameMilliseconds;
  MethodStatistics Statistics; ///< of the last frame; the passes are the median of the timed ones'
  std::optional<vitrine::ImageError> Error; ///< the worse of the first and the last frame
  std::vector<std::uint8_t> Picture;        ///< the first frame, as Stage::ReadPixels() gives it
  bool IsDeterministic = true;

  double Median() const;
};

struct ComparisonResult
{
  std::string Scene;
  ComparisonSettings Settings;
  Device GL;
  std::vector<MethodResult> Results;
  std::vector<std::uint8_t> TruthPicture; ///< of the first frame; empty if truth cannot run here
  std::string Advice;                     ///< OpacityAdvice() of the scene
};

/**
 * Draw the scene by every method, of which there is one at least, taken in turn frame by frame while the camera goes
 * round, and compare the first and the last picture with truth.
 */
ComparisonResult CompareMethods(
  const Scene& scene, const ComparisonSettings& settings, Progress& progress);

}
#endif
