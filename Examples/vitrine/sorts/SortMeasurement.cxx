#include "sorts/SortMeasurement.h"

#include "Errors.h"
#include "Median.h"
#include "Progress.h"
#include "scene/Random.h"
#include "study/sorts/SortHarness.h"

#include "vtkHeadlessRenderWindow.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <map>
#include <numeric>

namespace program
{

namespace
{
using vitrine::ListSort;
using vitrine::SortHarness;
using vitrine::SortList;
using Checksums = std::vector<std::array<std::uint32_t, 2>>;

const int ElementsSortedPerList = 128; // in one draw, so that loading weighs little
const int LengthSteps = 8;

std::uint32_t DepthBits(double depth)
{
  const float value = static_cast<float>(depth);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

std::vector<SortList> MakeLists(const SortSettings& settings, int longest)
{
  Random random(settings.Seed);
  std::vector<SortList> lists(static_cast<std::size_t>(settings.Lists));
  for (SortList& list : lists)
  {
    list.resize(random.Below(static_cast<std::size_t>(longest) + 1));
    for (vitrine::SortElement& element : list)
    {
      element = { DepthBits(random.Unit()), static_cast<std::uint32_t>(random.Next()) };
    }
  }
  return lists;
}

std::int64_t CountElements(const std::vector<SortList>& lists)
{
  return std::accumulate(lists.begin(), lists.end(), std::int64_t{ 0 },
    [](std::int64_t sum, const SortList& list)
    { return sum + static_cast<std::int64_t>(list.size()); });
}

std::vector<std::uint32_t> Keys(const SortList& list)
{
  std::vector<std::uint32_t> keys;
  for (const vitrine::SortElement& element : list)
  {
    keys.push_back(element.Key);
  }
  return keys;
}

double MeanComparisons(ListSort method, int size, const std::vector<SortList>& lists)
{
  std::map<std::size_t, std::int64_t> countByLength; // which is all that other sorts depend on
  std::int64_t sum = 0;
  for (const SortList& list : lists)
  {
    const auto [count, isNew] = countByLength.try_emplace(list.size());
    if (isNew || method == ListSort::Insertion)
    {
      count->second = vitrine::CountComparisons(method, size, Keys(list));
    }
    sum += count->second;
  }
  return static_cast<double>(sum) / static_cast<double>(lists.size());
}

Checksums SortedChecksums(std::vector<SortList> lists, int size)
{
  Checksums checksums;
  for (SortList& list : lists)
  {
    std::sort(list.begin(), list.end(),
      [](const vitrine::SortElement& a, const vitrine::SortElement& b) { return a.Key < b.Key; });
    checksums.push_back(vitrine::ListChecksum(list, size));
  }
  return checksums;
}

/** Draw each sort once: it is compiled then, and what it leaves is compared with std::sort. */
void WarmUp(SortHarness& harness, const Checksums& expected, SortRun& run, Progress& progress)
{
  for (SortTimes& times : run.Results)
  {
    progress.Show("building " + vitrine::NameOf(times.Method) + " for " + std::to_string(run.Size));
    if (!harness.Sort(times.Method))
    {
      times.Skipped = "the driver cannot compile its shader";
    }
    else if (harness.ReadChecksums() != expected)
    {
      times.Skipped = "its lists are not those of std::sort here";
    }
  }
  if (!harness.Copy())
  {
    throw RuntimeError("the driver cannot compile the shader that loads lists");
  }
}

void TimeRounds(
  SortHarness& harness, const SortSettings& settings, SortRun& run, Progress& progress)
{
  for (int round = 0; round < settings.Rounds; ++round)
  {
    progress.Show(std::to_string(run.Longest) + " of " + std::to_string(run.Size) +
      " elements, round " + std::to_string(round + 1) + " of " + std::to_string(settings.Rounds));
    run.FloorMilliseconds.push_back(*harness.Copy(run.Repeats) / run.Repeats);
    for (SortTimes& times : run.Results)
    {
      if (times.Skipped.empty())
      {
        times.Milliseconds.push_back(*harness.Sort(times.Method, run.Repeats) / run.Repeats);
      }
    }
  }
}

double NetMilliseconds(const std::vector<double>& times, const std::vector<double>& floor)
{
  std::vector<double> above(times.size());
  std::transform(times.begin(), times.end(), floor.begin(), above.begin(), std::minus<>());
  return Median(above);
}

SortRun Measure(
  SortHarness& harness, const SortSettings& settings, int size, int longest, Progress& progress)
{
  const std::vector<SortList> lists = MakeLists(settings, longest);
  SortRun run{ size, longest, std::max(2, ElementsSortedPerList / size), CountElements(lists), {},
    {} };
  const std::string problem = harness.SetLists(lists, size);
  if (!problem.empty())
  {
    throw RuntimeError(problem);
  }
  for (const ListSort method : settings.Methods)
  {
    SortTimes times;
    times.Method = method;
    times.MostComparisons = vitrine::MostComparisons(method, size);
    times.MeanComparisons = MeanComparisons(method, size, lists);
    run.Results.push_back(times);
  }
  WarmUp(harness, SortedChecksums(lists, size), run, progress);
  TimeRounds(harness, settings, run, progress);
  for (SortTimes& times : run.Results)
  {
    if (times.Skipped.empty())
    {
      times.NetMilliseconds = NetMilliseconds(times.Milliseconds, run.FloorMilliseconds);
    }
  }
  return run;
}

/** Steps of an eighth of the storage. */
std::vector<int> LengthsWithin(int storage)
{
  std::vector<int> lengths;
  for (int step = 1; step <= LengthSteps; ++step)
  {
    const int length = storage * step / LengthSteps;
    if (length > 0)
    {
      lengths.push_back(length);
    }
  }
  return lengths;
}
}

SortComparison MeasureSorts(const SortSettings& settings)
{
  vtkNew<vtkHeadlessRenderWindow> window;
  window->Initialize();
  if (!window->GetGenericContext())
  {
    throw RuntimeError("there is no OpenGL to draw with here");
  }
  SortHarness harness(window);
  const std::string missing = harness.FindMissingFeature();
  if (!missing.empty())
  {
    throw RuntimeError(missing);
  }

  Progress progress;
  SortComparison comparison{ settings, DescribeDevice(window), {}, {} };
  for (const int size : settings.Sizes)
  {
    comparison.Sizes.push_back(Measure(harness, settings, size, size, progress));
  }
  for (const int longest : LengthsWithin(settings.Storage))
  {
    comparison.Lengths.push_back(Measure(harness, settings, settings.Storage, longest, progress));
  }
  return comparison;
}

const SortTimes* FindTimes(const SortRun& run, ListSort method)
{
  for (const SortTimes& times : run.Results)
  {
    if (times.Method == method && times.Skipped.empty())
    {
      return &times;
    }
  }
  return nullptr;
}

}
