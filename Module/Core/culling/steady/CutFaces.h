#ifndef VITRINE_CORE_CULLING_STEADY_CUT_FACES_H
#define VITRINE_CORE_CULLING_STEADY_CUT_FACES_H

#include "Core/culling/mesh/FewFacets.h"
#include "Core/culling/screen/MeshProjection.h"
#include "Core/culling/steady/FaceSlopes.h"
#include "Core/culling/steady/ViewCuts.h"
#include "Core/geometry/SampleGrid.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Bounds how far from the plane of a face a device may draw it if it cuts the face at the sides of the view. The device
 * draws what is left as triangles of the corners, in any triangulation, and takes depths from those.
 *
 * The corners lie in the plane of the face, up to rounding where edges are cut. If two corners are close together, a
 * triangle is a sliver. Then this rounding tilts it much, and the device draws it beside its place.
 */
class CutFaces
{
public:
  /**
   * Takes a projected mesh. The projection must not change while its faces are asked for.
   * @param samples  the sample positions
   */
  void Begin(const MeshProjection& projection, const SampleGrid& samples);

  /**
   * Returns by how much the depths of a face of the mesh may be off, in any triangulation of what is left. Returns 0 if
   * the face is not cut, and AnyDepth if nothing is known. Triangles that are thinner for a device than a step of its
   * floats do not count.
   */
  float UnsteadyOf(const MeshFace& face);

  /** Returns by how much the depths of a face of the projection may be off, given its number. */
  float UnsteadyOf(std::uint32_t face) { return this->UnsteadyOf(this->Projection->WholeOf(face)); }

  /**
   * Returns by how much the depths of facets may be off, as the maximum over both faces of each. It is 0 for facets
   * that are not seen from that side.
   */
  FacetDepths UnsteadyOf(const FewFacets& facets, MeshProjection::Facing facing);

private:
  /** A corner of what is left of the current face, on the screen. */
  struct Corner
  {
    float Column, Line, Depth, InverseOfW;
    float Reach; ///< as CutCorner::Reach
    glm::dvec2 Place;
    SlideRange Slides; ///< range in SlidesOnScreen
    double Slid;       ///< the length of all slides together
    /** A bit for each side of the view that the corner lies close to: nothing beyond the corner has samples. */
    unsigned Sides;
    unsigned Planes; ///< as CutCorner::Planes
  };

  using Triangle = std::array<const Corner*, 3>;

  bool IsKnown(const std::vector<CutCorner>& corners) const;
  void FindCorners(const std::vector<CutCorner>& corners);
  glm::dvec2 AddSlides(const CutCorner& corner);
  unsigned SidesAt(const glm::dvec2& place, const glm::dvec2& slid) const;
  template <class Function>
  void ForEachTriangle(const Function& function) const;
  void FindSlopes();
  double AreaDoubt(const Triangle& corners) const;
  float LeastOnASide(const Triangle& corners, float off) const;
  float UnsteadyIn(const Triangle& corners) const;

  const MeshProjection* Projection = nullptr;
  bool MayBeCut = false; ///< a device may cut some face of the mesh
  ViewCuts Cuts;
  ScreenRounding OfCuts{};   ///< rounding of places where edges are cut
  float Step = 0.0f;         ///< the step of floats, in columns and lines
  bool AreSidesBare = false; ///< no samples lie close to the sides of the view
  std::vector<Corner> Corners;
  std::vector<glm::dvec2> SlidesOnScreen; ///< slides of the corners, in columns and lines
  float ByColumn = 0.0f; ///< the greatest slopes of depth of the current face, without sign
  float ByLine = 0.0f;
};

}

#endif
