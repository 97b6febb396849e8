/**
 * What follows from the measurements of a chart: ratios, Pareto fronts, growth.
 */
#ifndef VITRINE_CHART_SUMMARY_H
#define VITRINE_CHART_SUMMARY_H

#include "report/Json.h"

namespace program
{

/**
 * Rows of results with "family", and "ratio" of their frame time to that of the method "ratio_to": vtk-oit, or the first that ran
 * in the same step.
 */
Json AddRatios(const Json& results);

/**
 * For each scene {"step", "scene", "width", "height", "truth_picture", "points", "fronts"}. A point is {"method", "family",
 * "values"}, by the name of each measure; "fronts" has, by the name of a cost and that of an error, the methods on the front in
 * order of cost. Values that a method does not tell are null, and it is on no such front. `results` come from AddRatios().
 */
Json SummariseScenes(const Json& results);

/**
 * For each quantity that was measured while another grew {"part", "cost", "title", "x", "y", "lines"}. A line is {"method", "family", "points",
 * "fit"}: pairs of x and y, and the power law fitted to them or null. Times are ratios to the method and the step that "y" names.
 */
Json SummariseGrowth(const Json& results);

}
#endif
