#include "Core/culling/LastOwners.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace vitrine
{

namespace
{
// Columns of lines that a part has to have.
const float LeastColumns = 16.0f;

// By so much of its width and height, and so many columns and lines, a part may have moved.
const float MostShare = 0.25f;
const float MostCells = 4.0f;

// Parts that were inserted in vain are inserted in one of so many frames, not all in the same.
const std::uint32_t FramesOfIdlers = 16;

// Those may have moved by so much: what is small and thin covers other samples then.
const float MostShareOfIdlers = 1.0f / 32.0f;
const float MostCellsOfIdlers = 1.0f / 16.0f;

/** Whether sides are no farther from each other than by a share of what is between them and so many columns or lines. */
bool IsWithin(const ScreenRectangle& then, const ScreenRectangle& now, float share, float cells)
{
  const float aside = cells + share * (then.Right - then.Left);
  const float above = cells + share * (then.Top - then.Bottom);
  return std::abs(now.Left - then.Left) <= aside && std::abs(now.Right - then.Right) <= aside &&
    std::abs(now.Bottom - then.Bottom) <= above && std::abs(now.Top - then.Top) <= above;
}
}

bool LastOwners::Owner::IsNear(const ScreenRectangle& now) const
{
  return IsWithin(this->Rectangle, now, MostShare, MostCells);
}

bool LastOwners::Owner::IsStill(const ScreenRectangle& now) const
{
  return IsWithin(this->Rectangle, now, MostShareOfIdlers, MostCellsOfIdlers);
}

void LastOwners::Begin(std::size_t parts)
{
  for (const Owner& inserted : this->Inserted)
  {
    this->Columns[inserted.Part] = 0.0f; // no others have any
  }
  this->Inserted.clear();
  this->Columns.resize(std::max(parts, this->Columns.size()), 0.0f);
  this->HasSamples = false;
  ++this->Frame;
}

bool LastOwners::HadNothing(std::uint32_t part, const ScreenRectangle& rectangle)
{
  const auto found = this->Idlers.find(part);
  if (found == this->Idlers.end() || !found->second.Inserted.IsStill(rectangle) ||
    (part + this->Frame) % FramesOfIdlers == 0)
  {
    return false;
  }
  found->second.IsMet = true;
  return true;
}

void LastOwners::End(const SBuffer& lines)
{
  lines.AddColumnsOfFaces(this->Columns);
  this->HasSamples = lines.BySample() != nullptr;
  this->Last.clear();
  for (const Owner& inserted : this->Inserted)
  {
    if (this->Columns[inserted.Part] >= LeastColumns)
    {
      this->Last.push_back(inserted);
    }
  }
}

void LastOwners::KeepIdlers(PartStates& states)
{
  for (auto i = this->Idlers.begin(); i != this->Idlers.end();)
  {
    if (std::exchange(i->second.IsMet, false))
    {
      ++i;
      continue;
    }
    if (i->first < states.Count())
    {
      states.Set(i->first, PartStates::WasIdle, false);
    }
    i = this->Idlers.erase(i);
  }
  for (const Owner& inserted : this->Inserted)
  {
    if (this->Columns[inserted.Part] == 0.0f && states.Has(inserted.Part, PartStates::IsShown))
    {
      states.Set(inserted.Part, PartStates::WasIdle);
      this->Idlers.insert_or_assign(inserted.Part, Idler{ inserted, false });
    }
  }
}

}
