/**
 * A chart as pictures.
 */
#ifndef VITRINE_CHART_PLOT_H
#define VITRINE_CHART_PLOT_H

#include "chart/ChartRecord.h"

namespace program
{

/**
 * Write error.png into the record's folder, and growth.png if anything grew. error.png plots the largest error against
 * frame time with its Pareto front, one plot for each scene. The record must be summarised.
 */
void PlotChart(const ChartRecord& record);

}
#endif
