#include "Core/culling/PartCuller.h"

#include "Core/culling/OctreeWalk.h"

#include <algorithm>
#include <cassert>

namespace vitrine
{

namespace
{
// Meshes of more points are not projected before they are known to show: their boxes decide.
const std::size_t FewPoints = 64;

// An occluder with more faces to a cell of the screen takes longer than what it hides is worth.
const float MostFacesPerCell = 4.0f;

// To project so many faces takes as long as a piece of one on a line.
const std::size_t FacesPerPiece = 8;

const ScreenRectangle Everywhere{ -1e30f, 1e30f, -1e30f, 1e30f, 1.0f };

bool IsDense(const ScreenRectangle& rectangle, std::size_t faces)
{
  const float cells = (rectangle.Right - rectangle.Left) * (rectangle.Top - rectangle.Bottom);
  return static_cast<float>(faces) > cells * MostFacesPerCell;
}

// Occluders of no more get one depth.
const float FewColumns = 16.0f;
const float FewLines = 8.0f;
}

/** Visits nodes and parts in one frame. */
class PartCuller::Walk
{
public:
  Walk(PartCuller& culler, const Octree& tree, const std::vector<Box>& bounds,
    OccluderSource& occluders, const CullView& view, bool occlusion,
    std::vector<std::uint8_t>& visible)
    : Culler(culler)
    , Tree(tree)
    , Bounds(bounds)
    , Occluders(occluders)
    , View(view)
    , HasOcclusion(occlusion)
    , Visible(visible)
  {
  }

  bool Enter(const OctreeNode& node)
  {
    ++this->Culler.Counted.Nodes;
    ScreenRectangle rectangle;
    return this->MayShow(node.Bounds, rectangle, [&] { return this->CountBelow(node); });
  }

  void Visit(const OctreeNode&, const std::uint32_t* items, std::uint32_t count)
  {
    for (std::uint32_t i = 0; i < count; ++i)
    {
      if (!this->Culler.IsTested[items[i]] && this->Visible[items[i]])
      {
        this->Culler.IsTested[items[i]] = 1;
        this->Visible[items[i]] = this->VisitPart(items[i]);
      }
    }
  }

  /** What the walk has not come to does not show, but for items that have no place. */
  void DropUntested(const std::vector<std::uint32_t>& unplaced)
  {
    for (const std::uint32_t item : unplaced)
    {
      this->Culler.IsTested[item] = 1;
    }
    for (std::size_t i = 0; i < this->Visible.size(); ++i)
    {
      this->Visible[i] &= this->Culler.IsTested[i];
    }
  }

private:
  /**
   * Writes the rectangle of a box that lies behind the near plane; an endless one for others.
   * @param count  tells how many parts are in it
   */
  template <class Count>
  bool MayShow(const Box& box, ScreenRectangle& rectangle, const Count& count)
  {
    switch (this->View.Projection.Project(box, rectangle))
    {
      case ScreenProjection::Place::Outside:
        return false;
      case ScreenProjection::Place::Near:
        rectangle = Everywhere;
        return true;
      case ScreenProjection::Place::Before:
        if (!this->HasOcclusion || !this->Culler.Lines.Hides(rectangle, 0.0f))
        {
          return true;
        }
        this->Culler.Budget.AddHidden(count());
        return false;
    }
    return true;
  }

  /** Items of pages that were loaded just now are not counted. */
  std::uint32_t CountBelow(const OctreeNode& node) const
  {
    const OctreeNode* first = this->Tree.TopPage().Nodes.data();
    const std::size_t index = static_cast<std::size_t>(&node - first);
    return &node >= first && index < this->Culler.ItemsBelow.size() ? this->Culler.ItemsBelow[index]
                                                                    : 1;
  }

