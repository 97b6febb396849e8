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
}

bool LastOwners::Owner::IsNear(const ScreenRectangle& now) const
{
  const ScreenRectangle& then = this->Rectangle;
  const float aside = MostCells + MostShare * (then.Right - then.Left);
  const float above = MostCells + MostShare * (then.Top - then.Bottom);
  return std::abs(now.Left - then.Left) <= aside && std::abs(now.Right - then.Right) <= aside &&
    std::abs(now.Bottom - then.Bottom) <= above && std::abs(now.Top - then.Top) <= above;
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
  if (found == this->Idlers.end() || !found->second.Inserted.IsNear(rectangle) ||
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

void LastOwners::KeepIdlers(const PartStates& states)
{
  for (auto i = this->Idlers.begin(); i != this->Idlers.end();)
  {
    i = std::exchange(i->second.IsMet, false) ? std::next(i) : this->Idlers.erase(i);
  }
  for (const Owner& inserted : this->Inserted)
  {
    if (this->Columns[inserted.Part] == 0.0f && states.Has(inserted.Part, PartStates::IsShown))
    {
      this->Idlers.insert_or_assign(inserted.Part, Idler{ inserted, false });
    }
  }
}

}
