/**
 * The results of `compare` for people and for programs.
 */
#ifndef VITRINE_COMPARISON_REPORT_H
#define VITRINE_COMPARISON_REPORT_H

#include "commands/Comparison.h"

#include <string>

namespace program
{

/** A table, one line for each method. */
std::string ToTable(const ComparisonResult& comparison);

/** JSON: {"vitrine", "build", "device", "settings", "results"}. */
std::string ToJson(const ComparisonResult& comparison);

}
#endif
