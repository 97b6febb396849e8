#include "Core/culling/BandCuller.h"

#include "Core/culling/HiddenFaces.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace vitrine
{

namespace
{
// An occluder with more faces to a cell of the screen takes longer than what it hides is worth.
const float MostFacesPerCell = 32.0f;

// Where a part that is dense has more faces, some of those are always so thin that nothing is known of where a device draws them.
const std::size_t MostFacesToLookAt = 1024;

// To project so many faces takes as long as a piece of one on a line.
const std::size_t FacesPerPiece = 8;
const std::size_t CutFacesPerPiece = 2; // the same, and cut at the near plane

bool IsDense(const ScreenRectangle& rectangle, std::size_t faces)
{
  const float cells = (rectangle.Right - rectangle.Left) * (rectangle.Top - rectangle.Bottom);
  return static_cast<float>(faces) > std::max(cells, 1.0f) * MostFacesPerCell;
}

// Occluders of no more get one depth.
const float FewColumns = 24.0f;
const float FewLines = 16.0f;

// Nodes of no more parts are visited at once: that takes less than to queue what is in them.
const std::uint32_t FewParts = 16;

// Of what is long, which comes first, and of what reaches before the near plane.
const float LongDepth = 3.0f;
const float NearDepth = 2.0f;

const ScreenRectangle Everywhere = { -1e30f, 1e30f, -1e30f, 1e30f, 1.0f };
}

/** Visits nodes and parts in one frame. */
class BandCuller::Walk
{
public:
  Walk(BandCuller& culler, const LooseOctree& tree, OccluderSource& occluders,
    const ScreenProjection& view, bool occlusion, const std::vector<std::uint8_t>& drawn)
    : Culler(culler)
    , Tree(tree)
    , Occluders(occluders)
    , View(view)
    , HasOcclusion(occlusion)
    , IsDrawn(drawn)
    , Faces(culler.Lines, view)
  {
  }

  /** Visits all that may show, the nearest first. */
  void Run()
  {
    std::vector<Entry>& queue = this->Culler.Queue;
    queue.clear();
    this->Culler.Visited.clear();
    this->VisitOwners();
    this->QueueEntriesOf(this->Tree.Node(0));
    while (!queue.empty())
    {
      std::pop_heap(queue.begin(), queue.end());
      const Entry nearest = queue.back();
      queue.pop_back();
      this->Visit(nearest);
    }
    if (this->HasOcclusion)
    {
      this->LookAgain();
    }
  }

private:
  /** What hid much in the last frame, before what it may hide. */
  void VisitOwners()
  {
    this->Culler.Owners.Begin(this->IsDrawn.size());
    for (const LastOwners::Owner& owner : this->Culler.Owners.Owners())
    {
      if (this->HasOcclusion && this->IsThere(owner.Part))
      {
        this->VisitOwner(owner);
      }
    }
  }

  /** Whether a part of the last frame is one of this frame. */
  bool IsThere(std::uint32_t part) const
  {
    return part < this->IsDrawn.size() && this->IsDrawn[part] != 0 && this->Tree.Holds(part);
  }

  /** Leaves it to its turn if it has moved, or can only be tested by its box. */
  void VisitOwner(const LastOwners::Owner& owner)
  {
    const Occluder occluder = this->Occluders.OccluderOf(owner.Part);
    if (!occluder.Mesh || !occluder.IsOfFacesAlone)
    {
      return;
    }
    const bool isBehindNear = this->Project(occluder);
    const ScreenRectangle around = this->Culler.Projected.Rectangle();
    if (!owner.IsNear(around) || !this->IsWorthItsTime(occluder, around))
    {
      return;
    }
    this->Culler.Owners.MarkVisited(owner.Part);
    this->Witness = isBehindNear ? this->View.Grown(around) : Everywhere;
    const ScreenRectangle rectangle = this->Witness;
    if (this->ShowFaces(owner.Part, occluder, around))
    {
      this->Show(owner.Part, rectangle);
    }
    else
    {
      this->Culler.Budget.AddHidden(1);
    }
  }

  void Show(std::uint32_t part, const ScreenRectangle& rectangle)
  {
    this->Culler.Shows[part] = 1;
    this->Culler.Visited.push_back({ part, rectangle, this->Witness });
  }

  /** Tests what was shown before all that stands in front of it had been inserted. */
  void LookAgain()
  {
    for (const ShownPart& shown : this->Culler.Visited)
    {
      if (this->IsHidden(shown.Witness) &&
        this->IsHiddenNow(this->Occluders.OccluderOf(shown.Part), shown.Rectangle))
      {
        this->Culler.Shows[shown.Part] = 0;
        this->Culler.Budget.AddHidden(1);
      }
    }
  }

  bool IsHiddenNow(const Occluder& occluder, const ScreenRectangle& rectangle)
  {
    if (this->IsHidden(rectangle) || this->AreBoxesHidden(occluder))
    {
      return true;
    }
    if (!occluder.Mesh || !this->IsWorthItsTime(occluder, rectangle))
    {
      return false;
    }
    this->Project(occluder);
    return this->AreFacesHidden(occluder);
  }

  void Visit(const Entry& entry)
  {
    const std::uint32_t number = entry.Number & LooseNode::NumberBits;
    if ((entry.Number & LooseNode::ItemBit) != 0)
    {
      if (entry.Depth == NearDepth && this->QueueByFaces(entry))
      {
        return;
      }
      if (this->VisitPart(number, entry.Rectangle))
      {
        this->Show(number, entry.Rectangle);
      }
    }
    else if (this->IsHidden(entry.Rectangle))
    {
      this->Culler.Budget.AddHidden(entry.PartCount);
    }
    else if (entry.PartCount <= FewParts)
    {
      this->VisitEntriesOf(this->Tree.Node(number));
    }
    else
    {
      this->QueueEntriesOf(this->Tree.Node(number));
    }
  }

  /** Has a part whose box reaches before the near plane come when its nearest face does. Returns false if it has no faces, or they are not worth their time. */
  bool QueueByFaces(const Entry& entry)
  {
    const Occluder occluder = this->HasOcclusion
      ? this->Occluders.OccluderOf(entry.Number & LooseNode::NumberBits)
      : Occluder{};
    if (!occluder.Mesh || !this->IsWorthItsTime(occluder, entry.Rectangle))
    {
      return false;
    }
    this->Project(occluder);
    const float depth = this->Culler.Projected.NearestOnScreen(this->Culler.Lines);
    this->Push({ depth, entry.Rectangle, entry.Number, entry.PartCount });
    return true;
  }

  void Push(const Entry& entry)
  {
    this->Culler.Queue.push_back(entry);
    std::push_heap(this->Culler.Queue.begin(), this->Culler.Queue.end());
  }

  void QueueEntriesOf(const LooseNode& node)
  {
    Entry entries[LaneCount];
    const int count = this->FindEntries(node, entries);
    for (int i = 0; i < count; ++i)
    {
      this->Push(entries[i]);
    }
  }

  void VisitEntriesOf(const LooseNode& node)
  {
    Entry entries[LaneCount];
    Entry* end = entries + this->FindEntries(node, entries);
    for (std::make_heap(entries, end); end != entries; --end)
    {
      std::pop_heap(entries, end);
      this->Visit(end[-1]);
    }
  }

  /** Those that may lie in the view. What is long comes before all else: it may hide much. */
  int FindEntries(const LooseNode& node, Entry (&entries)[LaneCount])
  {
    ++this->Culler.Counted.Nodes;
    RectangleLanes rectangles;
    this->View.Project(node.Boxes, rectangles);
    int count = 0;
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      if (!node.Has(lane) || (rectangles.Outside >> lane & 1u) != 0 || !this->IsWanted(node, lane))
      {
        continue;
      }
      const bool isNear = (rectangles.Near >> lane & 1u) != 0;
      const bool isLong = node.IsLong(lane);
      const float depth = isNear ? NearDepth : isLong ? LongDepth : rectangles.Nearest[lane];
      entries[count++] = { depth, isNear ? Everywhere : rectangles.At(lane), node.Entries[lane],
        node.Counts[lane] };
    }
    return count;
  }

  bool IsWanted(const LooseNode& node, int lane)
  {
    if (!node.IsItem(lane))
    {
      this->Tree.Expect(node.NodeAt(lane));
      return true;
    }
    const std::uint32_t item = node.ItemAt(lane);
    this->Culler.Counted.Tested += this->IsDrawn[item];
    this->Occluders.Expect(item);
    return this->IsDrawn[item] != 0 && !this->Culler.Owners.WasVisited(item);
  }

  bool IsHidden(const ScreenRectangle& rectangle) const
  {
    return this->HasOcclusion && this->Culler.Lines.Hides(rectangle);
  }

  /** Whether a part may show. Its box is not tested if its points are, which are as quickly projected. */
  bool VisitPart(std::uint32_t item, const ScreenRectangle& rectangle)
  {
    if (!this->HasOcclusion)
    {
      return true;
    }
    if (!this->Culler.WasSmall[item] && this->IsHidden(rectangle))
    {
      this->Culler.Budget.AddHidden(1);
      return false;
    }
    this->Witness = rectangle;
    const Occluder occluder = this->Occluders.OccluderOf(item);
    const bool isSmall = occluder.Mesh && occluder.Mesh->PointCount() <= FewPointsOfAMesh;
    const bool wasSmall = std::exchange(this->Culler.WasSmall[item], isSmall) != 0;
    const bool isShown = isSmall ? this->ShowSmall(item, occluder, rectangle)
                                 : this->ShowLarge(item, occluder, rectangle, wasSmall);
    this->Culler.Budget.AddHidden(!isShown);
    return isShown;
  }

  bool ShowSmall(std::uint32_t item, const Occluder& occluder, const ScreenRectangle& rectangle)
  {
    const bool isBehindNear = this->Project(occluder);
    if (isBehindNear && this->IsHidden(this->View.Grown(this->Culler.Projected.Rectangle())))
    {
      return false;
    }
    return this->ShowFaces(item, occluder, rectangle);
  }

  bool ShowLarge(
    std::uint32_t item, const Occluder& occluder, const ScreenRectangle& rectangle, bool isUntested)
  {
    if ((isUntested && this->IsHidden(rectangle)) || this->AreBoxesHidden(occluder))
    {
      return false;
    }
    if (occluder.Mesh && this->IsWorthItsTime(occluder, rectangle))
    {
      this->Project(occluder);
      return this->ShowFaces(item, occluder, rectangle);
    }
    return true;
  }

  /** Of a part that is projected: whether a face of it may show. */
  bool ShowFaces(std::uint32_t item, const Occluder& occluder, const ScreenRectangle& rectangle)
  {
    if (!this->IsWorthItsTime(occluder, rectangle))
    {
      return true;
    }
    if (this->AreFacesHidden(occluder))
    {
      return false;
    }
    this->InsertPart(item, occluder);
    return true;
  }

  /** Of a part that is projected. */
  bool AreFacesHidden(const Occluder& occluder)
  {
    MeshProjection& projected = this->Culler.Projected;
    this->Culler.Budget.Spend(occluder.Mesh->Faces().size() / FacesPerPiece);
    if (!occluder.IsOfFacesAlone || occluder.Mesh->Faces().empty())
    {
      return false;
    }
    projected.FindFacings();
    if (!this->Faces.AreAll(projected))
    {
      this->Witness = this->Faces.Witness();
      return false;
    }
    return !projected.MayShowBeforeNear();
  }

  /** Whether back faces of a part that is projected may show. */
  bool HasBackFaces(const Occluder& occluder) const
  {
    const bool isWhole = occluder.Mesh->IsClosed() && this->Culler.Projected.IsBehindNear();
    return occluder.HasBackFaces && !isWhole;
  }

  bool AreBoxesHidden(const Occluder& occluder) const
  {
    return occluder.Boxes &&
      occluder.Boxes->AreHidden(this->Culler.Lines, this->View, *occluder.ToWorld);
  }

  /** Returns whether all of it lies behind the near plane; if not it is cut there, which takes long. */
  bool Project(const Occluder& occluder)
  {
    const bool isBehindNear =
      this->Culler.Projected.Project(*occluder.Mesh, this->View.Of(*occluder.ToWorld));
    if (!isBehindNear)
    {
      this->Culler.Budget.Spend(occluder.Mesh->Faces().size() / CutFacesPerPiece);
    }
    return isBehindNear;
  }

  /** Whether its faces may be tested, and inserted. */
  bool IsWorthItsTime(const Occluder& occluder, const ScreenRectangle& rectangle) const
  {
    const std::size_t faces = occluder.Mesh->Faces().size();
    return !IsDense(rectangle, faces) && this->Culler.Budget.Allows(faces / FacesPerPiece);
  }

  void InsertPart(std::uint32_t item, const Occluder& occluder)
  {
    ++this->Culler.Counted.Inserted;
    this->Culler.Owners.AddInserted(item, this->Culler.Projected.Rectangle());
    this->Culler.Budget.Spend(occluder.Mesh->Faces().size() / FacesPerPiece);
    this->InsertSides(item, occluder);
    MeshProjection& projected = this->Culler.Projected;
    if (!projected.IsBehindNear() && projected.ClipFarther(this->View.Of(*occluder.ToWorld)))
    {
      this->InsertSides(item, occluder);
    }
  }

  void InsertSides(std::uint32_t item, const Occluder& occluder)
  {
    const bool areOfFewCells = this->IsOfFewCells();
    if (!areOfFewCells)
    {
      this->Culler.Projected.FindFacings();
    }
    this->InsertFaces(item, MeshProjection::Facing::Front, areOfFewCells);
    if (this->HasBackFaces(occluder))
    {
      this->InsertFaces(item, MeshProjection::Facing::Back, areOfFewCells);
    }
  }

  /** Whether the part that is projected covers few cells. */
  bool IsOfFewCells() const
  {
    const ScreenRectangle& around = this->Culler.Projected.Rectangle();
    return this->Culler.Projected.IsBehindNear() && around.Right - around.Left <= FewColumns &&
      around.Top - around.Bottom <= FewLines;
  }

  void InsertFaces(std::uint32_t item, MeshProjection::Facing facing, bool areOfFewCells)
  {
    SBuffer& lines = this->Culler.Lines;
    MeshProjection& projected = this->Culler.Projected;
    if (areOfFewCells)
    {
      this->Culler.Budget.Spend(this->Culler.CoverOfFew.Insert(lines, projected, facing, item));
      return;
    }
    this->Faces.Drop(projected, facing);
    this->Culler.Budget.Spend(this->Culler.CoverOfMany.Insert(lines, projected, facing, item));
  }

  BandCuller& Culler;
  const LooseOctree& Tree;
  OccluderSource& Occluders;
  const ScreenProjection& View;
  bool HasOcclusion;
  ScreenRectangle Witness{}; ///< where something of the part at hand shows
  const std::vector<std::uint8_t>& IsDrawn;
  HiddenFaces Faces;
};

