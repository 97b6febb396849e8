/**
 * The results of `sorts` for people and for programs.
 */
#ifndef VITRINE_SORT_REPORT_H
#define VITRINE_SORT_REPORT_H

#include "sorts/SortMeasurement.h"

#include <string>

namespace program
{

/** Tables: times, ratios to the network, comparisons and speed by size; times by length. */
std::string ToTables(const SortComparison& comparison);

/** JSON: {"vitrine", "build", "device", "settings", "results", "lengths"}; docs/reference/json.md has the keys. */
std::string ToJson(const SortComparison& comparison);

}
#endif
