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

/**
 * Returns true if nothing has changed. Looks at a node only if its group has not changed: otherwise the node may be
 * deleted.
 */
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
 * Visits a node and all below it. As in VTK, the innermost visibility counts. A block is opaque only if no opacity on
 * the way to it is less than 1, while VTK looks at the innermost alone.
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

/**
 * Merges leaves with the same data. Older versions of VTK draw them as the last of their blocks, newer ones as all of
 * them.
 */
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

/** Takes over the geometries of data that have not changed. */
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
    // A device gets the points of all blocks anew after one of them was modified in any way.
    leaf.Geometry = isKnown && known->Time == leaf.Time
      ? known->Geometry
      : std::make_shared<PartGeometry>(leaf.Data,
          isKnown && known->Geometry->WasOf(leaf.Data) ? known->Geometry.get() : nullptr);
  }
}

/**
 * Returns the largest absolute coordinates of all blocks, from the origin. VTK may draw a block relative to its middle,
 * and if it comes first, all blocks are relative to that. So ways by the middle of such a block count, too.
 */
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

/**
 * Makes the parts, in the order of the data set. That is the same in each run of a program, and the order of addresses
 * is not.
 */
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
