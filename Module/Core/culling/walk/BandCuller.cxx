#include "Core/culling/walk/BandCuller.h"

#include <algorithm>
#include <cassert>

namespace vitrine
{

namespace
{

// A node of at most so many parts is visited at once, with all of its parts. That takes less time than to queue their
// entries.
const std::uint32_t FewParts = 32;

// Depths in the queue of long entries, which come first, and of entries that reach before the near plane. They are
// greater than all depths.
const float LongDepth = 3.0f;
const float NearDepth = 2.0f;
}

/** Walks over the nodes and parts of one frame. */
class BandCuller::Walk
{
public:
  Walk(BandCuller& culler, const LooseOctree& tree, OccluderSource& occluders,
    const ScreenProjection& view, bool occlusion)
    : Culler(culler)
    , Tree(tree)
    , Occluders(occluders)
    , View(view)
    , HasOcclusion(occlusion)
    , States(culler.Tools.States)
    , Parts(culler.Tools, occluders, view)
  {
  }

  /** Visits all entries that may show, the nearest first. */
  void Run()
  {
    std::vector<Entry>& queue = this->Culler.Queue;
    queue.clear();
    this->VisitOwners();
    this->QueueEntriesOf(this->Tree.Node(0));
    while (!queue.empty())
    {
      std::pop_heap(queue.begin(), queue.end());
      const Entry nearest = queue.back();
      queue.pop_back();
      this->Visit(nearest);
    }
    this->Culler.Tools.Owners.End(this->Culler.Tools.Lines, this->States);
    if (this->HasOcclusion)
    {
      this->RetestShown();
    }
    this->Culler.Tools.Owners.KeepIdlers(this->States);
  }

private:
  /** Visits the owners of the last frame, before the parts that they may hide. */
  void VisitOwners()
  {
    this->Culler.Tools.Owners.Begin(this->States.Count());
    for (const LastOwners::Owner& owner : this->Culler.Tools.Owners.Owners())
    {
      if (this->HasOcclusion && this->IsThere(owner.Part))
      {
        this->VisitOwner(owner);
      }
    }
  }

  /** Returns true if a part of the last frame is drawn in this one. */
  bool IsThere(std::uint32_t part) const
  {
    return part < this->States.Count() && this->States.Has(part, PartStates::IsDrawn) &&
      this->Tree.Holds(part);
  }

  void VisitOwner(const LastOwners::Owner& owner)
  {
    ScreenRectangle rectangle;
    if (this->Parts.VisitOwner(owner, rectangle) == BandParts::OwnerVerdict::Shows)
    {
      this->Show(owner.Part, rectangle);
    }
  }

  void Show(std::uint32_t part, const ScreenRectangle& rectangle)
  {
    this->States.Set(part, PartStates::IsShown);
    this->Culler.Visited.push_back({ part, rectangle, this->Parts.Witness() });
  }

