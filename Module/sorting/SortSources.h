/**
 * The fragment shaders that sort short lists, with their unrolled parts filled in.
 */
#ifndef VITRINE_SORTING_SORT_SOURCES_H
#define VITRINE_SORTING_SORT_SOURCES_H

#include "Core/ListSorts.h"

#include <optional>
#include <string>
#include <vector>

namespace vitrine
{

/** Sort*.glsl of the sort, or SortNothing.glsl, for storage of `capacity` elements. */
std::string SortSource(std::optional<ListSort> sort, int capacity);

/** The defines that go with it. */
std::vector<std::string> SortDefines(int capacity);

}
#endif
