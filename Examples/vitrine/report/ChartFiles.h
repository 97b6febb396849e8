/**
 * The files of a chart, once everything is measured.
 */
#ifndef VITRINE_CHART_FILES_H
#define VITRINE_CHART_FILES_H

#include "chart/ChartRecord.h"

#include <string>

namespace program
{

/**
 * Complete chart.json with the results of the measurements, and write the plots and the page. Returns the page's path.
 * Throws InputError if a file cannot be written, or if a picture is missing.
 */
std::string WriteChart(ChartRecord& record);

}
#endif
