#ifndef VITRINE_CORE_CULLING_SCREEN_SCREEN_PROJECTION_H
#define VITRINE_CORE_CULLING_SCREEN_SCREEN_PROJECTION_H

#include "Core/culling/screen/DeviceCoordinates.h"
#include "Core/culling/screen/DeviceModel.h"
#include "Core/culling/screen/PlaneView.h"
#include "Core/culling/screen/ScreenRounding.h"
#include "Core/geometry/BoxLanes.h"
#include "Core/geometry/SampleGrid.h"
#include "Core/geometry/ScreenRectangle.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <optional>

namespace vitrine
{

/** A map to column, line and reversed depth, each times w, and w; and how far off a device may be that makes it in floats. */
struct ScreenMatrix
{
  glm::dmat4 Matrix;
  glm::vec4 Rounding;      ///< of each of the four
  ScreenMargin Snapping;   ///< what a rasteriser moves by besides
  glm::vec2 Size;          ///< columns and lines
  float LinesBelow = 0.0f; ///< that the view has besides
  float LinesAbove = 0.0f;
  glm::vec2 Before{ 0.0f }; ///< columns and lines that the window has before the view

  /** The view's lowest and highest line. */
  float Bottom() const { return -this->LinesBelow; }
  float Top() const { return this->Size.y + this->LinesAbove; }

  /** What a device rounds of columns and lines in the window. */
  glm::vec2 OfPlaces() const
  {
    return RoundingOfFloat *
      glm::vec2(this->Before.x + this->Size.x, this->Before.y + this->Top() - this->Bottom());
  }

  /** Columns, lines and depths of the view's half. */
  glm::dvec4 HalfOfView() const
  {
    return { 0.5 * this->Size.x, 0.5 * (this->Top() - this->Bottom()), 0.5, 0.0 };
  }

  /** What a device's floats round of points: lines reach as far for it as in the whole view. */
  ScreenRounding RoundingOnScreen() const
  {
    const glm::vec4& own = this->Rounding;
    const glm::vec2 ofPlaces = this->OfPlaces();
    return { { own.x, own.w, this->Size.x, ofPlaces.x },
      { own.y, own.w, this->Top() - this->Bottom(), ofPlaces.y, this->Bottom() },
      { own.z, own.w, 1.0f } };
  }

  /**
   * The same of points in the view that are found in doubles.
   */
  DeviceScreenRounding RoundingInView() const
  {
    const glm::dvec4 half = this->HalfOfView();
    const glm::dvec4 own(this->Rounding);
    const auto of = [&](int i, double middle, float ofPlaces)
    {
      return DeviceCoordinateRounding{ ShareOfDevice * std::max(own[i] - half[i] * own.w, 0.0),
        ShareOfDevice * own.w, middle, ofPlaces };
    };
    return { of(0, half.x, this->OfPlaces().x), of(1, half.y + this->Bottom(), this->OfPlaces().y),
      of(2, half.z, RoundingOfFloat) };
  }

  /** Whether any of a rectangle lies between the sides of the view. */
  bool IsInView(const ScreenRectangle& rectangle) const
  {
    return rectangle.Right >= 0.0f && rectangle.Left <= this->Size.x &&
      rectangle.Top >= this->Bottom() && rectangle.Bottom <= this->Top();
  }

  /**
   * Whether what has this rectangle, and is nowhere farther, may reach beyond the view, of which the screen may be some lines alone, or its near or far plane.
   */
  bool MayBeCut(const ScreenRectangle& rectangle, float farthest) const
  {
    return !(rectangle.Left >= 0.0f && rectangle.Right <= this->Size.x &&
      rectangle.Bottom >= this->Bottom() && rectangle.Top <= this->Top() &&
      rectangle.Nearest < 1.0f && farthest > RoundingOfCuts);
  }

  /** Of points on the screen for which w is at least `leastW`. */
  ScreenMargin MarginFrom(float leastW) const
  {
    return this->RoundingOnScreen().MarginAt(1.0f / leastW, this->Snapping);
  }
};

/** Where eight boxes are on the screen. */
struct RectangleLanes
{
  float Left[LaneCount];
  float Right[LaneCount];
  float Bottom[LaneCount];
  float Top[LaneCount];
  float Nearest[LaneCount];
  float Farthest[LaneCount]; ///< depth of its corners
  unsigned Outside;          ///< a bit for each box that lies outside of what the view shows
  unsigned
    Near; ///< for each that reaches before the near plane, so that it has no rectangle and nothing hides it

  /**
   * Of a box that is neither Near nor Outside: the least rectangle that surely holds all that is drawn of it, and the greatest depth that
   * it surely does not exceed.
   */
  ScreenRectangle At(int lane) const
  {
    return { this->Left[lane], this->Right[lane], this->Bottom[lane], this->Top[lane],
      this->Nearest[lane] };
  }

