#include "Core/culling/walk/LastOwners.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{
// An owner has at least so many columns of lines.
const float LeastColumns = 16.0f;

// An owner may have moved by this share of its width and height, and by this number of columns and lines.
const float MostShare = 0.25f;
const float MostCells = 4.0f;

// An idler is inserted in one of so many frames. Not all idlers have the same frame.
const std::uint32_t FramesOfIdlers = 16;

// An idler may have moved by less: a small or thin part covers other samples then.
const float MostShareOfIdlers = 1.0f / 32.0f;
const float MostCellsOfIdlers = 1.0f / 16.0f;

/** Returns true if each side has moved by no more than `share` of the size plus `cells` columns or lines. */
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
  this->Inserted.clear();
  this->IdlerOf.resize(std::max(parts, this->IdlerOf.size()), 0);
  ++this->Frame;
}

LastOwners::Idler* LastOwners::FindIdler(std::uint32_t part)
{
  const std::uint32_t number = this->IdlerOf[part];
  const bool isOne = number < this->Idlers.size() && this->Idlers[number].Inserted.Part == part;
  return isOne ? &this->Idlers[number] : nullptr;
}

void LastOwners::AddIdler(const Owner& inserted)
{
  this->IdlerOf[inserted.Part] = static_cast<std::uint32_t>(this->Idlers.size());
  this->Idlers.push_back({ inserted, false });
}

bool LastOwners::HadNothing(std::uint32_t part, const ScreenRectangle& rectangle)
{
  Idler* const idler = this->FindIdler(part);
  if (!idler || !idler->Inserted.IsStill(rectangle) || (part + this->Frame) % FramesOfIdlers == 0)
  {
    return false;
  }
  idler->IsMet = true;
  return true;
}

void LastOwners::End(const SBuffer& lines, PartStates& states)
{
  this->Columns.assign(this->Inserted.size(), 0.0f);
  lines.AddColumnsOfFaces(this->Columns);
  this->Last.clear();
  for (std::size_t i = 0; i < this->Inserted.size(); ++i)
  {
    if (this->Columns[i] >= LeastColumns)
    {
      this->Last.push_back(this->Inserted[i]);
    }
    if (this->Columns[i] > 0.0f && lines.BySample())
    {
      states.Set(this->Inserted[i].Part, PartStates::HasSamples);
    }
  }
}

void LastOwners::KeepIdlers(PartStates& states)
{
  this->Before.swap(this->Idlers);
  this->Idlers.clear();
  for (const Idler& idler : this->Before)
  {
    if (idler.IsMet)
    {
      this->AddIdler(idler.Inserted);
    }
    else if (idler.Inserted.Part < states.Count())
    {
      states.Set(idler.Inserted.Part, PartStates::WasIdle, false);
    }
  }
  for (std::size_t i = 0; i < this->Inserted.size(); ++i)
  {
    const Owner& inserted = this->Inserted[i];
    if (this->Columns[i] == 0.0f && states.Has(inserted.Part, PartStates::IsShown))
    {
      states.Set(inserted.Part, PartStates::WasIdle);
      this->AddIdler(inserted);
    }
  }
}

}
