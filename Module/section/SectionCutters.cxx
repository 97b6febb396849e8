#include "section/SectionCutters.h"

#include "scene/PartNumbers.h"
#include "vtkSection.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vitrine
{

namespace
{

/** The greatest distance of a plane from the origin. Single precision has room for products with it. */
constexpr double FarthestPlane = 1e30;

constexpr int FacesOfBox = 6;

bool IsFinite(const glm::dvec3& vector)
{
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

/** Returns a plane of VTK with a normal of length 1, or one that keeps everything if it has none. */
CutPlane UnitPlane(const double normal[3], const double origin[3])
{
  const glm::dvec3 given(normal[0], normal[1], normal[2]);
  const glm::dvec3 through(origin[0], origin[1], origin[2]);
  const double length = glm::length(given);
  if (!(length > 0.0) || !std::isfinite(length) || !IsFinite(through))
  {
    return { glm::dvec3(0.0, 0.0, 0.0), 1.0 };
  }
  const glm::dvec3 unit = given / length;
  return { unit, std::clamp(-glm::dot(unit, through), -FarthestPlane, FarthestPlane) };
}
}

bool Cutter::Cuts(vtkProp* prop, int block) const
{
  return this->Parts == vtkSection::ALL_PARTS ||
    this->IsChosen(prop, block) == (this->Parts == vtkSection::ONLY_CHOSEN);
}

/** Returns true if a block is chosen, or its prop. Any block stands for a prop whose blocks are no parts. */
bool Cutter::IsChosen(vtkProp* prop, int block) const
{
  const auto first = this->Chosen.lower_bound({ prop, EveryBlock });
  return first != this->Chosen.end() && first->first.first == prop && first->second &&
    (first->first.second == EveryBlock || this->Chosen.count({ prop, block }) > 0 ||
      !BlocksOf(prop));
}

bool Cutter::HasBlocksOf(vtkProp* prop) const
{
  const auto block = this->Chosen.upper_bound({ prop, EveryBlock });
  return this->Parts != vtkSection::ALL_PARTS && block != this->Chosen.end() &&
    block->first.first == prop && block->second;
}

Cutter* SectionCutters::Find(vtkPlane* plane)
{
  const auto found = std::find_if(this->Cutters.begin(), this->Cutters.end(),
    [plane](const Cutter& cutter) { return cutter.Plane == plane; });
  return found == this->Cutters.end() ? nullptr : &*found;
}

std::vector<CutPlane> SectionCutters::Planes() const
{
  std::vector<CutPlane> planes;
  for (const Cutter& cutter : this->Cutters)
  {
    planes.push_back(UnitPlane(cutter.Plane->GetNormal(), cutter.Plane->GetOrigin()));
  }
  for (int face = 0; this->HasBox && face < FacesOfBox; ++face)
  {
    const double inwards = face % 2 == 0 ? 1.0 : -1.0;
    glm::dvec3 normal(0.0);
    normal[face / 2] = this->BoxKeepsInside ? inwards : -inwards;
    const double place = normal[face / 2] * this->Box[static_cast<std::size_t>(face)];
    planes.push_back({ normal, std::clamp(-place, -FarthestPlane, FarthestPlane) });
  }
  return planes;
}

PlaneMasks SectionCutters::MasksOf(vtkProp* prop, int block) const
{
  PlaneMasks masks;
  for (std::size_t i = 0; i < this->Cutters.size(); ++i)
  {
    const std::uint32_t bit = this->Cutters[i].Cuts(prop, block) ? 1u << i : 0u;
    (this->RemoveBeyondAll ? masks.All : masks.Any) |= bit;
  }
  if (this->HasBox)
  {
    const std::uint32_t faces = ((1u << FacesOfBox) - 1u) << this->Cutters.size();
    (this->BoxKeepsInside ? masks.Any : masks.All) |= faces;
  }
  return masks;
}

std::vector<PlaneMasks> SectionCutters::MasksOfBlocks(vtkProp* prop) const
{
  if (!BlocksOf(prop) ||
    std::none_of(this->Cutters.begin(), this->Cutters.end(),
      [prop](const Cutter& cutter) { return cutter.HasBlocksOf(prop); }))
  {
    return {};
  }
  std::vector<PlaneMasks> masks(NumberOfNodes(BlocksOf(prop)));
  for (std::size_t block = 0; block < masks.size(); ++block)
  {
    masks[block] = this->MasksOf(prop, static_cast<int>(block));
  }
  return masks;
}

void SectionCutters::AddExact(ExactParts& parts) const
{
  const std::vector<CutPlane> planes = this->Planes();
  parts.Planes.insert(parts.Planes.end(), planes.begin(), planes.end());
  for (const Cutter& cutter : this->Cutters)
  {
    for (const auto& [part, prop] : cutter.Chosen)
    {
      if (prop && cutter.Parts != vtkSection::ALL_PARTS)
      {
        parts.Props.insert(part.first);
      }
    }
  }
}

PlaneMasks SectionCutters::MasksOfAnyBlock(vtkProp* prop) const
{
  PlaneMasks all = this->MasksOf(prop);
  for (const PlaneMasks& masks : this->MasksOfBlocks(prop))
  {
    all.Any |= masks.Any;
    all.All |= masks.All;
  }
  return all;
}

}
