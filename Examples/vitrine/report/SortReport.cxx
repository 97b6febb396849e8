#include "report/SortReport.h"

#include "Median.h"
#include "report/Json.h"
#include "report/TextTable.h"

#include <functional>
#include <map>
#include <optional>

namespace program
{

namespace
{
using vitrine::ListSort;

/** How many times as long as the network the source paper found insertion sort to take, by size. */
const std::map<int, double> PaperInsertionOverNetwork = { { 4, 3.0 }, { 8, 6.0 }, { 16, 14.0 },
  { 32, 17.0 } };

std::optional<double> Divide(double a, double b)
{
  return a > 0.0 && b > 0.0 ? std::optional<double>(a / b) : std::nullopt;
}

std::optional<double> OverNetwork(const SortRun& run, const SortTimes& times)
{
  const SortTimes* network = FindTimes(run, ListSort::Network);
  return network ? Divide(Median(times.Milliseconds), Median(network->Milliseconds)) : std::nullopt;
}

/** Nothing where a time vanishes against what loading the lists takes. */
std::optional<double> NetOverNetwork(const SortRun& run, const SortTimes& times)
{
  const SortTimes* network = FindTimes(run, ListSort::Network);
  return network ? Divide(times.NetMilliseconds, network->NetMilliseconds) : std::nullopt;
}

std::optional<double> PaperOverNetwork(const SortRun& run, const SortTimes& times)
{
  const auto found = PaperInsertionOverNetwork.find(run.Size);
  const bool isThere =
    times.Method == ListSort::Insertion && found != PaperInsertionOverNetwork.end();
  return isThere ? std::optional<double>(found->second) : std::nullopt;
}

std::optional<double> ElementsPerSecond(const SortRun& run, double milliseconds)
{
  const auto perMillisecond = Divide(static_cast<double>(run.Elements), milliseconds);
  return perMillisecond ? std::optional<double>(*perMillisecond * 1000.0) : std::nullopt;
}

std::string Cell(const char* format, const std::optional<double>& value)
{
  return value ? FormatCell(format, *value) : "?";
}

/** "a (b)" */
std::string Both(const char* format, const std::optional<double>& a, const std::optional<double>& b)
{
  return Cell(format, a) + " (" + Cell(format, b) + ")";
}

using MakeCell = std::function<std::string(const SortRun& run, const SortTimes& times)>;

TextRow MethodRow(const std::vector<SortRun>& runs, ListSort method, const MakeCell& makeCell)
{
  TextRow row = { vitrine::NameOf(method) };
  for (const SortRun& run : runs)
  {
    const SortTimes* times = FindTimes(run, method);
    row.push_back(times ? makeCell(run, *times) : "skipped");
  }
  return row;
}

std::vector<TextRow> MethodRows(
  const SortComparison& comparison, const std::vector<SortRun>& runs, const MakeCell& makeCell)
{
  TextRow head = { "" };
  for (const SortRun& run : runs)
  {
    head.push_back(std::to_string(run.Longest));
  }
  std::vector<TextRow> rows = { head };
  for (const ListSort method : comparison.Settings.Methods)
  {
    rows.push_back(MethodRow(runs, method, makeCell));
  }
  return rows;
}

std::string TimeCell(const SortRun& /*run*/, const SortTimes& times)
{
  return Both("%.3f", Median(times.Milliseconds), times.NetMilliseconds);
}

std::string TimeTable(const SortComparison& comparison, const std::vector<SortRun>& runs)
{
  std::vector<TextRow> rows = MethodRows(comparison, runs, TimeCell);
  TextRow floor = { "no sort" };
  for (const SortRun& run : runs)
  {
    floor.push_back(Both("%.3f", Median(run.FloorMilliseconds), 0.0));
  }
  rows.push_back(floor);
  return AlignColumns(rows);
}

std::string RatioTable(const SortComparison& comparison)
{
  std::vector<TextRow> rows = MethodRows(comparison, comparison.Sizes,
    [](const SortRun& run, const SortTimes& times)
    { return Both("%.1f", OverNetwork(run, times), NetOverNetwork(run, times)); });
  TextRow paper = { "paper's insertion" };
  for (const SortRun& run : comparison.Sizes)
  {
    const auto found = PaperInsertionOverNetwork.find(run.Size);
    paper.push_back(
      found != PaperInsertionOverNetwork.end() ? FormatCell("%.0f", found->second) : "-");
  }
  rows.push_back(paper);
  return AlignColumns(rows);
}

std::string ComparisonTable(const SortComparison& comparison)
{
  return AlignColumns(MethodRows(comparison, comparison.Sizes,
    [](const SortRun& /*run*/, const SortTimes& times)
    {
      return FormatCell("%.1f", times.MeanComparisons) + " (" +
        std::to_string(times.MostComparisons) + ")";
    }));
}

std::string SpeedTable(const SortComparison& comparison)
{
  return AlignColumns(MethodRows(comparison, comparison.Sizes,
    [](const SortRun& run, const SortTimes& times)
    {
      const double unit = 1e-6;
      const auto whole = ElementsPerSecond(run, Median(times.Milliseconds) / unit);
      const auto net = ElementsPerSecond(run, times.NetMilliseconds / unit);
      return Both("%.1f", whole, net);
    }));
}

std::string SkippedLines(const SortComparison& comparison)
{
  std::string lines;
  for (const std::vector<SortRun>* runs : { &comparison.Sizes, &comparison.Lengths })
  {
    for (const SortRun& run : *runs)
    {
      for (const SortTimes& times : run.Results)
      {
        lines += times.Skipped.empty() ? ""
                                       : vitrine::NameOf(times.Method) + " of " +
            std::to_string(run.Size) + " is skipped: " + times.Skipped + "\n";
      }
    }
  }
  return lines;
}

Json ToRow(const SortRun& run, const SortTimes& times)
{
  Json row = { { "method", vitrine::NameOf(times.Method) }, { "size", run.Size },
    { "longest", run.Longest }, { "elements", run.Elements } };
  if (!times.Skipped.empty())
  {
    row["skipped"] = times.Skipped;
    return row;
  }
  row["repeats"] = run.Repeats;
  row["ms"] = Spread(times.Milliseconds, "rounds");
  row["floor_ms"] = Spread(run.FloorMilliseconds, "rounds");
  row["net_ms"] = times.NetMilliseconds;
  row["elements_per_second"] = { { "whole",
                                   OrNull(ElementsPerSecond(run, Median(times.Milliseconds))) },
    { "net", OrNull(ElementsPerSecond(run, times.NetMilliseconds)) } };
  row["over_network"] = { { "whole", OrNull(OverNetwork(run, times)) },
    { "net", OrNull(NetOverNetwork(run, times)) },
    { "paper", OrNull(PaperOverNetwork(run, times)) } };
  row["comparisons"] = { { "mean", times.MeanComparisons }, { "most", times.MostComparisons } };
  return row;
}

Json ToRows(const std::vector<SortRun>& runs)
{
  Json rows = Json::array();
  for (const SortRun& run : runs)
  {
    for (const SortTimes& times : run.Results)
    {
      rows.push_back(ToRow(run, times));
    }
  }
  return rows;
}
}

std::string ToTables(const SortComparison& comparison)
{
  const SortSettings& settings = comparison.Settings;
  return std::to_string(settings.Lists) + " lists of random length, " + comparison.GL.Renderer +
    "\n\nMilliseconds for lists of 0 to N elements; of the sort alone in brackets\n" +
    TimeTable(comparison, comparison.Sizes) +
    "\nTimes as long as the network; of the sort alone in brackets\n" + RatioTable(comparison) +
    "\nMillion elements a second; by the sort alone in brackets\n" + SpeedTable(comparison) +
    "\nComparisons a list on average; at most in brackets\n" + ComparisonTable(comparison) +
    "\nMilliseconds for lists of 0 to n elements in storage for " +
    std::to_string(settings.Storage) + "; of the sort alone in brackets\n" +
    TimeTable(comparison, comparison.Lengths) + SkippedLines(comparison);
}

std::string ToJson(const SortComparison& comparison)
{
  const SortSettings& settings = comparison.Settings;
  Json document = MeasurementHead(comparison.GL);
  document["settings"] = { { "lists", settings.Lists }, { "rounds", settings.Rounds },
    { "seed", settings.Seed }, { "storage", settings.Storage } };
  document["results"] = ToRows(comparison.Sizes);
  document["lengths"] = ToRows(comparison.Lengths);
  return JsonText(document);
}

}
