/**
 * A picture and its baselines, for people and for programs.
 */
#ifndef VITRINE_DIFF_REPORT_H
#define VITRINE_DIFF_REPORT_H

#include "diff/BaselineDiff.h"

#include <string>

namespace program
{

/** One line where the picture matches a baseline; else what differs, baseline by baseline, the closest first. */
std::string ToText(const PictureDiff& diff);

std::string ToJson(const PictureDiff& diff);

}
#endif
