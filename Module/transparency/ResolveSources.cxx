#include "transparency/ResolveSources.h"

#include "Core/ResolveProgram.h"
#include "Shaders/SharedLayout.h"
#include "transparency/FillShader.h"
#include "transparency/ShaderText.h"

#include <cassert>

namespace vitrine
{
namespace
{

// The tags are in our own shaders, so a missing one is an error in the program.
void Fill(std::string& source, const char* tag, const std::string& text)
{
  const std::string problem = ReplaceTag(source, std::string("//Vitrine::") + tag, text);
  assert(problem.empty());
  (void)problem;
}

// A resolve of any number of fragments, in blocks of `block`.
std::string ResolveLong(std::string source, int block)
{
  const LongResolveText text = UnrollLongResolve(block);
  Fill(source, "Declare", text.Declare);
  Fill(source, "ClearNearest", text.ClearNearest);
  Fill(source, "LoadBlock", text.LoadBlock);
  Fill(source, "SortBlock", text.SortBlock);
  Fill(source, "MergeBlock", text.MergeBlock);
  Fill(source, "Blend", text.Blend);
  Fill(source, "CountSame", text.CountSame);
  Fill(source, "LastOfBlock", "Fragment blockLast = " + text.LastRegister + ";");
  return source;
}

// A resolve of lists of up to `size` nodes, by one network.
std::string Resolve(std::string source, int size, int pageSize)
{
  const ResolveText text = UnrollResolve(size, pageSize);
  Fill(source, "Declare", text.Declare);
  Fill(source, "Load", text.Load);
  Fill(source, "Sort", text.Sort);
  Fill(source, "OrderTies", text.OrderTies);
  Fill(source, "Blend", text.Blend);
  return source;
}

}

std::string NetworkSource(int size, int pageSize)
{
  return Resolve(shaders::ListResolve, size, pageSize);
}

std::string StencilMaskSource(int layers)
{
  return Resolve(shaders::StencilMaskResolve, layers, layers);
}

std::string SortRunsSource(int size, int pageSize)
{
  const SortRunsText text = UnrollSortRuns(size, pageSize);
  std::string source = shaders::ListSortRuns;
  Fill(source, "Declare", text.Declare);
  Fill(source, "Load", text.Load);
  Fill(source, "Sort", text.Sort);
  Fill(source, "Store", text.Store);
  return source;
}

std::string SortLongRunsSource(int block, int pageSize)
{
  const SortLongRunsText text = UnrollSortLongRuns(block, pageSize);
  std::string source = shaders::ListSortLongRuns;
  Fill(source, "Declare", text.Declare);
  Fill(source, "ClearNearest", text.ClearNearest);
  Fill(source, "Load", text.Load);
  Fill(source, "Sort", text.Sort);
  Fill(source, "Merge", text.Merge);
  Fill(source, "Store", text.Store);
  Fill(source, "StoreNearest", text.StoreNearest);
  return source;
}

std::string MergeRunsSource(int runs)
{
  const MergeRunsText text = UnrollMergeRuns(runs, VITRINE_RUN_GROUP);
  std::string source = shaders::ListMergeRuns;
  Fill(source, "Declare", text.Declare);
  Fill(source, "FindNearest", text.FindNearest);
  Fill(source, "PutBack", text.PutBack);
  return source;
}

std::string RoutedNetworkSource(int size)
{
  return Resolve(shaders::StencilRoutedResolve, size, size);
}

std::string RoutedBlocksSource(int block)
{
  return ResolveLong(shaders::StencilRoutedResolveLong, block);
}

}
