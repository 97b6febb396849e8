#include "report/ChartFiles.h"

#include "OutputFile.h"
#include "chart/ChartSummary.h"
#include "report/ChartPage.h"
#include "report/ChartPlot.h"

namespace program
{

namespace
{
void Summarise(ChartRecord& record)
{
  record.Set("results", AddRatios(record.Rows("results")));
  record.Set("scenes", SummariseScenes(record.Rows("results")));
  record.Set("growth", SummariseGrowth(record.Rows("results")));
}
}

std::string WriteChart(ChartRecord& record)
{
  const std::string page = record.PathOf(PageFile);
  Summarise(record);
  PlotChart(record);
  WriteWholeFile(page, MakeChartPage(record));
  return page;
}

}
