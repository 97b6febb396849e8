#ifndef VITRINE_CORE_CULLING_STEADY_VIEW_CUTS_H
#define VITRINE_CORE_CULLING_STEADY_VIEW_CUTS_H

#include "Core/culling/screen/ScreenProjection.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

namespace vitrine
{

/** Returns what a device rounds of places where it cuts edges. */
ScreenRounding RoundingWhereCut(const ScreenMatrix& view);

/** A range of indices, from First up to before End. */
struct SlideRange
{
  std::size_t First = 0;
  std::size_t End = 0;
};

/** A corner of what is left of a face. Its place is column, line and depth, each times w, and w. */
struct CutCorner
{
  glm::dvec4 Place;
  SlideRange Slides{}; ///< range in ViewCuts::Slides()
  /** True for the second corner of two. Rounding decides whether a corner is cut off, which leaves two. */
  bool IsOneOfTwo = false;
  unsigned Planes = 0; ///< a bit for each plane of the view that it lies in
  /** How far it may be off the face, in units of what floats round of the width, height and depth of the view. */
  double Reach = 1.0;
};

/**
 * Cuts faces as devices without a guard band do: at the sides of the view, and at its near and far plane. Such a device
 * draws triangles between the corners that are left, and takes depths from those. Which triangles it draws is not
 * known. If two corners lie close together, one triangle is a sliver, and the plane of the face tells nothing of it.
 * (I. E. Sutherland, G. W. Hodgman: Reentrant polygon clipping, Communications of the ACM 1974)
 *
 * If a corner lies so close to a cut that rounding decides whether it is cut off, it counts as two corners.
 */
class ViewCuts
{
public:
  /** Bits of the sides in CutCorner::Planes, without the near and the far plane. */
  static constexpr unsigned Sides = 0b111100;

  /** Takes a view. */
  void Begin(const ScreenMatrix& toScreen);

  /** Returns the corners of what is left of a face, in their order around it. They are valid until the next call. */
  const std::vector<CutCorner>& Cut(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c);

  /**
   * Vectors within the face by which corners may slide either way, because rounding moves the places where planes cut
   * edges.
   */
  const std::vector<glm::dvec4>& Slides() const { return this->Slid; }

private:
  /** A plane of the view. Points on its inner side have a positive product with the normal. */
  struct Plane
  {
    glm::dvec4 Normal;
    double Rounding; ///< error bound of the product
    unsigned Bit = 0;
  };

  /** A corner, and its side of a plane. */
  struct Sided
  {
    const CutCorner* Corner;
    double Distance;
    double Doubt; ///< error bound of Distance
    int Side;     ///< 1 if it is surely inside, -1 if it is surely beyond, and 0 if neither is sure
  };

  void CutAt(const Plane& plane);
  bool FindSides(const Plane& plane);
  double DoubtOf(const CutCorner& corner, const Plane& plane) const;
  CutCorner MaybeCutOf(const Sided& corner, const Sided& last, const Sided& next);
  CutCorner CrossingOf(const Sided& from, const Sided& to, const Plane& plane);
  void AddSlides(const CutCorner& of, double weight);
  double ReachOf(const CutCorner& corner) const;

  Plane Planes[6]{};
  glm::dvec2 Size{};              ///< the columns and lines of the view
  std::vector<CutCorner> Corners; ///< corners of the current face
  std::vector<CutCorner> Uncut;   ///< the corners before a plane cuts them
  std::vector<Sided> Around;      ///< the same, with their sides of the plane
  std::vector<glm::dvec4> Slid;   ///< slides of all corners of the current face
};

}

#endif
