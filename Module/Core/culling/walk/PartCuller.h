#ifndef VITRINE_CORE_CULLING_WALK_PART_CULLER_H
#define VITRINE_CORE_CULLING_WALK_PART_CULLER_H

#include "Core/culling/walk/BandCuller.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Finds which parts may show. The lines of the screen are cut into bands, each of which is culled on its own, several
 * at a time.
 *
 * Other bands do not influence what hides a part in a band, so a part is hidden if no band shows it. The result depends
 * on the number of bands, by the budget left in each, and not on the number of threads.
 */
class PartCuller
{
public:
  /**
   * Makes an s-buffer with this number of columns and lines. It is cut between pixels into `bands` bands, or into fewer
   * if some would have no line.
   */
  PartCuller(int columns, int lines, const SampleGrid& samples = {}, int bands = 1);

  /**
   * Finds which parts may show.
   * @param tree       the boxes of the parts, in world coordinates (WC); bytes of parts that are not in it are kept
   * @param occluders  returns the meshes that the parts hide others with; several threads ask it at a time
   * @param occlusion  false to leave out only parts outside of the view
   * @param visible    one byte per part; on input 1 for the parts that this frame draws. It becomes 0 for the parts
   *                   that surely do not show.
   */
  void Cull(const LooseOctree& tree, OccluderSource& occluders, const ScreenProjection& view,
    bool occlusion, std::vector<std::uint8_t>& visible);

  /**
   * Tests again whether parts are hidden, now wherever a device may draw them. Cull() has to come first: its s-buffer
   * is used.
   * @param parts  parts that Cull() found hidden
   * @returns      one byte per entry of `parts`, 1 if it is hidden
   */
  std::vector<std::uint8_t> VerifyHidden(
    const std::vector<BoxedPart>& parts, ShapeSource& shapes, const ScreenProjection& view);

  /** Sums over all bands. A part or node that lies in several bands counts in each. */
  CullCounts Counts() const;
  SBufferCounts BufferCounts() const;

  /** The sample positions. */
  const SampleGrid& Samples() const { return this->Buffer().Samples(); }

  /** The number of lines of all bands together. */
  int LineCount() const;

  std::size_t BandCount() const { return this->Bands.size(); }

  /** The s-buffer of a band. Band 0 is the lowest. */
  const SBuffer& Buffer(std::size_t band = 0) const { return this->Bands[band].Culler.Buffer(); }

private:
  struct Band
  {
    int FirstLine;
    BandCuller Culler;
  };

  void KeepShown(const LooseOctree& tree, std::vector<std::uint8_t>& visible);

  std::vector<Band> Bands;
  std::vector<std::uint8_t> Unplaced; ///< the bytes of the parts that are not in the tree
};

}

#endif
