#include "transparency/common/ResolveSources.h"

#include "Core/lists/ResolveProgram.h"
#include "shader/ShaderTags.h"
#include "shader/ShaderText.h"

#include <cassert>
#include <vector>

namespace vitrine
{
namespace
{

// Fragments that a program of slots reads at once. Eight hide the latency of memory.
constexpr int SlotGroup = 8;

struct TagText
{
  const char* Tag;
  std::string Text;
};

// The tags are in Vitrine's own shaders, so a missing tag is a programming error.
std::string Filled(std::string source, const std::vector<TagText>& texts)
{
  for (const TagText& text : texts)
  {
    const std::string problem =
      ReplaceTag(source, std::string("//Vitrine::") + text.Tag, text.Text);
    assert(problem.empty());
    (void)problem;
  }
  return source;
}

// Fills in a resolve of any number of fragments, in blocks of `block`.
std::string ResolveLong(const char* source, int block)
{
  const LongResolveText text = UnrollLongResolve(block);
  return Filled(source,
    { { "Declare", text.Declare }, { "ClearNearest", text.ClearNearest },
      { "LoadBlock", text.LoadBlock }, { "SortBlock", text.SortBlock },
      { "MergeBlock", text.MergeBlock }, { "Blend", text.Blend }, { "CountSame", text.CountSame },
      { "LastOfBlock", "Fragment blockLast = " + text.LastRegister + ";" } });
}

// Fills in a resolve of lists that one network sorts.
std::string Resolve(const char* source, const ResolveText& text)
{
  return Filled(source,
    { { "Declare", text.Declare }, { "Load", text.Load }, { "Sort", text.Sort },
      { "OrderTies", text.OrderTies }, { "Blend", text.Blend } });
}

}

std::string NetworkSource(int size, int pageSize)
{
  const ResolveText text = UnrollResolve(size, pageSize);
  return Filled(Resolve(shaders::ListResolve, text), { { "Advance", text.Advance } });
}

std::string SlotNetworkSource(int size)
{
  const SlotResolveText text = UnrollSlotResolve(size, SlotGroup);
  return "#define VITRINE_SLOT_GROUP " + std::to_string(SlotGroup) + "\n" +
    Filled(shaders::ListResolveSlots,
      { { "Declare", text.Declare }, { "MoveUp", text.MoveUp }, { "Load", text.Load },
        { "Sort", text.Sort }, { "FindTies", text.FindTies }, { "OrderTies", text.OrderTies },
        { "OrderTieOfGroups", text.OrderTieOfGroups }, { "Rotate", text.Rotate },
        { "Blend", text.Blend }, { "MoveDown", text.MoveDown }, { "Advance", text.Advance } });
}

std::string StencilMaskSource(int layers)
{
  return Resolve(shaders::StencilMaskResolve, UnrollResolve(layers, layers));
}

std::string SortRunsSource(int size, int pageSize)
{
  const SortRunsText text = UnrollSortRuns(size, pageSize);
  return Filled(shaders::ListSortRuns,
    { { "Declare", text.Declare }, { "Load", text.Load }, { "Sort", text.Sort },
      { "Store", text.Store } });
}

std::string SortLongRunsSource(int block, int pageSize)
{
  const SortLongRunsText text = UnrollSortLongRuns(block, pageSize);
  return Filled(shaders::ListSortLongRuns,
    { { "Declare", text.Declare }, { "ClearNearest", text.ClearNearest }, { "Load", text.Load },
      { "Sort", text.Sort }, { "Merge", text.Merge }, { "Store", text.Store },
      { "StoreNearest", text.StoreNearest } });
}

std::string MergeRunsSource(int runs, int groupSize)
{
  const MergeRunsText text = UnrollMergeRuns(runs, groupSize);
  return Filled(shaders::ListMergeRuns,
    { { "Declare", text.Declare }, { "FindNearest", text.FindNearest },
      { "PutBack", text.PutBack } });
}

std::string RoutedNetworkSource(int size)
{
  return Resolve(shaders::StencilRoutedResolve, UnrollResolve(size, size));
}

std::string RoutedBlocksSource(int block)
{
  return ResolveLong(shaders::StencilRoutedResolveLong, block);
}

}
