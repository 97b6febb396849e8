/**
 * The results of `stability` for people and for programs.
 */
#ifndef VITRINE_STABILITY_REPORT_H
#define VITRINE_STABILITY_REPORT_H

#include "methods/Device.h"
#include "report/Json.h"
#include "stability/Stability.h"

#include <string>
#include <vector>

namespace program
{

struct StabilityResult
{
  StabilitySettings Settings;
  Device GL;
  std::vector<StabilityCell> Cells; ///< scene by scene, as far as they are measured
};

/** What stands before the first table: the device. */
std::string TableHead(const StabilityResult& result);

/** The table of a scene. */
std::string SceneTable(const StabilityScene& scene, const std::vector<StabilityCell>& cells);

/** Each method's worst scene. */
std::string WorstTable(const StabilityResult& result);

/** One cell, without its pictures; {"scene", "method", "width", "height", "skipped", ...} if it could not run. */
Json ToJsonRow(const StabilityCell& cell);

/**
 * Returns {"name", "input", "opacity", "expected", "zoom_before", "width", "height", "heavy"} for each scene. Width and
 * height are null if the scene has no size of its own.
 */
Json ScenesJson(const std::vector<StabilityScene>& scenes);

/** {"vitrine", "build", "device", "settings", "scenes", "results"}. */
std::string ToJson(const StabilityResult& result);

}
#endif
