#include "Core/lists/SortingNetwork.h"

#include "Core/lists/SortingNetworkTables.h"

#include <algorithm>
#include <cassert>

namespace vitrine
{

SortingNetwork OddEvenMergeNetwork(int size)
{
  assert(size >= 0);
  SortingNetwork network{ size, {} };
  int top = 1;
  while (2 * top < size)
  {
    top *= 2;
  }
  // The names are Knuth's: p is the length of the runs to merge; q, r and d step through the merge.
  for (int p = top; p > 0; p /= 2)
  {
    int q = top;
    int r = 0;
    int d = p;
    while (true)
    {
      for (int i = 0; i + d < size; ++i)
      {
        if ((i & p) == r)
        {
          network.Comparators.push_back({ i, i + d });
        }
      }
      if (q == p)
      {
        break;
      }
      d = q - p;
      q /= 2;
      r = p;
    }
  }
  return network;
}

SortingNetwork BestKnownNetwork(int size)
{
  assert(size >= 0);
  const char* text = BestKnownNetworkText(size);
  return text ? DecodeNetwork(size, text) : OddEvenMergeNetwork(size);
}

std::string EmitGlsl(
  const SortingNetwork& network, const std::string& macro, const std::string& prefix)
{
  constexpr std::size_t callsPerLine = 8;
  std::string text;
  for (std::size_t i = 0; i < network.Comparators.size(); ++i)
  {
    const Comparator& comparator = network.Comparators[i];
    const bool lineEnds =
      i % callsPerLine == callsPerLine - 1 || i + 1 == network.Comparators.size();
    text += macro + "(" + prefix + std::to_string(comparator.Low) + ", " + prefix +
      std::to_string(comparator.High) + ");" + (lineEnds ? "\n" : " ");
  }
  return text;
}

}
