#ifndef VITRINE_CORE_CULLING_SCREEN_NEAR_CLIP_H
#define VITRINE_CORE_CULLING_SCREEN_NEAR_CLIP_H

#include "Core/culling/mesh/OccluderMesh.h"
#include "Core/culling/screen/ScreenProjection.h"

#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * What of a mesh lies behind the near plane, as a mesh: a point on an edge that is cut is one for the faces on both sides, edges keep their
 * faces, and what the cut opens is a border.
 * (I. E. Sutherland, G. W. Hodgman: Reentrant polygon clipping, Communications of the ACM 1974)
 *
 * It is cut farther behind the plane than a device may round. So all of what is left is drawn, as a part of a larger face.
 */
class NearClip
{
public:
  /**
   * @param toScreen      of the mesh's model coordinates
   * @param leastRatio    of w to what a device rounds in it, 1 or more: what has less is cut off as well
   */
  void Clip(const OccluderMesh& mesh, const ScreenMatrix& toScreen, double leastRatio);

  /** Their points are the mesh's, and behind as many as it has coordinates those of Cuts(). */
  const std::vector<MeshFace>& Faces() const { return this->Triangles; }
  const std::vector<MeshEdge>& Edges() const { return this->Sides; }

  /** Of each of those faces which of the mesh's it is of. */
  const std::vector<std::uint32_t>& Sources() const { return this->SourceOf; }

  /** Points that the mesh does not have: column, line and depth, each times w, and w. */
  const std::vector<glm::dvec4>& Cuts() const { return this->CutPoints; }

  /** Whether a device may draw anything of what is cut off, within the view's sides. */
  bool MayShowBefore() const;

  /** Of all points of faces. */
  float LeastW() const { return this->NearestW; }

private:
  /** What is left of a face: faces one after the other, by how many of its corners are behind. */
  struct Remainder
  {
    std::uint32_t First;
    std::uint32_t CornersBehind;
    std::array<std::uint32_t, 3>
      Cuts; ///< on the sides that begin at its corners, where those are cut
  };

  void FindPointsBehind();
  void CutEdges();
  void AddFaces();
  void AddOneCorner(const MeshFace& face, const Remainder& remainder, int behind);
  void AddTwoCorners(const MeshFace& face, const Remainder& remainder, int before);
  void AddEdges();
  std::uint32_t AddCut(std::uint32_t behind, std::uint32_t before);
  std::uint32_t FaceAt(std::uint32_t face, std::uint32_t from) const;
  bool MayShowBefore(const MeshFace& face) const;
  bool IsOutside(const std::vector<glm::dvec4>& corners) const;
  glm::dvec4 OnScreen(std::uint32_t point) const;
  std::array<double, 2> DistancesOf(const glm::dvec4& onScreen) const;

  const OccluderMesh* Mesh = nullptr;
  ScreenMatrix ToScreen{};
  double LeastRatio = 1.0;
  std::vector<std::uint8_t> IsBehind;  ///< each point
  std::vector<Remainder> Remainders;   ///< of each face
  std::vector<std::uint32_t> EdgeCuts; ///< on each edge, where it is cut
  std::vector<glm::dvec4> CutPoints;
  std::vector<MeshFace> Triangles;
  std::vector<std::uint32_t> SourceOf;
  std::vector<MeshEdge> Sides;
  float NearestW = 0.0f;
};

}

#endif
