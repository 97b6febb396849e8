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

/**
 * A matrix to homogeneous screen coordinates, and the error of a device that applies it in floats. The coordinates are
 * column, line and reversed depth, each times w, and w.
 */
struct ScreenMatrix
{
  glm::dmat4 Matrix;
  glm::vec4 Rounding;    ///< Rounding of each of the four coordinates.
  ScreenMargin Snapping; ///< Additional movement by the rasteriser.
  glm::vec2 Size;        ///< Numbers of columns and lines.
  /** Lines of the view below and above the screen. */
  float LinesBelow = 0.0f;
  float LinesAbove = 0.0f;
  glm::vec2 Before{ 0.0f }; ///< Columns and lines of the window before the view.

  /** Return the lowest and the highest line of the view. */
  float Bottom() const { return -this->LinesBelow; }
  float Top() const { return this->Size.y + this->LinesAbove; }

  /** Returns the device's rounding of columns and lines in the window. */
  glm::vec2 OfPlaces() const
  {
    return RoundingOfFloat *
      glm::vec2(this->Before.x + this->Size.x, this->Before.y + this->Top() - this->Bottom());
  }

  /** Returns half of the view's size in columns, lines and depths. */
  glm::dvec4 HalfOfView() const
  {
    return { 0.5 * this->Size.x, 0.5 * (this->Top() - this->Bottom()), 0.5, 0.0 };
  }

  /** Returns the float rounding of points on the device. Lines count as reaching through the whole view. */
  ScreenRounding RoundingOnScreen() const
  {
    const glm::vec4& own = this->Rounding;
    const glm::vec2 ofPlaces = this->OfPlaces();
    return { { own.x, own.w, this->Size.x, ofPlaces.x },
      { own.y, own.w, this->Top() - this->Bottom(), ofPlaces.y, this->Bottom() },
      { own.z, own.w, 1.0f } };
  }

  /** Returns the device's rounding of points in the view, for a culler that computes them in doubles. */
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

  /** Returns true if a part of the rectangle lies between the sides of the view. */
  bool IsInView(const ScreenRectangle& rectangle) const
  {
    return rectangle.Right >= 0.0f && rectangle.Left <= this->Size.x &&
      rectangle.Top >= this->Bottom() && rectangle.Bottom <= this->Top();
  }

  /**
   * Returns true if an object in this rectangle may reach beyond the sides, the near plane or the far plane of the
   * view. `farthest` is the object's least reversed depth. The screen may be only some lines of the view.
   */
  bool MayBeCut(const ScreenRectangle& rectangle, float farthest) const
  {
    return !(rectangle.Left >= 0.0f && rectangle.Right <= this->Size.x &&
      rectangle.Bottom >= this->Bottom() && rectangle.Top <= this->Top() &&
      rectangle.Nearest < 1.0f && farthest > RoundingOfCuts);
  }

  /** Returns the margin of points on the screen whose w is at least `leastW`. */
  ScreenMargin MarginFrom(float leastW) const
  {
    return this->RoundingOnScreen().MarginAt(1.0f / leastW, this->Snapping);
  }
};

/** The rectangles of eight boxes on the screen. */
struct RectangleLanes
{
  float Left[LaneCount];
  float Right[LaneCount];
  float Bottom[LaneCount];
  float Top[LaneCount];
  float Nearest[LaneCount];
  float Farthest[LaneCount]; ///< Least reversed depth of the corners.
  unsigned Outside;          ///< A bit for each box that lies outside of the view.
  /** A bit for each box that reaches in front of the near plane. It has no rectangle, and nothing hides it. */
  unsigned Near;

  /**
   * Returns the rectangle of a box that is neither Near nor Outside. It surely contains everything that is drawn of the
   * box, and the box is surely not nearer than its depth.
   */
  ScreenRectangle At(int lane) const
  {
    return { this->Left[lane], this->Right[lane], this->Bottom[lane], this->Top[lane],
      this->Nearest[lane] };
  }

  /**
   * Returns a bit for each box that may have samples where it is drawn. The bits of Near and Outside boxes have no
   * meaning.
   */
  unsigned MayHaveAny(const SampleGrid& samples) const
  {
    return samples.MayHaveAny(LoadLanes(this->Left), LoadLanes(this->Right)) &
      samples.MayHaveAny(LoadLanes(this->Bottom), LoadLanes(this->Top));
  }
};

/** The rectangle of a box that reaches in front of the near plane and may be anywhere on the screen. */
inline constexpr ScreenRectangle Everywhere = { -1e30f, 1e30f, -1e30f, 1e30f, 1.0f };