  /** A bit for each box, whether there may be samples where it is drawn; of those that are Near or Outside it says anything. */
  unsigned MayHaveAny(const SampleGrid& samples) const
  {
    return samples.MayHaveAny(LoadLanes(this->Left), LoadLanes(this->Right)) &
      samples.MayHaveAny(LoadLanes(this->Bottom), LoadLanes(this->Top));
  }
};

/** Where the box of what reaches before the near plane may be on the screen. */
inline constexpr ScreenRectangle Everywhere = { -1e30f, 1e30f, -1e30f, 1e30f, 1.0f };

/**
 * How a view maps world coordinates (WC) onto the columns and lines of an s-buffer, and to reversed depth: (w - z) / 2w of clip
 * coordinates, 1 at the near plane and 0 at the far one. That is affine on the screen along a plane, in perspective and in
 * parallel projection alike, and floats have as many bits near the far plane as near the near one. (E. Lapidous,
 * G. Jiao: Optimal depth buffer for low-cost graphics hardware, Graphics Hardware 1999)
 */
class ScreenProjection
{
public:
  /**
   * @param toClip    from world coordinates to OpenGL's clip coordinates, for column vectors
   * @param columns   of what is seen from left to right; the last may be a part of one
   * @param lines     from bottom to top
   * @param reach     the largest sums of absolute values that lead to coordinates of what is drawn: the larger they are, the coarser a device's floats
   * @param snapping  what a rasteriser moves edges and depths by, besides the rounding of its floats
   * @param growth    by how many columns and lines boxes reach farther on the screen, for lines and points that are drawn wider
   *                  than they are
   * @param before    columns and lines that the window has before the view
   */
  ScreenProjection(const glm::dmat4& toClip, double columns, double lines, const glm::dvec3& reach,
    const ScreenMargin& snapping, const glm::vec2& growth = glm::vec2(0.0f),
    const glm::vec2& before = glm::vec2(0.0f));

  /** Where eight boxes are, which are finite and no farther than `reach`; of empty ones it says anything. */
  void Project(const BoxLanes& boxes, RectangleLanes& rectangles) const
  {
    this->Project(this->WorldInFloats, boxes, this->MayOverflow, rectangles);
  }

  /**
   * Where eight boxes of a part are.
   * @param toScreen  what Of() tells of the part, moved to where the boxes count from; the sums that lead to the world from their corners
   *                  are no larger than `reach`
   */
  void Project(const glm::mat4& toScreen, const BoxLanes& boxes, RectangleLanes& rectangles) const;

  /** Of a single box, however far: Everywhere if it reaches before the near plane or has no place, and nothing if it lies outside. */
  std::optional<ScreenRectangle> RectangleOf(const Box& box) const;

  /** Whether a rectangle reaches beyond the screen. */
  bool ReachesBeyond(const ScreenRectangle& rectangle) const;

  /** Whether a device may cut what has this rectangle, and is nowhere farther. */
  bool MayBeCut(const ScreenRectangle& rectangle, float farthest) const
  {
    return this->World.MayBeCut(rectangle, farthest);
  }

  /** The same view of some of its lines alone: they count from `first`. */
  ScreenProjection OfLines(int first, int count) const;

  /** The same view, of which boxes reach farther on the screen by so many more columns and lines. */
  ScreenProjection GrownBy(const glm::vec2& growth) const
  {
    ScreenProjection grown = *this;
    grown.Growth += growth;
    return grown;
  }

  PlaneView OfPlanes() const;

  /** How many columns or lines, whichever are fewer, a length of 1 has that is seen from a distance of 1, or in parallel projection. */
  double SmallestScale() const;

  /** By how many of them a device's floats may be off at that distance. */
  double RoundingAtOne() const;

  /** What a rasteriser moves edges and depths by. */
  const ScreenMargin& Snapping() const { return this->World.Snapping; }

  /** Whether anything reaches farther on the screen than it is. */
  bool Grows() const { return this->Growth != glm::vec2(0.0f); }

  /** A rectangle, farther by the growth. */
  ScreenRectangle Grown(const ScreenRectangle& rectangle) const;

  /** By how many columns and lines. */
  const glm::vec2& GrowthOnScreen() const { return this->Growth; }

  /** Column, line and depth, each times w, and w. */
  glm::dvec4 ToScreen(const glm::dvec3& point) const;

  /**
   * Of a part's model coordinates.
   * @param toWorld  from model coordinates; the sums that lead to the world from there are no larger than `reach`
   */
  ScreenMatrix Of(const glm::dmat4& toWorld) const;

  /** The same where more is known of what a device rounds: it multiplies by the product of the matrices that lead from a part's coordinates to the screen. */
  ScreenMatrix Of(const glm::dmat4& toWorld, const DeviceCoordinates& device) const;

private:
  void Project(const glm::mat4& toScreen, const BoxLanes& boxes, bool mayOverflow,
    RectangleLanes& rectangles) const;

  ScreenMatrix World;
  glm::dmat4
    Sizes; ///< of what leads from the world to columns, lines, depths and w, as a device has it
  glm::mat4 WorldInFloats; ///< its matrix
  glm::vec2 Growth;
  bool
    MayOverflow; ///< whether coordinates of boxes within reach may add up to more than floats hold
};

}

#endif
