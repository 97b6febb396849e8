#include "section/PropBoxes.h"

#include "scene/CutProps.h"
#include "scene/ExactParts.h"

#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cstddef>

namespace vitrine
{

namespace
{

/** Returns two roundings of the coordinates that sums have, from a center that may be far from the box. */
double RoundingOfSums(const CutPlane& plane, const WorldBox& box, const CutParts& parts)
{
  const glm::dvec3& center = parts.Center();
  const glm::dvec3 greatest = glm::max(glm::abs(box.Min - center), glm::abs(box.Max - center));
  return parts.Corners().empty() ? 0.0
                                 : 0.25 * MarginOf({ plane.Normal, plane.At(center) }, greatest);
}
}

double WorldBox::MarginOf(const CutPlane& plane) const
{
  const glm::dvec3 middle = 0.5 * (this->Min + this->Max);
  return vitrine::MarginOf({ plane.Normal, plane.At(middle) }, 0.5 * (this->Max - this->Min));
}

bool WorldBox::IsMetBy(const CutPlane& plane) const
{
  const double margin = this->MarginOf(plane);
  const DistanceRange range = DistancesOf(plane, this->Min, this->Max);
  return range.Least <= margin && range.Greatest >= -margin;
}

SectionPlanes PropBoxes::Place(vtkRenderer* renderer, const std::vector<CutPlane>& planes,
  const CutParts& parts, const WorldBox& scene)
{
  std::vector<WorldBox> met = this->ReadBoxesMetBy(renderer, planes);
  SectionPlanes placed;
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    if (!met[i].IsEmpty())
    {
      met[i].Add(scene);
    }
    const double margin = met[i].IsEmpty()
      ? 0.0
      : std::max(met[i].MarginOf(planes[i]), RoundingOfSums(planes[i], met[i], parts));
    placed.Margins.push_back(margin);
    placed.Planes.push_back(planes[i].MovedBy(margin));
  }
  return placed;
}

/** Returns for each plane the box around the props that it meets. */
std::vector<WorldBox> PropBoxes::ReadBoxesMetBy(
  vtkRenderer* renderer, const std::vector<CutPlane>& planes)
{
  std::vector<WorldBox> met(planes.size());
  this->Boxes.clear();
  const StandIns& standIns = StandInsOf(renderer);
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator place;
  props->InitTraversal(place);
  while (vtkProp* const prop = props->GetNextProp(place))
  {
    const bool counts = !met.empty() && standIns.IsSeen(prop) && !IsCap(prop);
    const double* const bounds = counts ? prop->GetBounds() : nullptr;
    if (!bounds || !(bounds[0] <= bounds[1]))
    {
      continue;
    }
    const WorldBox box{ { bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] } };
    this->Boxes.insert({ prop, box });
    for (std::size_t i = 0; prop->GetUseBounds() && i < met.size(); ++i)
    {
      if (box.IsMetBy(planes[i]))
      {
        met[i].Add(box);
      }
    }
  }
  return met;
}

bool PropBoxes::IsMet(vtkProp* prop, const SectionPlanes& planes) const
{
  const auto box = this->Boxes.find(prop);
  return box == this->Boxes.end() ||
    std::any_of(planes.Planes.begin(), planes.Planes.end(),
      [&](const CutPlane& plane) { return box->second.IsMetBy(plane); });
}

bool PropBoxes::MayRemoveFrom(
  vtkProp* prop, const PlaneMasks& masks, const SectionPlanes& planes) const
{
  const auto box = this->Boxes.find(prop);
  if (masks.Both() == 0 || box == this->Boxes.end())
  {
    return masks.Both() != 0;
  }
  const auto& [min, max] = box->second;
  bool isBeyondAll = masks.All != 0;
  for (std::size_t i = 0; i < planes.Planes.size(); ++i)
  {
    // Points are computed with roundings of the size of the margin.
    const bool reachesBeyond =
      !(DistancesOf(planes.Planes[i], min, max).Least >= planes.Margins[i] / 2);
    if (reachesBeyond && (masks.Any >> i & 1u) != 0)
    {
      return true;
    }
    isBeyondAll = isBeyondAll && (reachesBeyond || (masks.All >> i & 1u) == 0);
  }
  return isBeyondAll;
}

}
