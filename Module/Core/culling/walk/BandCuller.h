#ifndef VITRINE_CORE_CULLING_WALK_BAND_CULLER_H
#define VITRINE_CORE_CULLING_WALK_BAND_CULLER_H

#include "Core/culling/buffer/SBuffer.h"
#include "Core/culling/screen/ScreenProjection.h"
#include "Core/culling/walk/BandParts.h"
#include "Core/culling/walk/HiddenVerifier.h"
#include "Core/culling/walk/LooseOctree.h"
#include "Core/culling/walk/OccluderSource.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/** Counts of one band in one frame. */
struct CullCounts
{
  std::uint32_t Nodes = 0;    ///< nodes of the octree whose entries were tested
  std::uint32_t Tested = 0;   ///< parts of this frame that were tested
  std::uint32_t Inserted = 0; ///< parts that were inserted into the s-buffer
};

/**
 * Occlusion culling in one band of the screen: all lines of an s-buffer, or a run of them. It walks an octree of parts
 * from front to back. It leaves out parts that lie outside of the view or are hidden by the s-buffer, and inserts the
 * others as occluders.
 * (A. V. Boreskov, hierarchical s-buffer; N. Greene, M. Kass, G. Miller: Hierarchical Z-buffer visibility, SIGGRAPH
 * 1993)
 */
class BandCuller
{
public:
  /** Makes an s-buffer with this number of columns and lines. */
  BandCuller(int columns, int lines, const SampleGrid& samples);

  /**
   * Finds which parts may show in the band. AddShown() returns them.
   * @param tree       the boxes of the parts, in world coordinates (WC)
   * @param occluders  returns the meshes that the parts hide others with
   * @param view       the view, of the lines of this band
   * @param occlusion  false to leave out only parts outside of the view
   * @param drawn      one byte per part: 1 if this frame draws it
   * @param bands      number of bands of the screen, which share a part of the budget
   */
  void Cull(const LooseOctree& tree, OccluderSource& occluders, const ScreenProjection& view,
    bool occlusion, const std::vector<std::uint8_t>& drawn, std::size_t bands);

  /**
   * Tests again whether parts are hidden, now wherever a device may draw them. Cull() has to come first: it fills the
   * s-buffer.
   * @param parts      parts that Cull() found hidden
   * @param shapes     returns the geometry of the parts
   * @param view       the view, of the lines of this band
   * @param areHidden  one byte per entry of `parts`; becomes 0 for parts that may show in this band
   */
  void VerifyHidden(const std::vector<BoxedPart>& parts, ShapeSource& shapes,
    const ScreenProjection& view, std::vector<std::uint8_t>& areHidden);

  /** Sets the bytes of the parts that may show in the band to 1. Other bytes are not changed. */
  void AddShown(std::vector<std::uint8_t>& visible) const;

  const CullCounts& Counts() const { return this->Counted; }
  const SBuffer& Buffer() const { return this->Tools.Lines; }

private:
  class Walk;

  /** An entry of a node, and its place on the screen. */
  struct Entry
  {
    float Depth; ///< reversed; the entry with the greatest depth is visited first
    ScreenRectangle Rectangle;
    std::uint32_t Number; ///< as LooseNode::Entries has it, with its flag bits
    std::uint32_t PartCount;

    bool operator<(const Entry& other) const { return this->Depth < other.Depth; }
  };

  /** A part that may show. */
  struct ShownPart
  {
    std::uint32_t Part;
    ScreenRectangle Rectangle;
    /** A place where the part may show. As long as this is not hidden, the part is not. */
    ScreenRectangle Witness;
  };

  BandTools Tools;
  CullCounts Counted;
  std::vector<Entry> Queue;       ///< a heap, the nearest entry first
  std::vector<ShownPart> Visited; ///< parts that were found to show, in the order of their visits
};

}

#endif