  bool VisitPart(std::uint32_t item)
  {
    ++this->Culler.Counted.Tested;
    ScreenRectangle rectangle;
    if (!this->MayShow(this->Bounds[item], rectangle, [] { return 1; }))
    {
      return false;
    }
    const Occluder occluder = this->HasOcclusion ? this->Occluders.OccluderOf(item) : Occluder();
    if (!occluder.Mesh)
    {
      return true;
    }
    const bool isSmall = occluder.Mesh->PointCount() <= FewPoints;
    const std::size_t faces = occluder.Mesh->Faces().size();
    const bool isWorthInserting =
      !IsDense(rectangle, faces) && this->Culler.Budget.Allows(faces / FacesPerPiece);
    if (!isSmall && !isWorthInserting)
    {
      return true;
    }
    const bool isBehindNear = this->Culler.Projected.Project(
      *occluder.Mesh, this->View.Projection.Of(*occluder.ToWorld, occluder.Coarser));
    if (isBehindNear && isSmall &&
      this->Culler.Lines.Hides(
        this->View.Projection.Grown(this->Culler.Projected.Rectangle()), 0.0f))
    {
      this->Culler.Budget.AddHidden(1);
      return false;
    }
    if (isWorthInserting)
    {
      this->InsertPart(item, occluder);
    }
    return true;
  }

  void InsertPart(std::uint32_t item, const Occluder& occluder)
  {
    ++this->Culler.Counted.Inserted;
    this->Culler.Budget.Spend(occluder.Mesh->Faces().size() / FacesPerPiece);
    this->Culler.Projected.FindFacings();
    this->InsertFaces(item, MeshProjection::Facing::Front);
    if (occluder.HasBackFaces && !occluder.Mesh->IsClosed())
    {
      this->InsertFaces(item, MeshProjection::Facing::Back);
    }
  }

  void InsertFaces(std::uint32_t item, MeshProjection::Facing facing)
  {
    const ScreenRectangle& around = this->Culler.Projected.Rectangle();
    if (around.Right - around.Left <= FewColumns && around.Top - around.Bottom <= FewLines)
    {
      this->Culler.Budget.Spend(
        this->Culler.CoverOfFew.Insert(this->Culler.Lines, this->Culler.Projected, facing, item));
    }
    else
    {
      this->Culler.Budget.Spend(
        this->Culler.CoverOfMany.Insert(this->Culler.Lines, this->Culler.Projected, facing, item));
    }
  }

  PartCuller& Culler;
  const Octree& Tree;
  const std::vector<Box>& Bounds;
  OccluderSource& Occluders;
  const CullView& View;
  bool HasOcclusion;
  std::vector<std::uint8_t>& Visible;
};

PartCuller::PartCuller(int columns, int lines, const SampleGrid& samples)
  : Lines(columns, lines, samples)
{
}

void PartCuller::Cull(const Octree& tree, const std::vector<Box>& bounds, OccluderSource& occluders,
  const CullView& view, bool occlusion, std::vector<std::uint8_t>& visible)
{
  assert(visible.size() == bounds.size());
  this->Lines.Clear();
  this->Counted = {};
  this->IsTested.assign(bounds.size(), 0);
  if (occlusion)
  {
    this->CountItemsBelow(tree);
    this->Budget.Begin(static_cast<std::size_t>(std::count(visible.begin(), visible.end(), 1)));
  }
  Walk walk(*this, tree, bounds, occluders, view, occlusion, visible);
  if (view.IsParallel)
  {
    WalkFrontToBack(tree, OrderAlong(view.Eye), walk);
  }
  else
  {
    WalkFrontToBack(tree, OrderFromEye(view.Eye), walk);
  }
  walk.DropUntested(tree.UnplacedItems());
}

/** Children stand behind their parents. Where a tree has changed since and has as many nodes, it is near enough. */
void PartCuller::CountItemsBelow(const Octree& tree)
{
  const std::vector<OctreeNode>& nodes = tree.TopPage().Nodes;
  if (this->ItemsBelow.size() == nodes.size())
  {
    return;
  }
  this->ItemsBelow.assign(nodes.size(), 1);
  for (std::size_t i = nodes.size(); i-- > 0;)
  {
    const OctreeNode& node = nodes[i];
    std::uint32_t count = node.IsLeaf() ? node.Count() : 0;
    for (int slot = 0; node.Kind() == OctreeNode::Kinds::Inner && slot <= OctreeNode::OwnSlot;
         ++slot)
    {
      count += node.HasChild(slot) ? this->ItemsBelow[node.Child(slot)] : 0;
    }
    this->ItemsBelow[i] = std::max(count, 1u);
  }
}

}
