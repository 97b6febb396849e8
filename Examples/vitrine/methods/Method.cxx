#include "methods/Method.h"

#include "Errors.h"
#include "methods/VTKMethods.h"
#include "methods/VitrineMethods.h"
#include "vtkABufferTransparencyPass.h"

#include <algorithm>
#include <charconv>
#include <iostream>
#include <limits>
#include <sstream>
#include <utility>

namespace program
{

namespace
{
using Lists = vtkABufferTransparencyPass;

struct Entry
{
  std::string Name;
  std::string Description;
  bool IsExact;
  std::unique_ptr<Method> (
    *Make)(); ///< null for a method of the module by this name, as it is by default
};

const std::string PeelingPrefix = "vtk-peeling-";
const int AnyNumberOfPeels = std::numeric_limits<int>::max();
const int ExamplePeels = 4; // VTK's own default; the member of the family that `all` stands for

const std::vector<Entry>& Entries()
{
  static const std::vector<Entry> entries = {
    { "blend", "VTK's mapper with plain alpha blending, unsorted", false, MakeBlend },
    { "vtk-oit", "vtkOrderIndependentTranslucentPass, what VTK does by default; approximate", false,
      MakeVTKOIT },
    { PeelingPrefix + std::to_string(ExamplePeels),
      "vtkDualDepthPeelingPass with at most that many peels; any number will do", false,
      [] { return MakeVTKPeeling(ExamplePeels); } },
    { "vtk-peeling", "vtkDualDepthPeelingPass with as many peels as it takes", false,
      [] { return MakeVTKPeeling(AnyNumberOfPeels); } },
    { AutomaticName, "the cheapest of the lists that keeps the error budget of --error; exact",
      true, MakeAutomatic },
    { "linked-list", "A-buffer of linked lists; exact", true, nullptr },
    { "linked-list-compact", "the same with two thirds of the memory; exact", true,
      [] { return MakeLinkedList(Lists::COMPACT); } },
    { "linked-list-8bit", "the same with 8-bit colours; rounds alpha", false,
      [] { return MakeLinkedList(Lists::EIGHT_BIT); } },
    { "prefix-sum", "A-buffer packed by prefix sums; counts, then stores; exact", true,
      [] { return MakePrefixSum(false, Lists::HALF_FLOAT); } },
    { "prefix-sum-compact", "the same with two thirds of the memory; exact", true,
      [] { return MakePrefixSum(false, Lists::COMPACT); } },
    { "prefix-sum-8bit", "the same with 8-bit colours; rounds alpha", false,
      [] { return MakePrefixSum(false, Lists::EIGHT_BIT); } },
    { "prefix-sum-predicted", "the same in one geometry pass where the last frame tells; exact",
      true, [] { return MakePrefixSum(true, Lists::HALF_FLOAT); } },
    { "prefix-sum-predicted-compact", "the same with two thirds of the memory; exact", true,
      [] { return MakePrefixSum(true, Lists::COMPACT); } },
    { "prefix-sum-predicted-8bit", "the same with 8-bit colours; rounds alpha", false,
      [] { return MakePrefixSum(true, Lists::EIGHT_BIT); } },
    { "stencil-mask-4",
      "the first 4 layers by stencil masks, inexact at edges; with -unfiltered, edges as they are, "
      "with -marks, where they are repaired",
      false, [] { return MakeStencilMask(4); } },
    { "stencil-mask-8", "the same with 8 layers", false, [] { return MakeStencilMask(8); } },
    { "stencil-mask-9", "with 9 layers", false, [] { return MakeStencilMask(9); } },
    { "stencil-mask-16", "with 16 layers", false, [] { return MakeStencilMask(16); } },
    { "stencil-routed",
      "stencil routing in as many passes as it takes, each into as many samples as the driver "
      "routes; exact up to 254 layers; with -K, into 1, 2, 4, 8, 16 or 32 samples",
      true, nullptr },
    { "stencil-routed-8bit", "the same with 8-bit colours; rounds alpha", false,
      MakeStencilRoutedEightBit },
    { "truth", "the yardstick: composited on the CPU in float64; slow", false, nullptr },
  };
  return entries;
}

const Entry* FindEntry(const std::string& name)
{
  for (const Entry& entry : Entries())
  {
    if (entry.Name == name)
    {
      return &entry;
    }
  }
  return nullptr;
}

/** K of vtk-peeling-K; 0 if `name` is something else. */
int ParsePeels(const std::string& name)
{
  if (name.compare(0, PeelingPrefix.size(), PeelingPrefix) != 0)
  {
    return 0;
  }
  int peels = 0;
  const char* end = name.data() + name.size();
  const auto [last, error] = std::from_chars(name.data() + PeelingPrefix.size(), end, peels);
  return error == std::errc() && last == end && peels > 0 ? peels : 0;
}

/**
 * The method for a name with an ending that says how stencil-mask-N shows its edges or into how many samples
 * stencil-routed goes; null for other names.
 */
std::unique_ptr<Method> MakeVariant(const std::string& name)
{
  for (const int samples : { 1, 2, 4, 8, 16, 32 })
  {
    if (name == "stencil-routed-" + std::to_string(samples))
    {
      return MakeStencilRouted(samples);
    }
  }
  const std::pair<std::string, MaskEdges> endings[] = { { "-unfiltered", MaskEdges::AsTheyAre },
    { "-marks", MaskEdges::Marks } };
  for (const auto& [ending, edges] : endings)
  {
    for (const int layers : { 4, 8, 9, 16 })
    {
      if (name == "stencil-mask-" + std::to_string(layers) + ending)
      {
        return MakeStencilMask(layers, edges);
      }
    }
  }
  return nullptr;
}

std::string ListNames()
{
  std::string names;
  for (const Entry& entry : Entries())
  {
    names += entry.Name + ", ";
  }
  return names +
    "vtk-peeling-K and stencil-routed-K with another K, stencil-mask-N-unfiltered and "
    "stencil-mask-N-marks; to compare, also the groups exact and all";
}

void RequireMethod(const std::string& name)
{
  if (!FindEntry(name) && ParsePeels(name) == 0 && !MakeVariant(name))
  {
    throw InputError("method '" + name + "'", "there is no such method; there are " + ListNames());
  }
}

std::vector<std::string> ExpandGroup(const std::string& name)
{
  if (name != "exact" && name != "all")
  {
    RequireMethod(name);
    return { name };
  }
  std::vector<std::string> members;
  for (const Entry& entry : Entries())
  {
    if (entry.IsExact || name == "all")
    {
      members.push_back(entry.Name);
    }
  }
  return members;
}
}

std::string Method::SetCoincidence(const Coincidence& coincidence)
{
  return coincidence.IsOn() ? "it has no tolerance within which fragments coincide" : "";
}

void PrintBudgetProblem(const MethodStatistics& statistics)
{
  if (!statistics.BudgetProblem.empty())
  {
    std::cerr << "vitrine: note: the error budget is not promised: " << statistics.BudgetProblem
              << "\n";
  }
}

std::string Method::SetErrorBudget(double)
{
  return "only the method automatic has an error budget";
}

std::unique_ptr<Method> MakeMethod(const std::string& name)
{
  RequireMethod(name);
  if (const Entry* entry = FindEntry(name))
  {
    return entry->Make ? entry->Make() : MakeByDefault(name);
  }
  std::unique_ptr<Method> variant = MakeVariant(name);
  return variant ? std::move(variant) : MakeVTKPeeling(ParsePeels(name));
}

std::vector<std::string> ParseMethodList(const std::string& list)
{
  std::vector<std::string> names;
  std::string item;
  std::istringstream stream(list);
  while (std::getline(stream, item, ','))
  {
    for (const std::string& name : ExpandGroup(item))
    {
      if (std::find(names.begin(), names.end(), name) == names.end())
      {
        names.push_back(name);
      }
    }
  }
  if (names.empty())
  {
    throw InputError("--methods", "no method is named; there are " + ListNames());
  }
  return names;
}

std::string DescribeMethods()
{
  std::size_t width = 0;
  for (const Entry& entry : Entries())
  {
    width = std::max(width, entry.Name.size() + 2);
  }
  std::string lines;
  for (const Entry& entry : Entries())
  {
    lines +=
      "  " + entry.Name + std::string(width - entry.Name.size(), ' ') + entry.Description + "\n";
  }
  return lines;
}

}
