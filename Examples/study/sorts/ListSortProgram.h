/**
 * The generated parts of the shaders that sort short lists (SortHarness.glsl), unrolled over constant indices.
 */
#ifndef VITRINE_STUDY_SORTS_LIST_SORT_PROGRAM_H
#define VITRINE_STUDY_SORTS_LIST_SORT_PROGRAM_H

#include <string>

namespace vitrine
{

/** Text for the tags of SortHarness.glsl and SortNetwork.glsl. */
struct ListSortText
{
  std::string Load;
  std::string Take;
  std::string Network;
  std::string Store;
};

/** For lists in storage for `capacity` elements. */
ListSortText UnrollListSort(int capacity);

}
#endif
