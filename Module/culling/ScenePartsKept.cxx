// Keeps props so that VTK draws as if nothing was left out.
#include "culling/SceneParts.h"

#include "vtkProp.h"

#include <cstddef>
#include <optional>

namespace vitrine
{

bool SceneParts::HasOthersThanParts() const
{
  for (std::size_t i = 0; i < this->Drawn.size(); ++i)
  {
    // A prop that surely is unchanged is a part.
    if (!this->AreSame[i] && !this->Parts[this->Drawn[i]].Actor)
    {
      return true;
    }
  }
  return false;
}

void SceneParts::ShowWhole(std::vector<std::uint8_t>& visible) const
{
  for (std::size_t i = 0; i < this->Drawn.size(); ++i)
  {
    const Part& part = this->Parts[this->Drawn[i]];
    if (!part.Blocks || !this->Shows(i, visible))
    {
      continue;
    }
    for (const std::uint32_t piece : part.Pieces)
    {
      if (visible[piece] == IsLeftOut)
      {
        visible[piece] = MayShow;
      }
    }
  }
}

void SceneParts::KeepOneTranslucent(std::vector<std::uint8_t>& visible, std::uint8_t reason) const
{
  std::optional<std::uint32_t> leftOut;
  for (std::size_t i = 0; i < this->Drawn.size(); ++i)
  {
    const std::uint32_t part = this->Drawn[i];
    const bool shows = this->Shows(i, visible);
    if ((shows || !leftOut) && this->MayBeTranslucent(part) &&
      this->PropOf[part]->HasTranslucentPolygonalGeometry())
    {
      if (shows)
      {
        return;
      }
      leftOut = part;
    }
  }
  if (leftOut)
  {
    this->Mark(*leftOut, visible, reason);
  }
}

void SceneParts::KeepOne(std::vector<std::uint8_t>& visible, std::uint8_t reason) const
{
  for (std::size_t i = 0; i < this->Drawn.size(); ++i)
  {
    if (this->Shows(i, visible))
    {
      return;
    }
  }
  if (!this->Drawn.empty())
  {
    this->Mark(this->Drawn.front(), visible, reason);
  }
}

/** Returns true if any part of the i-th prop shows. */
bool SceneParts::Shows(std::size_t i, const std::vector<std::uint8_t>& visible) const
{
  const int number = static_cast<int>(i);
  return this->CountHidden(number, visible) < this->CountParts(number);
}

/**
 * Returns false if a prop surely is not translucent. That saves to ask VTK, which takes longer. Blocks are asked one by
 * one.
 */
bool SceneParts::MayBeTranslucent(std::uint32_t part) const
{
  const Part& known = this->Parts[part];
  return !known.Actor || known.Divided || !this->IsOpaque(known);
}

}
