/**
 * The generated parts of the shaders that resolve lists of fragments: unrolled over named registers.
 */
#ifndef VITRINE_CORE_LISTS_RESOLVE_PROGRAM_H
#define VITRINE_CORE_LISTS_RESOLVE_PROGRAM_H

#include <string>

namespace vitrine
{

/** Text for the tags of ListResolve.glsl, for lists of up to `size` nodes in pages of `pageSize`. */
struct ResolveText
{
  std::string Declare;
  std::string Load;
  std::string Sort;
  std::string OrderTies;
  std::string Blend;
};

/** `size` is a multiple of `pageSize`. */
ResolveText UnrollResolve(int size, int pageSize);

/** Text for the tags of CompositeBlocks.glsl, for blocks of `block` nodes, a power of two. */
struct LongResolveText
{
  std::string Declare;
  std::string ClearNearest;
  std::string LoadBlock;
  std::string SortBlock;
  std::string MergeBlock;
  std::string Blend;
  std::string CountSame;
  std::string LastRegister; ///< the register that holds the farthest fragment of the nearest block
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

/** For runs of `size` nodes, a multiple of `pageSize`. */
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

/** For blocks of `block` nodes, a power of two and a multiple of `pageSize`. */
SortLongRunsText UnrollSortLongRuns(int block, int pageSize);

/** Text for the tags of ListMergeRuns.glsl. */
struct MergeRunsText
{
  std::string Declare;
  std::string FindNearest;
  std::string PutBack;
};

/** For up to `runs` runs in groups of `groupSize`, of which `runs` is a multiple. */
MergeRunsText UnrollMergeRuns(int runs, int groupSize);

}
#endif
