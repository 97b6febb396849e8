/**
 * The results of `sorts` as a picture.
 */
#ifndef VITRINE_SORT_PLOT_H
#define VITRINE_SORT_PLOT_H

#include "sorts/SortMeasurement.h"

#include <string>

namespace program
{

/**
 * Plot time by storage, and time by the longest list in one storage. Write both as one PNG, completely or not at all.
 */
void PlotSorts(const SortComparison& comparison, const std::string& path);

}
#endif