  /** Tests the shown parts a second time: each was tested before all parts in front of it were inserted. */
  void RetestShown()
  {
    for (const ShownPart& shown : this->Culler.Visited)
    {
      if (!this->States.Has(shown.Part, PartStates::HasSamples) && this->IsHidden(shown.Witness) &&
        this->Parts.IsHiddenNow(shown.Part, shown.Rectangle))
      {
        this->States.Set(shown.Part, PartStates::IsShown, false);
        this->Culler.Tools.Budget.AddHidden(1);
      }
    }
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
      this->VisitPart(number, entry.Rectangle);
    }
    else if (this->IsHidden(entry.Rectangle))
    {
      this->Culler.Tools.Budget.AddHidden(entry.PartCount);
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

  /**
   * Queues a part whose box reaches before the near plane by its nearest face. Returns false if the part has no faces,
   * or if the budget does not allow to project them.
   */
  bool QueueByFaces(const Entry& entry)
  {
    const std::uint32_t part = entry.Number & LooseNode::NumberBits;
    float depth;
    if (!this->HasOcclusion || !this->Parts.FindNearest(part, entry.Rectangle, depth))
    {
      return false;
    }
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
    FoundEntries found;
    this->FindEntries(node, found);
    for (unsigned bits = found.Wanted; bits != 0; bits &= bits - 1)
    {
      this->Push(EntryAt(node, found, LowestBit(bits)));
    }
  }

  void VisitEntriesOf(const LooseNode& node)
  {
    FoundEntries found;
    this->FindEntries(node, found);
    int order[LaneCount];
    const int count = SortByDepth(found, order);
    for (int i = 0; i < count; ++i)
    {
      this->Visit(EntryAt(node, found, order[i]));
    }
  }

  /** The entries of a node on the screen. */
  struct FoundEntries
  {
    RectangleLanes Rectangles;
    float Depths[LaneCount]; ///< as Entry::Depth
    unsigned Wanted;         ///< a bit for each entry that is to be visited
  };

  static Entry EntryAt(const LooseNode& node, const FoundEntries& found, int lane)
  {
    const bool isNear = (found.Rectangles.Near >> lane & 1u) != 0;
    return { found.Depths[lane], isNear ? Everywhere : found.Rectangles.At(lane),
      node.Entries[lane], node.Counts[lane] };
  }

  /**
   * Writes the lanes of the wanted entries to `order`, the nearest first. Returns their number. It has no branches,
   * since they could not be predicted.
   */
  VITRINE_FOR_EACH_PROCESSOR
  static int SortByDepth(const FoundEntries& found, int* order)
  {
    const Lanes all = LoadLanes(found.Depths);
    for (unsigned bits = found.Wanted; bits != 0; bits &= bits - 1)
    {
      const int i = LowestBit(bits);
      // An entry without a place on the screen has NearDepth.
      assert(found.Depths[i] == found.Depths[i]);
      const Lanes own = AllLanes(found.Depths[i]);
      const unsigned before = BitsOf(all > own) | (BitsOf(all == own) & ((1u << i) - 1u));
      order[CountBits(before & found.Wanted)] = i;
    }
    return CountBits(found.Wanted);
  }

  /** Finds the entries that may lie in the view and are to be visited. */
  void FindEntries(const LooseNode& node, FoundEntries& found)
  {
    ++this->Culler.Counted.Nodes;
    this->View.Project(node.Boxes, found.Rectangles);
    const unsigned inView = FindDepths(node, found.Rectangles, found.Depths);
    found.Wanted = 0;
    for (unsigned bits = inView; bits != 0; bits &= bits - 1)
    {
      const int lane = LowestBit(bits);
      found.Wanted |= static_cast<unsigned>(this->IsWanted(node, lane)) << lane;
    }
  }

  /**
   * Finds the queue depths of the entries. Long ones come first, as they may hide much. Returns a bit for each entry
   * that may lie in the view.
   */
  VITRINE_FOR_EACH_PROCESSOR
  static unsigned FindDepths(
    const LooseNode& node, const RectangleLanes& rectangles, float (&depths)[LaneCount])
  {
    const Lanes nearest = LoadLanes(rectangles.Nearest);
    const Lanes depth = Chosen(node.AreLong(), AllLanes(LongDepth), nearest);
    StoreLanes(Chosen(LaneBits(rectangles.Near), AllLanes(NearDepth), depth), depths);
    return BitsOf(node.AreThere()) & ~rectangles.Outside;
  }

  bool IsWanted(const LooseNode& node, int lane)
  {
    if (!node.IsItem(lane))
    {
      this->Tree.PrefetchNode(node.NodeAt(lane));
      return true;
    }
    const std::uint32_t item = node.ItemAt(lane);
    const std::uint8_t state = this->States[item];
    this->Culler.Counted.Tested += state & PartStates::IsDrawn;
    this->Occluders.PrefetchOccluder(item);
    return (state & (PartStates::IsDrawn | PartStates::IsVisited)) == PartStates::IsDrawn;
  }

  bool IsHidden(const ScreenRectangle& rectangle) const
  {
    return this->HasOcclusion && this->Parts.IsHidden(rectangle);
  }

  void VisitPart(std::uint32_t part, const ScreenRectangle& rectangle)
  {
    if (!this->HasOcclusion || this->Parts.Visit(part, rectangle))
    {
      this->Show(part, rectangle);
    }
  }

  BandCuller& Culler;
  const LooseOctree& Tree;
  OccluderSource& Occluders;
  const ScreenProjection& View;
  bool HasOcclusion;
  PartStates& States;
  BandParts Parts;
};

BandCuller::BandCuller(int columns, int lines, const SampleGrid& samples)
  : Tools{ SBuffer::WithFewSamples(columns, lines, samples) }
{
}

void BandCuller::AddShown(std::vector<std::uint8_t>& visible) const
{
  for (const ShownPart& shown : this->Visited)
  {
    visible[shown.Part] |= this->Tools.States.Has(shown.Part, PartStates::IsShown);
  }
}

void BandCuller::VerifyHidden(const std::vector<BoxedPart>& parts, ShapeSource& shapes,
  const ScreenProjection& view, std::vector<std::uint8_t>& areHidden)
{
  HiddenVerifier verifier(this->Tools, shapes, view);
  for (std::size_t first = 0; first < parts.size(); first += LaneCount)
  {
    verifier.Verify(parts, first, areHidden);
  }
}

void BandCuller::Cull(const LooseOctree& tree, OccluderSource& occluders,
  const ScreenProjection& view, bool occlusion, const std::vector<std::uint8_t>& drawn,
  std::size_t bands)
{
  this->Tools.Lines.Clear();
  this->Visited.clear();
  this->Counted = {};
  const std::uint32_t parts = this->Tools.States.Begin(drawn);
  if (occlusion)
  {
    this->Tools.Budget.Begin(parts, bands);
  }
  if (!tree.IsEmpty())
  {
    Walk(*this, tree, occluders, view, occlusion).Run();
    this->Counted.Inserted = this->Tools.Owners.InsertedCount();
  }
}

}
