/** The fragment shaders that resolve lists, with their unrolled parts filled in. */
#ifndef VITRINE_TRANSPARENCY_COMMON_RESOLVE_SOURCES_H
#define VITRINE_TRANSPARENCY_COMMON_RESOLVE_SOURCES_H

#include <string>

namespace vitrine
{

/** ListResolve.glsl for lists of up to `size` nodes, sorted by one network. */
std::string NetworkSource(int size, int pageSize);

/** ListResolveSlots.glsl for packed lists of up to `size` nodes. */
std::string SlotNetworkSource(int size);

/** StencilMaskResolve.glsl for groups of `layers` pixels. */
std::string StencilMaskSource(int layers);

/** StencilRoutedResolve.glsl for pixels of up to `size` fragments, sorted by one network. */
std::string RoutedNetworkSource(int size);

/** StencilRoutedResolveLong.glsl for pixels of any number of fragments, in blocks of `block`. */
std::string RoutedBlocksSource(int block);

/** ListSortRuns.glsl for runs of `size` nodes. */
std::string SortRunsSource(int size, int pageSize);

/** ListSortLongRuns.glsl for runs of any number of blocks of `block` nodes. */
std::string SortLongRunsSource(int block, int pageSize);

/** ListMergeRuns.glsl for up to `runs` runs, a multiple of `groupSize`. */
std::string MergeRunsSource(int runs, int groupSize);

}
#endif
