/**
 * What a chart has on its axes.
 */
#ifndef VITRINE_CHART_MEASURES_H
#define VITRINE_CHART_MEASURES_H

#include "report/Json.h"

#include <string>
#include <vector>

namespace program
{

/** A quantity of a row of results, less of which is better. */
struct ChartMeasure
{
  std::string Name;                ///< in chart.json and on the page
  std::string Title;               ///< of an axis
  double (*Read)(const Json& row); ///< NaN where the row does not tell
  bool IsLogarithmic = true;
};

/** The number `key` of a row; NaN where it has none. */
double NumberOrNaN(const Json& row, const char* key);

/** Frame time as a ratio, memory, geometry passes. */
const std::vector<ChartMeasure>& CostMeasures();

/** The largest difference, RMSE, PSNR, SSIM, FLIP, wrong pixels; made so that less is better. */
const std::vector<ChartMeasure>& ErrorMeasures();

}
#endif
