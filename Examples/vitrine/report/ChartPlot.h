/**
 * A chart as pictures.
 */
#ifndef VITRINE_CHART_PLOT_H
#define VITRINE_CHART_PLOT_H

#include "chart/ChartRecord.h"

namespace program
{

/**
 * Write error.png, the largest error against frame time with its Pareto front, one plot for each scene, and growth.png, if anything
 * grew, into the record's folder. The record is summarised.
 */
void PlotChart(const ChartRecord& record);

}
#endif
