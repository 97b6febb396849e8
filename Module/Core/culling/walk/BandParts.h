#ifndef VITRINE_CORE_CULLING_WALK_BAND_PARTS_H
#define VITRINE_CORE_CULLING_WALK_BAND_PARTS_H

#include "Core/culling/buffer/SBuffer.h"
#include "Core/culling/cover/FaceCoverage.h"
#include "Core/culling/hidden/HiddenFaces.h"
#include "Core/culling/screen/MeshProjection.h"
#include "Core/culling/screen/ScreenProjection.h"
#include "Core/culling/steady/CutFaces.h"
#include "Core/culling/walk/InsertionBudget.h"
#include "Core/culling/walk/LastOwners.h"
#include "Core/culling/walk/OccluderSource.h"
#include "Core/culling/walk/PartStates.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** What the parts of a band are tested with; it is kept from frame to frame. */
struct BandTools
{
  SBuffer Lines;
  MeshProjection Projected{};
  FaceCoverage Cover{};
  CutFaces Cuts{};
  InsertionBudget Budget{};
  LastOwners Owners{};
  PartStates States{};
};

/** Tests the parts of a band in one frame against what stands in its s-buffer, and puts those that show into it. */
class BandParts
{
public:
  /**
   * @param tools      of the band
   * @param occluders  tells what the parts hide with
   * @param view       of the band
   */
  BandParts(BandTools& tools, OccluderSource& occluders, const ScreenProjection& view)
    : Tools(tools)
    , Occluders(occluders)
    , View(view)
    , Faces(tools.Lines, view)
  {
  }

  bool IsHidden(const ScreenRectangle& rectangle) const
  {
    return this->Tools.Lines.Hides(rectangle);
  }

  /**
   * Whether a part may show. Its box is not tested if its points are, which are as quickly projected.
   * @param rectangle  around it
   */
  bool Visit(std::uint32_t part, const ScreenRectangle& rectangle);

  enum class OwnerVerdict
  {
    Waits, ///< for its turn: it has moved, or can only be tested by its box
    Hidden,
    Shows
  };

  /**
   * Visits an owner of the last frame before its turn.
   * @param rectangle  takes where it is, unless it waits
   */
  OwnerVerdict VisitOwner(const LastOwners::Owner& owner, ScreenRectangle& rectangle);

  /** Of a part that was shown, whether what has been inserted since then hides it. */
  bool IsHiddenNow(std::uint32_t part, const ScreenRectangle& rectangle);

  /** How near the faces of a part are on the screen; returns false if it has none, or they are not worth their time. */
  bool FindNearest(std::uint32_t part, const ScreenRectangle& rectangle, float& depth);

  /** Where something of the last part that was visited shows: while that is not hidden, the part is not. */
  const ScreenRectangle& Witness() const { return this->Seen; }

private:
  bool ShowSmall(std::uint32_t part, const Occluder& occluder, const ScreenRectangle& rectangle);
  bool ShowLarge(std::uint32_t part, const Occluder& occluder, const ScreenRectangle& rectangle,
    bool isUntested);
  bool ShowFaces(std::uint32_t part, const Occluder& occluder, const ScreenRectangle& rectangle,
    bool isInserted);
  bool InsertsSamples(std::uint32_t part, const Occluder& occluder);
  bool WasIdle(std::uint32_t part);
  bool AreFacesHidden(std::uint32_t part, const Occluder& occluder);
  bool AreBoxesHidden(const Occluder& occluder) const;
  bool HasBackFaces(const Occluder& occluder) const;
  bool Project(const Occluder& occluder);
  bool IsLarge(const ScreenRectangle& rectangle) const;
  bool IsWorthTesting(const Occluder& occluder, const ScreenRectangle& rectangle) const;
  bool IsWorthInserting(const Occluder& occluder, const ScreenRectangle& rectangle) const;
  void Insert(std::uint32_t part, const Occluder& occluder);
  void InsertSides(std::uint32_t number, const Occluder& occluder);
  bool HasFewFacets(const Occluder& occluder) const;
  bool InsertFewFacets(std::uint32_t number, const Occluder& occluder);
  void InsertFaces(std::uint32_t number, MeshProjection::Facing facing);

  BandTools& Tools;
  OccluderSource& Occluders;
  const ScreenProjection& View;
  HiddenFaces Faces;
  ScreenRectangle Seen{};
};

}

#endif
