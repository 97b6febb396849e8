#ifndef VITRINE_CORE_CULLING_CUT_FACES_H
#define VITRINE_CORE_CULLING_CUT_FACES_H

#include "Core/culling/FaceSlopes.h"
#include "Core/culling/MeshProjection.h"
#include "Core/culling/ViewCuts.h"

#include <array>
#include <cstddef>
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
  /** Comes to a mesh that is projected, and stays so while faces of it are asked for. */
  void Begin(const MeshProjection& projection);

  /**
   * Of depths of one of its faces, by how much they may be off in any of the triangles, none of which is thinner for a device than a step of its floats; 0 if it is not cut, and more than all depths differ if
   * nothing is known.
   */
  float UnsteadyOf(std::uint32_t face);

private:
  template <class Function>
  void ForEachTriangle(const Function& function) const;
  bool IsKnown() const;
  const CutCorner& At(int corner) const
  {
    return (*this->Corners)[static_cast<std::size_t>(corner)];
  }
  FacePlaces<float> PlacesOf(const std::array<int, 3>& corners) const;
  double AreaDoubt(const std::array<int, 3>& corners) const;
  void FindSlopes();
  float UnsteadyIn(const std::array<int, 3>& corners) const;
  bool IsOnASide(const std::array<int, 3>& corners) const;

  const MeshProjection* Projection = nullptr;
  bool MayBeCut = false; ///< any of its faces
  ViewCuts Cuts;
  ScreenRounding OfCuts{};                         ///< of where edges are cut
  float Step = 0.0f;                               ///< of columns and lines
  const std::vector<CutCorner>* Corners = nullptr; ///< of the face at hand
  float ByColumn = 0.0f; ///< by how much its depth changes, without the sign
  float ByLine = 0.0f;
};

}

#endif
