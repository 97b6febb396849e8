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
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace program
{

struct ComparisonSettings
{
  std::vector<std::string> Methods;
  PictureSize Size;
  int Multisamples = 0;
  std::optional<double> ErrorBudget; ///< of the method automatic
  Coincidence Tolerance;             ///< of truth, and of methods that have one
  double Opacity = 1.0;              ///< multiplied into the scene
  View From;                         ///< of the first frame
  int Frames = 9;                    ///< timed, of each method
  double Orbit = 30.0;               ///< degrees from the first frame to the last
  bool MeasuresStages = false;       ///< on the device
  bool IsJudged = true;              ///< by truth, which is slow
};

/** What was measured of one method. */
struct MethodResult
{
  std::string Method;
  std::string Skipped; ///< why it did not draw every frame; the rest is void then
  std::optional<double>
    FirstFrameMilliseconds; ///< with shaders that are built; nothing if it is not drawn yet
  std::vector<double> FrameMilliseconds;
  std::vector<StageTimes> Stages; ///< of the timed frames, if stages are measured
  MethodStatistics Statistics; ///< of the last frame; the passes are the median of the timed ones'
  std::optional<vitrine::ImageError> Error; ///< the worse of the first and the last frame
  std::vector<std::uint8_t> Picture;        ///< the first frame, as Stage::ReadPixels() gives it
  bool IsDeterministic = true;

  double Median() const;
};

/** The times of each stage over the timed frames, in milliseconds; stages in the order in which they first began. */
std::vector<std::pair<std::string, std::vector<double>>> TimesOfStages(const MethodResult& result);

struct ComparisonResult
{
  std::string Scene;
  ComparisonSettings Settings;
  Device GL;
  std::vector<MethodResult> Results;
  std::vector<std::uint8_t> TruthPicture; ///< of the first frame; empty if truth cannot run here
  std::string Advice;                     ///< OpacityAdvice() of the scene
  std::string Unfinished;                 ///< what is being done; empty when all is done
};

/**
 * The time of the method automatic over that of the fastest method whose error is within the budget, and that method's
 * name. Nothing if automatic was not drawn or not judged, or if there is no other method within the budget.
 */
struct Regret
{
  double Ratio = 1.0;
  std::string Fastest;
};
std::optional<Regret> RegretOf(const ComparisonResult& comparison);

/** Takes what was measured so far. */
using ComparisonListener = std::function<void(const ComparisonResult&)>;

/**
 * Draw the scene by every method, of which there is one at least, taken in turn frame by frame while the camera goes
 * round, and compare the first and the last picture with truth.
 * @param changed  is called before each thing that is done, so that a run that is cut off leaves what it has
 */
ComparisonResult CompareMethods(const Scene& scene, const ComparisonSettings& settings,
  Progress& progress, const ComparisonListener& changed = nullptr);

}
#endif
