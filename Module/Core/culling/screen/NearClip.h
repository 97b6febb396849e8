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
 * The part of a mesh behind the near plane, as a mesh. The faces on both sides of a cut edge share the cut point, edges
 * keep their faces, and the cut opens a border. (I. E. Sutherland, G. W. Hodgman: Reentrant polygon clipping,
 * Communications of the ACM 1974)
 *
 * The cut lies farther behind the plane than a device may round. So everything that is left is drawn, as a part of a
 * larger face.
 */
class NearClip
{
public:
  /**
   * Clips a mesh.
   * @param toScreen    the map from the mesh's model coordinates (MC) to the screen
   * @param leastRatio  least ratio of w to the device's rounding of w, at least 1; points with less are cut off as well
   */
  void Clip(const OccluderMesh& mesh, const ScreenMatrix& toScreen, double leastRatio);

  /**
   * Return the remaining faces and edges. Point indices below the size of the mesh's Coordinates() are points of the
   * mesh; the others are Cuts().
   */
  const std::vector<MeshFace>& Faces() const { return this->Triangles; }
  const std::vector<MeshEdge>& Edges() const { return this->Sides; }

  /** Returns the face of the mesh that each of Faces() is a part of. */
  const std::vector<std::uint32_t>& Sources() const { return this->SourceOf; }

  /** Returns the cut points in homogeneous screen coordinates: column, line and depth, each times w, and w. */
  const std::vector<glm::dvec4>& Cuts() const { return this->CutPoints; }

  /** Returns true if a device may draw anything of the part that is cut off, within the sides of the view. */
  bool MayShowBefore() const;

  /** Returns the least w of all points of faces. */
  float LeastW() const { return this->NearestW; }

private:
  /** The consecutive faces that remain of a face. Their number follows from the number of corners behind the cut. */
  struct Remainder
  {
    std::uint32_t First;
    std::uint32_t CornersBehind;
    /** The cuts on the sides that begin at each corner, where these are cut. */
    std::array<std::uint32_t, 3> Cuts;
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
  std::vector<std::uint8_t> IsBehind;  ///< One flag per point.
  std::vector<Remainder> Remainders;   ///< One entry per face of the mesh.
  std::vector<std::uint32_t> EdgeCuts; ///< The cut on each edge that is cut.
  std::vector<glm::dvec4> CutPoints;
  std::vector<MeshFace> Triangles;
  std::vector<std::uint32_t> SourceOf;
  std::vector<MeshEdge> Sides;
  float NearestW = 0.0f;
};

}

#endif
