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
 * How far off a face's plane a device may draw it that cuts it at the sides of the view. Of what is left it draws triangles of the corners, whichever it likes, and takes depths from those. They lie in the face's plane
 * but for what is rounded where edges are cut: where two corners are close together, a triangle is a sliver that turns far for that, and is drawn beside itself.
 */
class CutFaces
{
public:
  /**
   * Comes to a mesh that is projected, and stays so while faces of it are asked for.
   * @param samples  where something can show
   */
  void Begin(const MeshProjection& projection, const SampleGrid& samples);

  /**
   * Of depths of a face of the mesh, by how much they may be off in any of the triangles, none of which is thinner for a device than a step of its floats; 0 if it is not cut, and more than all depths differ if
   * nothing is known.
   */
  float UnsteadyOf(const MeshFace& face);

  /** The same of one of the projection's faces. */
  float UnsteadyOf(std::uint32_t face) { return this->UnsteadyOf(this->Projection->WholeOf(face)); }

  /** The same of both faces of facets that are seen from one side; 0 of the others. */
  FacetDepths UnsteadyOf(const FewFacets& facets, MeshProjection::Facing facing);

private:
  /** A corner of what is left of the face at hand. */
  struct Corner
  {
    float Column, Line, Depth, InverseOfW;
    float Reach; ///< as CutCorner has it
    glm::dvec2 Place;
    SlideRange Slides; ///< of SlidesOnScreen
    double Slid;       ///< by all of those at most
    unsigned
      Sides; ///< of the view that it lies so close to that nothing beyond it has samples, a bit for each
    unsigned Planes; ///< as CutCorner has them
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
  bool MayBeCut = false; ///< any of its faces
  ViewCuts Cuts;
  ScreenRounding OfCuts{};   ///< of where edges are cut
  float Step = 0.0f;         ///< of columns and lines
  bool AreSidesBare = false; ///< of samples
  std::vector<Corner> Corners;
  std::vector<glm::dvec2> SlidesOnScreen; ///< of them, in columns and lines
  float ByColumn = 0.0f; ///< by how much the depth of the face at hand changes, without the sign
  float ByLine = 0.0f;
};

}

#endif
