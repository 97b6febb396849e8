/**
 * Measures what a chart shows, step by step, into a record that is complete after each.
 */
#ifndef VITRINE_CHART_MEASUREMENT_H
#define VITRINE_CHART_MEASUREMENT_H

#include "chart/ChartPlan.h"
#include "chart/ChartRecord.h"

namespace program
{

/** The device that a chart would be measured on. Throws RuntimeError if there is no OpenGL to draw with. */
Device FindDevice();

/** {"vitrine", "build", "device", "settings"} of a chart: what must be alike for measurements to stand in one chart. */
Json ChartHead(const ChartPlan& plan, const Device& device);

/** Measure the steps of the plan that the record lacks: the rows "results". */
void MeasureSteps(const ChartPlan& plan, ChartRecord& record, Progress& progress);

/** Measure the cells of the plan that the record lacks: the rows "failures". */
void MeasureFailures(const ChartPlan& plan, ChartRecord& record, Progress& progress);

/**
 * Add the results and pictures of a comparison, which is step `number` of the part "scenes". The rows are those of
 * `compare`, with "part", "step", "picture" and "truth_picture" in each.
 */
void RecordScene(const ComparisonResult& comparison, int number, ChartRecord& record);

}
#endif
