// Forgets deleted props, and props that were not drawn for long.
#include "culling/SceneParts.h"

#include "vtkProp.h"

#include <algorithm>
#include <utility>

namespace vitrine
{

namespace
{
// If parts were absent for more updates than this, all parts are read anew: they may be deleted.
const vtkMTimeType LongestAbsence = 200;
}

/**
 * Begins anew once in a while, if there are parts to be forgotten. Keeps what is known of the data of the other parts
 * until these are found again.
 */
void SceneParts::ForgetAbsent()
{
  if (this->Frame % LongestAbsence != 0)
  {
    return;
  }
  const auto isThere = [this](std::size_t i)
  { return this->SeenIn[i] + LongestAbsence >= this->Frame; };
  bool isAnyAbsent = false;
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    isAnyAbsent = isAnyAbsent || (this->PropOf[i] && !isThere(i));
  }
  if (!isAnyAbsent)
  {
    return;
  }
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    if (isThere(i))
    {
      this->Kept.push_back(std::move(this->Parts[i].Geometry));
    }
  }
  this->Parts.clear();
  this->PropOf.clear();
  this->Living.clear();
  this->SeenIn.clear();
  this->Spare.clear();
  this->HasPieces.clear();
  this->Blends.clear();
  this->BoxOf.clear();
  this->Index.clear();
  this->Boxes = LooseOctree();
  this->ViewAlone.clear();
}

void SceneParts::ForgetRemoved()
{
  std::vector<std::uint32_t> moved;
  for (std::uint32_t i = 0; i < this->Parts.size(); ++i)
  {
    const Part& part = this->Parts[i];
    if (this->PropOf[i] && !this->Living[i] && (part.Geometry || part.Division))
    {
      this->ForgetPart(i, moved);
    }
  }
  if (!moved.empty())
  {
    this->Replant(moved);
  }
}

/** Forgets all of a part but its number: another prop may come to be at its address. */
void SceneParts::ForgetPart(std::uint32_t part, std::vector<std::uint32_t>& moved)
{
  this->Parts[part].Division.reset();
  this->FitPieces(part, moved);
  this->Parts[part] = Part();
  this->Place(part, Box(), moved);
}

}
