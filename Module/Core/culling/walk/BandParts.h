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

/** The data structures of one band. They are kept from frame to frame, so that no memory is allocated. */
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

/** Tests the parts of one band in one frame against its s-buffer, and inserts parts that show. */
class BandParts
{
public:
  /**
   * @param tools      the data structures of the band
   * @param occluders  returns the meshes that the parts hide others with
   * @param view       the view, of the lines of this band
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
   * Visits a part: returns true if it may show, and inserts it if the budget allows. The box of a small mesh is not
   * tested, because its points are projected as quickly.
   * @param rectangle  the rectangle of the box
   */
  bool Visit(std::uint32_t part, const ScreenRectangle& rectangle);

  enum class OwnerVerdict
  {
    Waits, ///< The part has its turn later: it has moved, can only be tested by its box, or is not worth inserting.
    Hidden,
    Shows
  };

  /**
   * Visits an owner of the last frame before its turn.
   * @param rectangle  is set to the place of the part, unless the part waits
   */
  OwnerVerdict VisitOwner(const LastOwners::Owner& owner, ScreenRectangle& rectangle);

  /** Returns true if a part that was found to show is hidden by what was inserted since then. */
  bool IsHiddenNow(std::uint32_t part, const ScreenRectangle& rectangle);

  /**
   * Finds the greatest reversed depth of the faces of a part on the screen. Returns false if the part has no faces, or
   * if the budget does not allow to project them.
   */
  bool FindNearest(std::uint32_t part, const ScreenRectangle& rectangle, float& depth);

  /** A place where the last visited part may show. As long as this is not hidden, the part is not. */
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
