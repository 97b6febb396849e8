/**
 * Generates the unrolled parts of the shaders that resolve lists of fragments. They work on named registers.
 */
#ifndef VITRINE_CORE_LISTS_RESOLVE_PROGRAM_H
#define VITRINE_CORE_LISTS_RESOLVE_PROGRAM_H

#include <string>

namespace vitrine
{

/** Text for the tags of ListResolve.glsl. */
struct ResolveText
{
  std::string Declare;
  std::string Load;
  std::string Sort;
  std::string OrderTies;
  std::string Blend;
  std::string Advance; ///< moves registers down by one, and clears the last
};

/** Generates text for lists of up to `size` nodes, a multiple of `pageSize`. */
ResolveText UnrollResolve(int size, int pageSize);

/** Text for the tags of ListResolveSlots.glsl. Registers move up or down by a group, which the first one then is. */
struct SlotResolveText
{
  std::string Declare;
  std::string MoveUp;
  std::string Load; ///< loads the first group
  std::string Sort;
  std::string FindTies;
  std::string OrderTies;        ///< orders neighbours within the first group
  std::string OrderTieOfGroups; ///< orders the first group's last and its next neighbour
  std::string Rotate;           ///< moves down, and the first group up to the last one's place
  std::string Blend;            ///< blends the first group
  std::string MoveDown;         ///< clears the last group
  std::string Advance;          ///< moves registers down by one, and clears the last
};

/** Generates text for lists of up to `size` nodes, a multiple of `group`, whose registers hold slots. */
SlotResolveText UnrollSlotResolve(int size, int group);

/** Text for the tags of CompositeBlocks.glsl. */
struct LongResolveText
{
  std::string Declare;
  std::string ClearNearest;
  std::string LoadBlock;
  std::string SortBlock;
  std::string MergeBlock;
  std::string Blend;
  std::string CountSame;
  std::string LastRegister; ///< register of the farthest fragment of the nearest block
};

LongResolveText UnrollLongResolve(int block);

/** Text for the tags of ListSortRuns.glsl. */
struct SortRunsText
{
  std::string Declare;
  std::string Load;
  std::string Sort;
  std::string Store;
};

/** Generates text for runs of `size` nodes, a multiple of `pageSize`. */
SortRunsText UnrollSortRuns(int size, int pageSize);

/** Text for the tags of ListSortLongRuns.glsl. */
struct SortLongRunsText
{
  std::string Declare;
  std::string ClearNearest;
  std::string Load;
  std::string Sort;
  std::string Merge;
  std::string Store;
  std::string StoreNearest;
};

/** Generates text for blocks of `block` nodes, a power of two and a multiple of `pageSize`. */
SortLongRunsText UnrollSortLongRuns(int block, int pageSize);

/** Text for the tags of ListMergeRuns.glsl. */
struct MergeRunsText
{
  std::string Declare;
  std::string FindNearest;
  std::string PutBack;
};

/** Generates text for up to `runs` runs, a multiple of `groupSize`, in groups of `groupSize` runs. */
MergeRunsText UnrollMergeRuns(int runs, int groupSize);

}
#endif
