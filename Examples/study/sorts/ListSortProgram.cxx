#include "study/sorts/ListSortProgram.h"

#include "Core/lists/SortingNetwork.h"

namespace vitrine
{
namespace
{

std::string ForEachIndex(const std::string& macro, int count)
{
  std::string text;
  for (int i = 0; i < count; ++i)
  {
    text += macro + "(" + std::to_string(i) + ")\n";
  }
  return text;
}

}

ListSortText UnrollListSort(int capacity)
{
  return { ForEachIndex("LOAD", capacity), ForEachIndex("TAKE", capacity),
    EmitGlsl(BestKnownNetwork(capacity), "COMPARE_EXCHANGE_AT"), ForEachIndex("STORE", capacity) };
}

}
