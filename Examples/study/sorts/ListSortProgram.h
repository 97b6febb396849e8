/** Generates the parts of the list sort shaders (SortHarness.glsl) that are unrolled over constant indices. */
#ifndef VITRINE_STUDY_SORTS_LIST_SORT_PROGRAM_H
#define VITRINE_STUDY_SORTS_LIST_SORT_PROGRAM_H

#include <string>

namespace vitrine
{

/** Texts for the tags of SortHarness.glsl and SortNetwork.glsl. */
struct ListSortText
{
  std::string Load;
  std::string Take;
  std::string Network;
  std::string Store;
};

/** Returns the texts for lists in storage for `capacity` elements. */
ListSortText UnrollListSort(int capacity);

}
#endif
