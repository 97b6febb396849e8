/**
 * The sorts of short lists side by side on the device: what `vitrine sorts` measures.
 */
#ifndef VITRINE_SORT_MEASUREMENT_H
#define VITRINE_SORT_MEASUREMENT_H

#include "methods/Device.h"
#include "study/sorts/ListSorts.h"

#include <cstdint>
#include <string>
#include <vector>

namespace program
{

struct SortSettings
{
  std::vector<vitrine::ListSort> Methods;
  std::vector<int> Sizes; ///< storage of the tables: lists have 0 to so many elements
  int Storage = 32;       ///< in which time is measured against the longest list
  int Lists = 65536;
  int Rounds = 9; ///< timed draws of each sort, taken in turn
  std::uint64_t Seed = 1;
};

/** What was measured of one sort. */
struct SortTimes
{
  vitrine::ListSort Method;
  std::string Skipped;              ///< why it could not run; the rest is void then
  std::vector<double> Milliseconds; ///< to load, sort and read all lists once, one for each round
  double NetMilliseconds =
    0.0; ///< of the sort alone: median of what lies above the floor in the same round
  std::int64_t MostComparisons = 0; ///< that a list in this storage can take
  double MeanComparisons = 0.0;     ///< of the lists
};

/** All sorts on the same lists. */
struct SortRun
{
  int Size;                              ///< elements that the storage holds
  int Longest;                           ///< lists have 0 to so many elements
  int Repeats;                           ///< times that a draw sorts each list
  std::int64_t Elements;                 ///< of all lists
  std::vector<double> FloorMilliseconds; ///< to load and read all lists once without a sort
  std::vector<SortTimes> Results;
};

struct SortComparison
{
  SortSettings Settings;
  Device GL;
  std::vector<SortRun> Sizes;   ///< one for each size, with lists up to the size of the storage
  std::vector<SortRun> Lengths; ///< in the storage of the settings, with ever longer lists
};

/**
 * Time every sort, and compare what it leaves with std::sort. Throws RuntimeError if there is no OpenGL that can do it.
 */
SortComparison MeasureSorts(const SortSettings& settings);

/** The times of a method in a run; null if it is not there or was skipped. */
const SortTimes* FindTimes(const SortRun& run, vitrine::ListSort method);

}
#endif
