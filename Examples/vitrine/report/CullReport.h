/**
 * The results of `cull` for people and for programs.
 */
#ifndef VITRINE_PROGRAM_CULL_REPORT_H
#define VITRINE_PROGRAM_CULL_REPORT_H

#include "culling/CullMeasurement.h"

#include <string>
#include <vector>

namespace program
{

/** A table, a row for each input; below it modes of frames and reasons of props, most frequent first. */
std::string ToTable(const std::vector<CullRun>& runs);

/** JSON: {"vitrine", "build", "device", "settings", "results"}; docs/reference/json.md lists the keys. */
std::string ToJson(const std::vector<CullRun>& runs, const std::string& unfinished = "");

/** Pixels that differ, of all inputs. */
std::int64_t CountWrongPixels(const std::vector<CullRun>& runs);

}

#endif
