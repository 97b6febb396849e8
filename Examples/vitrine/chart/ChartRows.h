/**
 * Whether rows of a chart.json are such as a chart writes: anyone can have edited them.
 */
#ifndef VITRINE_CHART_ROWS_H
#define VITRINE_CHART_ROWS_H

#include "report/Json.h"

#include <string>

namespace program
{

/** The path of the picture `name` below a chart's folder. */
std::string PicturePath(const std::string& name);

/** Whether a row of "results" has what is read from it: what compare tells, a part, and a step from 0. */
bool IsChartResult(const Json& row);

/**
 * Returns true if a row of "failures" has the values that are read from it. Pictures may be missing if the method was
 * refused.
 */
bool IsChartCell(const Json& row);

}
#endif
