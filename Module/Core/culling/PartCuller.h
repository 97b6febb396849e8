#ifndef VITRINE_CORE_CULLING_PART_CULLER_H
#define VITRINE_CORE_CULLING_PART_CULLER_H

#include "Core/culling/FaceCoverage.h"
#include "Core/culling/InsertionBudget.h"
#include "Core/culling/LooseOctree.h"
#include "Core/culling/MeshBoxes.h"
#include "Core/culling/MeshProjection.h"
#include "Core/culling/OutlineCoverage.h"
#include "Core/culling/SBuffer.h"
#include "Core/culling/ScreenProjection.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <vector>

namespace vitrine
{

/** What a part hides with. */
struct Occluder
{
  const OccluderMesh* Mesh = nullptr;  ///< null if it hides nothing
  const glm::dmat4* ToWorld = nullptr; ///< from the mesh's model coordinates
  bool HasBackFaces = true; ///< whether faces that go around clockwise on the screen are drawn, too
  const MeshBoxes* Boxes =
    nullptr; ///< around the mesh's faces; null if there are none, or if more is drawn of the part than faces
  bool IsOfFacesAlone = false; ///< whether nothing else is drawn of the part than the mesh's faces
};

/** Tells what parts hide with; asked only for those that show. */
class OccluderSource
{
public:
  virtual ~OccluderSource() = default;
  virtual Occluder OccluderOf(std::uint32_t part) = 0;

  /** The part may be asked for soon: a hint for those that keep what they tell far apart in memory. */
  virtual void Expect(std::uint32_t part) const { static_cast<void>(part); }
};

/** Counts of one frame. */
struct CullCounts
{
  std::uint32_t Nodes = 0;    ///< of the octree that were tested
  std::uint32_t Tested = 0;   ///< parts
  std::uint32_t Inserted = 0; ///< parts whose cover went into the s-buffer
};

/**
 * The hierarchical s-buffer: walks an octree of parts from front to back, leaves out what is outside the view or hidden by what
 * stands in the s-buffer, and puts what shows into it.
 * (A. V. Boreskov, hierarchical s-buffer; N. Greene, M. Kass, G. Miller: Hierarchical Z-buffer visibility, SIGGRAPH 1993)
 */
class PartCuller
{
public:
  /** With an s-buffer of so many columns and lines. */
  PartCuller(int columns, int lines, const SampleGrid& samples = {});

  /**
   * Finds which parts may show.
   * @param tree       of the parts' bounds, in world coordinates (WC); parts that are not in it stay as they are
   * @param occluders  tells what the parts hide with
   * @param occlusion  false for what lies outside of the view alone
   * @param visible    one for each part; on input 1 for those that this frame draws. 0 is put for what surely does not show
   */
  void Cull(const LooseOctree& tree, OccluderSource& occluders, const ScreenProjection& view,
    bool occlusion, std::vector<std::uint8_t>& visible);

  const CullCounts& Counts() const { return this->Counted; }
  const SBuffer& Buffer() const { return this->Lines; }

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

  SBuffer Lines;
  MeshProjection Projected;
  OutlineCoverage CoverOfFew;
  FaceCoverage CoverOfMany;
  CullCounts Counted;
  InsertionBudget Budget;
  std::vector<Entry> Queue; ///< a heap
  std::vector<std::uint8_t> Shows;
  std::vector<ShownPart> Shown; ///< in the order in which they were visited
  std::vector<std::uint8_t>
    WasSmall; ///< parts whose mesh had few points when it was last asked for
};

}

#endif
