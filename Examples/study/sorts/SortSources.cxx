#include "study/sorts/SortSources.h"

#include "shader/ShaderTags.h"
#include "sorts/SortShaders.h"
#include "study/sorts/ListSortProgram.h"

#include <cassert>

namespace vitrine
{
namespace
{

const char* ShaderOf(std::optional<ListSort> sort)
{
  if (!sort)
  {
    return shaders::SortNothing;
  }
  switch (*sort)
  {
    case ListSort::Insertion:
      return shaders::SortInsertion;
    case ListSort::Shell:
      return shaders::SortShell;
    case ListSort::Bitonic:
      return shaders::SortBitonic;
    case ListSort::OddEvenMerge:
      return shaders::SortOddEvenMerge;
    case ListSort::Network:
      return shaders::SortNetwork;
  }
  return "";
}

// The tags are in the project's own shaders, so a missing one is a programming error.
void Fill(std::string& source, const std::string& tag, const std::string& text)
{
  const std::string problem = ReplaceTag(source, tag, text);
  assert(problem.empty());
  (void)problem;
}

}

std::string SortSource(std::optional<ListSort> sort, int capacity)
{
  const ListSortText text = UnrollListSort(capacity);
  std::string source = ShaderOf(sort);
  Fill(source, "//Vitrine::Load", text.Load);
  Fill(source, "//Vitrine::Take", text.Take);
  Fill(source, "//Vitrine::Store", text.Store);
  if (sort == ListSort::Network)
  {
    Fill(source, "//Vitrine::Network", text.Network);
  }
  return source;
}

std::vector<std::string> SortDefines(int capacity)
{
  const std::vector<int> gaps = ShellGaps(capacity);
  std::string list;
  for (const int gap : gaps)
  {
    list += (list.empty() ? "" : ", ") + std::to_string(gap);
  }
  return { "VITRINE_SAMPLES 0", "VITRINE_SORT_SIZE " + std::to_string(capacity),
    "VITRINE_SHELL_GAP_COUNT " + std::to_string(gaps.size()), "VITRINE_SHELL_GAPS " + list };
}

}
