#include "culling/mappers/BlockParts.h"

#include "culling/PartGeometry.h"
#include "culling/PartRules.h"
#include "culling/mappers/BlockDrawing.h"
#include "scene/ScalarColors.h"

#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkPolyData.h"

#include <glm/common.hpp>

#include <algorithm>
#include <functional>
#include <limits>

namespace vitrine
{

std::shared_ptr<const MapperParts> BlockParts::PartsFor(vtkActor*, vtkMTimeType)
{
  if (!this->IsCurrent())
  {
    this->Divide();
  }
  return this->Known;
}

/** Looks at each node only if what holds it has not changed: else it may be gone. */
bool BlockParts::IsCurrent() const
{
  return this->Known && this->Mapper->GetMTime() == this->MapperTime &&
    this->Mapper->GetInputDataObject(0, 0) == this->Nodes.front().Object &&
    std::all_of(this->Nodes.begin(), this->Nodes.end(),
      [](const Node& node) { return node.Object->GetMTime() == node.Time; });
}

void BlockParts::Divide()
{
  this->MapperTime = this->Mapper->GetMTime();
  const std::vector<Leaf> before = std::move(this->Leaves);
  this->Leaves.clear();
  this->Nodes.clear();
  this->Known.reset();
  this->BringTables = false;
  vtkDataObject* const root = this->Mapper->GetInputDataObject(0, 0);
  if (root)
  {
    this->Visit(root, {});
  }
  if (root && !this->BringTables)
  {
    this->MergeLeaves();
    this->FindGeometries(before);
    this->MakeParts();
  }
}

/**
 * The innermost of a block's visibilities counts, as in VTK. Of opacities none may be less than 1, which is less than VTK asks for.
 */
void BlockParts::Visit(vtkDataObject* object, Inherited inherited)
{
  this->Nodes.push_back({ object, object->GetMTime() });
  if (auto* attributes = this->Mapper->GetCompositeDataDisplayAttributes())
  {
    if (attributes->HasBlockVisibility(object))
    {
      inherited.IsVisible = attributes->GetBlockVisibility(object);
    }
    inherited.IsOpaque = inherited.IsOpaque && !HasColorsOfItsOwn(attributes, object) &&
      !(attributes->HasBlockOpacity(object) && !(attributes->GetBlockOpacity(object) >= 1.0));
  }
  if (auto* tree = vtkDataObjectTree::SafeDownCast(object))
  {
    for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::SkipEmptyNodes))
    {
      this->Visit(child, inherited);
    }
  }
  else if (auto* data = vtkPolyData::SafeDownCast(object))
  {
    this->AddLeaf(data, inherited);
  }
}

void BlockParts::AddLeaf(vtkPolyData* data, const Inherited& inherited)
{
  if (data->GetNumberOfPoints() > 0)
  {
    this->Leaves.push_back({ data, data->GetMTime(),
      static_cast<std::uint32_t>(this->Leaves.size()), inherited.IsVisible,
      inherited.IsVisible && inherited.IsOpaque && AreBlockColorsOpaque(this->Mapper, data),
      nullptr });
    this->BringTables =
      this->BringTables || BringTheirTable(this->Mapper, ScalarsOf(this->Mapper, data));
  }
}

/** Data that several blocks share are drawn as the last of them, in older versions, or as all of them. */
void BlockParts::MergeLeaves()
{
  std::stable_sort(this->Leaves.begin(), this->Leaves.end(),
    [](const Leaf& a, const Leaf& b) { return std::less<vtkPolyData*>()(a.Data, b.Data); });
  std::size_t kept = 0;
  for (const Leaf& leaf : this->Leaves)
  {
    if (kept > 0 && this->Leaves[kept - 1].Data == leaf.Data)
    {
      Leaf& same = this->Leaves[kept - 1];
      same.IsVisible = same.IsVisible || leaf.IsVisible;
      same.IsOpaque = same.IsOpaque && leaf.IsOpaque;
    }
    else
    {
      this->Leaves[kept++] = leaf;
    }
  }
  this->Leaves.resize(kept);
}

/** Takes what is known of data that have not changed. */
void BlockParts::FindGeometries(const std::vector<Leaf>& before)
{
  auto known = before.begin();
  for (Leaf& leaf : this->Leaves)
  {
    while (known != before.end() && std::less<vtkPolyData*>()(known->Data, leaf.Data))
    {
      ++known;
    }
    const bool isKnown = known != before.end() && known->Data == leaf.Data;
    // A device is given the points of all blocks once one of them was modified in any way.
    leaf.Geometry = isKnown && known->Time == leaf.Time
      ? known->Geometry
      : std::make_shared<PartGeometry>(leaf.Data,
          isKnown && known->Geometry->WasOf(leaf.Data) ? known->Geometry.get() : nullptr);
  }
}

/** Of all blocks, from the origin; and by way of the middle of a block that VTK may draw about its middle, which is where all of them count from if it comes first. */
glm::dvec3 BlockParts::FarthestCoordinates() const
{
  glm::dvec3 least(std::numeric_limits<double>::infinity()), greatest = -least;
  for (const Leaf& leaf : this->Leaves)
  {
    least = glm::min(least, leaf.Geometry->Least());
    greatest = glm::max(greatest, leaf.Geometry->Greatest());
  }
  glm::dvec3 farthest = glm::max(glm::abs(least), glm::abs(greatest));
  for (const Leaf& leaf : this->Leaves)
  {
    if (IsSmallOrFarOff(*leaf.Geometry))
    {
      const glm::dvec3 middle = 0.5 * (leaf.Geometry->Least() + leaf.Geometry->Greatest());
      farthest = glm::max(farthest, glm::abs(middle) + glm::max(greatest - middle, middle - least));
    }
  }
  return farthest;
}

/** Parts stand in the order of the data set, which is the same in each run of a program; addresses are not. */
void BlockParts::MakeParts()
{
  auto blocks = std::make_shared<Blocks>();
  blocks->Farthest = this->FarthestCoordinates();
  std::vector<std::pair<std::uint32_t, const Leaf*>> shown;
  for (const Leaf& leaf : this->Leaves)
  {
    blocks->IsFinite = blocks->IsFinite && leaf.Geometry->IsFinite();
    if (leaf.IsVisible)
    {
      shown.push_back({ static_cast<std::uint32_t>(shown.size()), &leaf });
    }
  }
  std::sort(shown.begin(), shown.end(),
    [](const auto& a, const auto& b) { return a.second->Place < b.second->Place; });
  blocks->ByAddress.resize(shown.size());
  for (const auto& [rank, leaf] : shown)
  {
    blocks->ByAddress[rank] = static_cast<std::uint32_t>(blocks->Parts.size());
    blocks->Parts.push_back({ leaf->Data, leaf->Geometry, leaf->IsOpaque });
  }
  this->Known = std::move(blocks);
}

}
