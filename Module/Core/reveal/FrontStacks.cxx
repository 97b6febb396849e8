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
  const auto next = static_cast<std::uint32_t>(this->PartOfColumn.size());
  const auto [column, isNew] = this->ColumnOfPart.try_emplace(part, next);
  if (isNew)
  {
    this->PartOfColumn.push_back(part);
    this->LayersOfColumn.push_back(0);
  }
  return column->second;
}

bool FrontStacks::IsStack(std::size_t stack) const
{
  return static_cast<std::size_t>(this->End(stack) - this->Begin(stack)) == this->Columns.size() &&
    std::all_of(this->Begin(stack), this->End(stack),
      [this](const Entry& entry) { return this->LayersOfColumn[entry.Column] == entry.Layers; });
}

/** Returns the stack of Columns and LayersOfColumn, which are empty then. */
std::uint32_t FrontStacks::FindOrAdd(std::uint64_t hash, bool isNear)
{
  const auto [first, last] = this->StacksOfHash.equal_range(hash);
  const auto found =
    std::find_if(first, last, [this](const auto& known) { return this->IsStack(known.second); });
  std::uint32_t stack = static_cast<std::uint32_t>(this->Count());
  if (found != last)
  {
    stack = found->second;
    this->Near[stack] = this->Near[stack] && isNear;
  }
  else
  {
    std::sort(this->Columns.begin(), this->Columns.end());
    for (const std::uint32_t column : this->Columns)
    {
      this->Entries.push_back({ column, this->LayersOfColumn[column] });
    }
    this->StacksOfHash.emplace(hash, stack);
    this->Starts.push_back(this->Entries.size());
    this->Near.push_back(isNear);
  }
  for (const std::uint32_t column : this->Columns)
  {
    this->LayersOfColumn[column] = 0;
  }
  this->Columns.clear();
  return stack;
}

std::uint32_t FrontStacks::Add(const std::uint32_t* layers, std::size_t count)
{
  this->Most = std::max(this->Most, count);
  if (count == 0)
  {
    return NoStack;
  }
  // A sum does not depend on the order of layers, so nothing has to be sorted to find a stack that is known.
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::uint32_t column = this->ColumnOf(layers[i]);
    hash += Mixed(column);
    if (this->LayersOfColumn[column]++ == 0)
    {
      this->Columns.push_back(column);
    }
  }
  return this->FindOrAdd(hash, false);
}

void FrontStacks::AddNear(const std::vector<Entry>& entries)
{
  std::uint64_t hash = 0;
  for (const Entry& entry : entries)
  {
    hash += entry.Layers * Mixed(entry.Column);
    this->LayersOfColumn[entry.Column] = entry.Layers;
    this->Columns.push_back(entry.Column);
  }
  this->FindOrAdd(hash, true);
}

FrontStacks FrontStacks::Without(const std::unordered_set<std::uint32_t>& parts) const
{
  FrontStacks rest;
  for (std::size_t stack = 0; stack < this->Count(); ++stack)
  {
    std::vector<std::uint32_t> layers;
    std::vector<Entry> entries;
    for (const Entry* entry = this->Begin(stack); entry != this->End(stack); ++entry)
    {
      const std::uint32_t part = this->PartOfColumn[entry->Column];
      if (parts.count(part) == 0)
      {
        layers.insert(layers.end(), entry->Layers, part);
        entries.push_back({ this->IsNear(stack) ? rest.ColumnOf(part) : 0, entry->Layers });
      }
    }
    if (!this->IsNear(stack))
    {
      rest.Add(layers.data(), layers.size());
    }
    else if (!entries.empty())
    {
      std::sort(entries.begin(), entries.end(),
        [](const Entry& a, const Entry& b) { return a.Column < b.Column; });
      rest.AddNear(entries);
    }
  }
  return rest;
}

}