BandCuller::BandCuller(int columns, int lines, const SampleGrid& samples)
  : Lines(columns, lines, samples)
{
}

bool BandCuller::HidesThinFacesOf(const Occluder& occluder, const ScreenProjection& view)
{
  if (!occluder.Mesh || !occluder.IsOfFacesAlone)
  {
    return false;
  }
  this->Projected.Project(*occluder.Mesh, view.Of(*occluder.ToWorld));
  const std::size_t faces = occluder.Mesh->Faces().size();
  if (faces > MostFacesToLookAt && IsDense(this->Projected.Rectangle(), faces))
  {
    return true;
  }
  this->Projected.FindFacings();
  return HiddenFaces(this->Lines, view).AreThinOnes(this->Projected) &&
    !this->Projected.MayShowBeforeNear();
}

void BandCuller::Cull(const LooseOctree& tree, OccluderSource& occluders,
  const ScreenProjection& view, bool occlusion, const std::vector<std::uint8_t>& drawn,
  std::size_t bands)
{
  this->Lines.Clear();
  this->Counted = {};
  this->Shows.assign(drawn.size(), 0);
  this->WasSmall.resize(drawn.size(), 0);
  if (occlusion)
  {
    const auto parts = std::accumulate(drawn.begin(), drawn.end(), std::uint32_t{ 0 });
    this->Budget.Begin(parts, bands);
  }
  if (!tree.IsEmpty())
  {
    Walk(*this, tree, occluders, view, occlusion, drawn).Run();
    this->Owners.End(this->Lines);
  }
}

}
