#include "report/ChartFiles.h"

#include "Errors.h"
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
  const std::string page = record.PathOf("index.html");
  try
  {
    Summarise(record);
    PlotChart(record);
    WriteWholeFile(page, MakeChartPage(record));
  }
  catch (const Json::exception& error) // what was taken up comes from a file that anyone can edit
  {
    throw InputError(
      record.PathOf("chart.json"), std::string("has rows that are damaged: ") + error.what());
  }
  return page;
}

}
