/**
 * A chart as a page for browsers.
 */
#ifndef VITRINE_CHART_PAGE_H
#define VITRINE_CHART_PAGE_H

#include "chart/ChartRecord.h"

#include <string>

namespace program
{

/**
 * Returns one self-contained HTML file with style, scripts, the record's document and its pictures. Large pictures are
 * scaled down. Throws InputError if a picture that the document names is missing.
 */
std::string MakeChartPage(const ChartRecord& record);

}
#endif
