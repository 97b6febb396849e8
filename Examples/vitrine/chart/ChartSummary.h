/**
 * What follows from the measurements of a chart: ratios, Pareto fronts, growth.
 */
#ifndef VITRINE_CHART_SUMMARY_H
#define VITRINE_CHART_SUMMARY_H

#include "report/Json.h"

namespace program
{

/**
 * Returns the rows of results with "family" and "ratio". The ratio is their frame time over that of the method
 * "ratio_to": vtk-oit, or the first method that ran in the same step.
 */
Json AddRatios(const Json& results);

/**
 * Returns {"step", "scene", "width", "height", "truth_picture", "points", "fronts"} for each scene.
 *
 * A point is {"method", "family", "values"}, with values by the name of each measure. A value that a method does not
 * report is null, and the method is on no front of that measure. "fronts" has, by the name of a cost and the name of an
 * error, the methods on the front in order of cost. `results` come from AddRatios().
 */
Json SummariseScenes(const Json& results);

/**
 * Returns {"part", "cost", "title", "x", "y", "lines"} for each quantity that was measured while another one grew.
 *
 * A line is {"method", "family", "points", "fit"}: pairs of x and y, and the power law fitted to them, or null. Times
 * are ratios to the method and the step that "y" names.
 */
Json SummariseGrowth(const Json& results);

}
#endif