/**
 * Maps world coordinates (WC) to columns and lines of an s-buffer and to reversed depth. Reversed depth is (w - z) / 2w
 * of clip coordinates, 1 at the near plane and 0 at the far plane. It is affine on the screen along a plane, in
 * perspective and in parallel projection. Floats have as many bits near the far plane as near the near plane. (E.
 * Lapidous, G. Jiao: Optimal depth buffer for low-cost graphics hardware, Graphics Hardware 1999)
 */
class ScreenProjection
{
public:
  /**
   * Creates the projection of a view.
   * @param toClip    from world coordinates (WC) to OpenGL's clip coordinates, for column vectors
   * @param columns   number of columns from left to right; the last may be partial
   * @param lines     number of lines from bottom to top
   * @param reach     largest sums of absolute terms that lead to drawn world coordinates; a device's floats are coarser
   *                  for larger sums
   * @param snapping  movement of edges and depths by a rasteriser, in addition to float rounding
   * @param growth    columns and lines by which boxes grow on the screen, for wide lines and points
   * @param before    columns and lines of the window before the view
   */
  ScreenProjection(const glm::dmat4& toClip, double columns, double lines, const glm::dvec3& reach,
    const ScreenMargin& snapping, const glm::vec2& growth = glm::vec2(0.0f),
    const glm::vec2& before = glm::vec2(0.0f));

  /** Projects eight boxes. They must be finite and within `reach`. The results of empty boxes have no meaning. */
  void Project(const BoxLanes& boxes, RectangleLanes& rectangles) const
  {
    this->Project(this->WorldInFloats, boxes, this->MayOverflow, rectangles);
  }

  /**
   * Projects eight boxes of a part.
   * @param toScreen  the result of Of() for the part, translated to the origin of the boxes; the sums of absolute terms
   *                  that lead to world coordinates of the corners must not exceed `reach`
   */
  void Project(const glm::mat4& toScreen, const BoxLanes& boxes, RectangleLanes& rectangles) const;

  /**
   * Projects a single box at any distance. Returns Everywhere if the box reaches in front of the near plane or has no
   * place, and nothing if it lies outside.
   */
  std::optional<ScreenRectangle> RectangleOf(const Box& box) const;

  /** Returns true if a rectangle reaches beyond the screen. */
  bool ReachesBeyond(const ScreenRectangle& rectangle) const;

  /** Returns true if a device may clip an object in this rectangle. `farthest` is the object's least reversed depth. */
  bool MayBeCut(const ScreenRectangle& rectangle, float farthest) const
  {
    return this->World.MayBeCut(rectangle, farthest);
  }

  /** Returns the view of some of the lines. Lines count from `first`. */
  ScreenProjection OfLines(int first, int count) const;

  /** Returns the view with boxes that grow on the screen by so many more columns and lines. */
  ScreenProjection GrownBy(const glm::vec2& growth) const
  {
    ScreenProjection grown = *this;
    grown.Growth += growth;
    return grown;
  }

  PlaneView OfPlanes() const;

  /**
   * Returns the number of columns or lines, whichever are fewer, of a unit length at a distance of 1. In parallel
   * projection the distance does not matter.
   */
  double SmallestScale() const;

  /** Returns the float error of a device at a distance of 1, in columns or lines, whichever are more. */
  double RoundingAtOne() const;

  /** Returns the movement of edges and depths by a rasteriser. */
  const ScreenMargin& Snapping() const { return this->World.Snapping; }

  /** Returns true if boxes grow on the screen. */
  bool Grows() const { return this->Growth != glm::vec2(0.0f); }

  /** Returns a rectangle enlarged by the growth. */
  ScreenRectangle Grown(const ScreenRectangle& rectangle) const;

  /** Returns the growth in columns and lines. */
  const glm::vec2& GrowthOnScreen() const { return this->Growth; }

  /** Returns the homogeneous screen coordinates of a point in WC: column, line and depth, each times w, and w. */
  glm::dvec4 ToScreen(const glm::dvec3& point) const;

  /**
   * Returns the map from a part's model coordinates (MC) to the screen.
   * @param toWorld  from model coordinates to WC; the sums of absolute terms must not exceed `reach`
   */
  ScreenMatrix Of(const glm::dmat4& toWorld) const;

  /**
   * Returns the map from a part's model coordinates (MC) to the screen, with tighter bounds of the rounding. The device
   * must multiply by one matrix from the part's coordinates to the screen.
   */
  ScreenMatrix Of(const glm::dmat4& toWorld, const DeviceCoordinates& device) const;

private:
  void Project(const glm::mat4& toScreen, const BoxLanes& boxes, bool mayOverflow,
    RectangleLanes& rectangles) const;

  ScreenMatrix World;
  /** Absolute terms from WC to columns, lines, depths and w, as a device sums them. */
  glm::dmat4 Sizes;
  glm::mat4 WorldInFloats; ///< World.Matrix in floats.
  glm::vec2 Growth;
  bool MayOverflow; ///< True if box coordinates within reach may overflow floats.
};

}

#endif
