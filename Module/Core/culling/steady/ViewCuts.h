#ifndef VITRINE_CORE_CULLING_STEADY_VIEW_CUTS_H
#define VITRINE_CORE_CULLING_STEADY_VIEW_CUTS_H

#include "Core/culling/screen/ScreenProjection.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

namespace vitrine
{

/** Of places in the view, where edges are cut. */
ScreenRounding RoundingWhereCut(const ScreenMatrix& view);

/** Numbers of a row: from the first one up to the last but one. */
struct SlideRange
{
  std::size_t First = 0;
  std::size_t End = 0;
};

/** A corner of what is left of a face: column, line and depth, each times w, and w. */
struct CutCorner
{
  glm::dvec4 Place;
  SlideRange Slides{}; ///< of ViewCuts::Slides()
  bool IsOneOfTwo =
    false; ///< the other of two, as rounding decides whether one is cut off and leaves two
  unsigned Planes = 0; ///< that it lies in, a bit for each
  double Reach =
    1.0; ///< how many times what floats round of the view's width, height and depth it may be off the face
};

/**
 * Cuts faces as devices do that have no guard band: at the sides of the view, and at its near and its far plane. Of what is left such a device draws triangles between the corners, and takes depths from those:
 * where two corners lie close together one of the triangles is a sliver, of which the face's own plane tells nothing. Which triangles it draws is its own affair.
 * (I. E. Sutherland, G. W. Hodgman: Reentrant polygon clipping, Communications of the ACM 1974)
 *
 * A corner that lies so close to where it is cut that rounding decides counts as two: it may be cut off, and leave two.
 */
class ViewCuts
{
public:
  static constexpr unsigned Sides =
    0b111100; ///< bits of CutCorner::Planes: not the near and the far plane

  /** Comes to a view. */
  void Begin(const ScreenMatrix& toScreen);

  /** What is left of a face, in order around it; valid until the next call. */
  const std::vector<CutCorner>& Cut(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c);

  /** Within the face: so far this way or that a corner may be by each, where rounding has planes cut edges elsewhere. */
  const std::vector<glm::dvec4>& Slides() const { return this->Slid; }

private:
  /** Where points are on the inner side that have a positive product. */
  struct Plane
  {
    glm::dvec4 Normal;
    double Rounding; ///< of the product
    unsigned Bit = 0;
  };

  /** A corner, and where a plane has it. */
  struct Sided
  {
    const CutCorner* Corner;
    double Distance;
    double Doubt; ///< of that
    int Side;     ///< 1 if it is surely inside, -1 surely beyond, and 0 neither
  };

  void CutAt(const Plane& plane);
  bool FindSides(const Plane& plane);
  double DoubtOf(const CutCorner& corner, const Plane& plane) const;
  CutCorner MaybeCutOf(const Sided& corner, const Sided& last, const Sided& next);
  CutCorner CrossingOf(const Sided& from, const Sided& to, const Plane& plane);
  void AddSlides(const CutCorner& of, double weight);
  double ReachOf(const CutCorner& corner) const;

  Plane Planes[6]{};
  glm::dvec2 Size{};              ///< of the view
  std::vector<CutCorner> Corners; ///< of the face at hand
  std::vector<CutCorner> Uncut;   ///< the same before a plane cuts it
  std::vector<Sided> Around;      ///< those
  std::vector<glm::dvec4> Slid;   ///< of all corners that it had
};

}

#endif
