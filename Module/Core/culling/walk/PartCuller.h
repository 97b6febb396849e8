#ifndef VITRINE_CORE_CULLING_WALK_PART_CULLER_H
#define VITRINE_CORE_CULLING_WALK_PART_CULLER_H

#include "Core/culling/walk/BandCuller.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Finds which parts may show: in each band of the screen's lines by itself, several at a time.
 *
 * What hides a part in a band has nothing to do with other bands, so a part is hidden where none shows it. What is found depends on the number of bands, in what is left of a budget
 * alone, and not on that of threads.
 */
class PartCuller
{
public:
  /** With an s-buffer of so many columns and lines, cut between pixels into so many bands, or fewer if those would have no lines. */
  PartCuller(int columns, int lines, const SampleGrid& samples = {}, int bands = 1);

  /**
   * Finds which parts may show.
   * @param tree       of the parts' bounds, in world coordinates (WC); parts that are not in it stay as they are
   * @param occluders  tells what the parts hide with; with several bands it is asked by several threads at once
   * @param occlusion  false for what lies outside of the view alone
   * @param visible    one for each part; on input 1 for those that this frame draws. 0 is put for what surely does not show
   */
  void Cull(const LooseOctree& tree, OccluderSource& occluders, const ScreenProjection& view,
    bool occlusion, std::vector<std::uint8_t>& visible);

  /**
   * Whether parts that the last frame found hidden are so wherever a device draws their faces, by what it left in the s-buffer.
   * @returns  one for each part, 1 where they are
   */
  std::vector<std::uint8_t> VerifyHidden(
    const std::vector<BoxedPart>& parts, ShapeSource& shapes, const ScreenProjection& view);

  /** Of all bands: what lies in several of them counts in each. */
  CullCounts Counts() const;
  SBufferCounts BufferCounts() const;

  /** Where something can show. */
  const SampleGrid& Samples() const { return this->Buffer().Samples(); }

  /** Of all bands. */
  int LineCount() const;

  std::size_t BandCount() const { return this->Bands.size(); }

  /** The s-buffer of a band; they lie on each other from the bottom up. */
  const SBuffer& Buffer(std::size_t band = 0) const { return this->Bands[band].Culler.Buffer(); }

private:
  struct Band
  {
    int FirstLine;
    BandCuller Culler;
  };

  void KeepShown(const LooseOctree& tree, std::vector<std::uint8_t>& visible);

  std::vector<Band> Bands;
  std::vector<std::uint8_t> Unplaced; ///< whether parts that have no place are visible
};

}

#endif
