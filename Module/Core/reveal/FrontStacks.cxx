#include "Core/reveal/FrontStacks.h"

#include <algorithm>

namespace vitrine
{

namespace
{

/** Mixes the bits of a column's number (the finaliser of splitmix64). */
std::uint64_t Mixed(std::uint64_t x)
{
  x = (x + 1) * 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}
}

std::uint32_t FrontStacks::ColumnOf(std::uint32_t part)
{
  if (part >= this->ColumnOfPart.size())
  {
    this->ColumnOfPart.resize(static_cast<std::size_t>(part) + 1, 0);
  }
  std::uint32_t& column = this->ColumnOfPart[part];
  if (column == 0)
  {
    this->PartOfColumn.push_back(part);
    this->LayersOfColumn.push_back(0);
    column = static_cast<std::uint32_t>(this->PartOfColumn.size());
  }
  return column - 1;
}

bool FrontStacks::IsStack(std::size_t stack) const
{
  return static_cast<std::size_t>(this->End(stack) - this->Begin(stack)) == this->Columns.size() &&
    std::all_of(this->Begin(stack), this->End(stack),
      [this](const Entry& entry) { return this->LayersOfColumn[entry.Column] == entry.Layers; });
}

void FrontStacks::AddStack(std::uint64_t hash)
{
  std::sort(this->Columns.begin(), this->Columns.end());
  for (const std::uint32_t column : this->Columns)
  {
    this->Entries.push_back({ column, this->LayersOfColumn[column] });
  }
  this->StacksOfHash.emplace(hash, static_cast<std::uint32_t>(this->Count()));
  this->Starts.push_back(this->Entries.size());
}

void FrontStacks::Add(const std::uint32_t* layers, std::size_t count)
{
  ++this->AllPixels;
  this->Most = std::max(this->Most, count);
  if (count == 0)
  {
    return;
  }
  ++this->Covered;
  // A sum does not depend on the order of layers, so nothing has to be sorted to find a stack that is known.
  std::uint64_t hash = 0;
  this->Columns.clear();
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::uint32_t column = this->ColumnOf(layers[i]);
    hash += Mixed(column);
    if (this->LayersOfColumn[column]++ == 0)
    {
      this->Columns.push_back(column);
    }
  }
  const auto [first, last] = this->StacksOfHash.equal_range(hash);
  if (std::none_of(first, last, [this](const auto& known) { return this->IsStack(known.second); }))
  {
    this->AddStack(hash);
  }
  for (const std::uint32_t column : this->Columns)
  {
    this->LayersOfColumn[column] = 0;
  }
}

}
