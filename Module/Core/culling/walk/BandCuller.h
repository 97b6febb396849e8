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

/** Counts of one frame. */
struct CullCounts
{
  std::uint32_t Nodes = 0;    ///< of the octree that were tested
  std::uint32_t Tested = 0;   ///< parts
  std::uint32_t Inserted = 0; ///< parts whose cover went into the s-buffer
};

/**
 * The hierarchical s-buffer on a band of a screen's lines, or on all of them: walks an octree of parts from front to back, leaves out what is outside the view or hidden by what
 * stands in the s-buffer, and puts what shows into it.
 * (A. V. Boreskov, hierarchical s-buffer; N. Greene, M. Kass, G. Miller: Hierarchical Z-buffer visibility, SIGGRAPH 1993)
 */
class BandCuller
{
public:
  /** With an s-buffer of so many columns and lines. */
  BandCuller(int columns, int lines, const SampleGrid& samples);

  /**
   * Finds which parts may show in the band.
   * @param tree       of the parts' bounds, in world coordinates (WC)
   * @param occluders  tells what the parts hide with
   * @param view       of the band
   * @param occlusion  false for what lies outside of the view alone
   * @param drawn      one for each part: 1 for those that this frame draws
   * @param bands      of the screen
   */
  void Cull(const LooseOctree& tree, OccluderSource& occluders, const ScreenProjection& view,
    bool occlusion, const std::vector<std::uint8_t>& drawn, std::size_t bands);

  /**
   * Which parts that were found hidden are so by what stands in the s-buffer now, wherever a device draws them.
   * @param shapes     tells what the parts are
   * @param view       of the band
   * @param areHidden  takes 0 for those that are not
   */
  void VerifyHidden(const std::vector<BoxedPart>& parts, ShapeSource& shapes,
    const ScreenProjection& view, std::vector<std::uint8_t>& areHidden);

  /** Puts 1 for each part in the tree that may show in the band. */
  void AddShown(std::vector<std::uint8_t>& visible) const;

  const CullCounts& Counts() const { return this->Counted; }
  const SBuffer& Buffer() const { return this->Tools.Lines; }

private:
  class Walk;

  /** What a node holds, and where on the screen that is. */
  struct Entry
  {
    float Depth; ///< reversed: the greatest is visited first
    ScreenRectangle Rectangle;
    std::uint32_t Number; ///< as nodes tell it
    std::uint32_t PartCount;

    bool operator<(const Entry& other) const { return this->Depth < other.Depth; }
  };

  /** What was found to show. */
  struct ShownPart
  {
    std::uint32_t Part;
    ScreenRectangle Rectangle;
    ScreenRectangle Witness; ///< while that is not hidden, the part is not
  };

  BandTools Tools;
  CullCounts Counted;
  std::vector<Entry> Queue;       ///< a heap
  std::vector<ShownPart> Visited; ///< in the order in which they were visited
};

}

#endif
