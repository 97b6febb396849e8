/** The fragment shaders that sort short lists, with their unrolled parts filled in. */
#ifndef VITRINE_STUDY_SORTS_SORT_SOURCES_H
#define VITRINE_STUDY_SORTS_SORT_SOURCES_H

#include "study/sorts/ListSorts.h"

#include <optional>
#include <string>
#include <vector>

namespace vitrine
{

/** Returns Sort*.glsl of the sort, or SortNothing.glsl, for storage of `capacity` elements. */
std::string SortSource(std::optional<ListSort> sort, int capacity);

/** Returns the defines that SortSource() needs. */
std::vector<std::string> SortDefines(int capacity);

}
#endif
