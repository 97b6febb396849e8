/**
 * The results of `lights` for people and for programs.
 */
#ifndef VITRINE_LIGHTS_REPORT_H
#define VITRINE_LIGHTS_REPORT_H

#include "lighting/LightingMeasurement.h"

#include <string>
#include <vector>

namespace program
{

/** A table, a row for each input and mode. */
std::string ToTable(const std::vector<LightingRun>& runs, const Device& device);

/** JSON: {"vitrine", "build", "device", "settings", "results"}; docs/reference/json.md lists the keys. */
std::string ToJson(
  const std::vector<LightingRun>& runs, const LightingPlan& plan, const Device& device);

}
#endif
