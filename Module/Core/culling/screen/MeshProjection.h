#ifndef VITRINE_CORE_CULLING_SCREEN_MESH_PROJECTION_H
#define VITRINE_CORE_CULLING_SCREEN_MESH_PROJECTION_H

#include "Core/culling/mesh/OccluderMesh.h"
#include "Core/culling/screen/NearClip.h"
#include "Core/culling/screen/ScreenProjection.h"
#include "Core/geometry/ScreenRectangle.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** A point on the screen: column and line of an s-buffer, and reversed depth. */
struct ScreenPoint
{
  float Column;
  float Line;
  float Depth;
};

/**
 * The points of a mesh on the screen, and the winding of its faces there. Reusing one object for all meshes avoids
 * allocations during a walk.
 */
class MeshProjection
{
public:
  enum class Facing : std::uint8_t
  {
    Neither, ///< The face has no area, or part of it is not behind the near plane.
    Front,   ///< The face is counter-clockwise on the screen.
    Back
  };

  /**
   * Projects a mesh. If some points are not behind the near plane, the mesh is clipped.
   * @param toScreen  the map from the mesh's model coordinates (MC) to the screen
   * @returns         true if there are points and all lie behind the near plane; then Rectangle() contains them all
   */
  bool Project(const OccluderMesh& mesh, const ScreenMatrix& toScreen);

  /**
   * Cuts a clipped mesh farther behind the near plane. Less is left of the mesh, and margins are narrower.
   * @param toScreen  the map that the mesh was projected with
   * @returns         true if this cuts off anything
   */
  bool ClipFarther(const ScreenMatrix& toScreen);

  const OccluderMesh& Mesh() const { return *this->Projected; }

  /** Returns the faces of the mesh, or of its part behind the near plane. */
  const std::vector<MeshFace>& Faces() const
  {
    return this->AreAllBehindNear ? this->Projected->Faces() : this->Rest.Faces();
  }
  const std::vector<MeshEdge>& Edges() const
  {
    return this->AreAllBehindNear ? this->Projected->Edges() : this->Rest.Edges();
  }

  /** Returns the mesh's patch that one of Faces() belongs to. */
  std::uint32_t PatchOf(std::uint32_t face) const
  {
    return this->Projected->Patches()[this->SourceOf(face)];
  }

  ScreenPoint Point(std::uint32_t i) const
  {
    return { this->Columns[i], this->Lines[i], this->Depths[i] };
  }

  /** Return the places of all points in the order of OccluderMesh::Coordinates(), padding included. */
  const std::vector<float>& ColumnsOfPoints() const { return this->Columns; }
  const std::vector<float>& LinesOfPoints() const { return this->Lines; }
  const std::vector<float>& DepthsOfPoints() const { return this->Depths; }

  /** Returns the rectangle around all points of faces, including the margin. */
  const ScreenRectangle& Rectangle() const { return this->Around; }

  /** Returns the largest distance between a point and the place where a device may draw it. */
  const ScreenMargin& Margin() const { return this->DeviceMargin; }

  /**
   * Returns the device margin of one face. It is smaller than Margin() if the face is farther away than the mesh's
   * nearest point.
   */
  ScreenMargin MarginOf(const MeshFace& face) const
  {
    return this->DeviceRounding.MarginAt(this->InverseW(face), this->DeviceSnapping);
  }

  /** Returns 1/w of a point, which must be behind the near plane. */
  float InverseW(std::uint32_t point) const { return this->Inverses[point]; }

  /** Returns 1/w of a face's nearest corner. */
  float InverseW(const MeshFace& face) const
  {
    return std::max({ this->Inverses[face[0]], this->Inverses[face[1]], this->Inverses[face[2]] });
  }

  /** Returns the float rounding of points on the device. */
  const ScreenRounding& Rounding() const { return this->DeviceRounding; }

  /**
   * Returns the part of Margin() by which a rasteriser moves points for coverage. Depths remain those of the points
   * that are not moved.
   */
  const ScreenMargin& Snapping() const { return this->DeviceSnapping; }

  /** Returns the winding of one of Faces(). */
  Facing TurnOf(const MeshFace& face) const
  {
    const ScreenPoint a = this->Point(face[0]), b = this->Point(face[1]), c = this->Point(face[2]);
    const float area =
      (b.Column - a.Column) * (c.Line - a.Line) - (c.Column - a.Column) * (b.Line - a.Line);
    return area > 0.0f ? Facing::Front : area < 0.0f ? Facing::Back : Facing::Neither;
  }

  /** Returns the winding of a face of the mesh. */
  Facing FacingOf(const MeshFace& face) const
  {
    const bool isWhole = this->AreAllBehindNear ||
      (this->IsBehindNear(face[0]) && this->IsBehindNear(face[1]) && this->IsBehindNear(face[2]));
    return isWhole ? this->TurnOf(face) : Facing::Neither;
  }

  /** Returns true if all points are behind the near plane. */
  bool IsBehindNear() const { return this->AreAllBehindNear; }

  /** Returns true if a point of the mesh is behind the near plane. */
  bool IsBehindNear(std::uint32_t point) const
  {
    return (this->BehindNear[point / LaneCount] >> (point % LaneCount) & 1) != 0;
  }

  /** Finds the windings of all Faces(). */
  void FindFacings();
  Facing FacingOf(std::uint32_t face) const { return this->Facings[face]; }

  /** Has a face count no more, as facing neither way. */
  void Exclude(std::uint32_t face) { this->Facings[face] = Facing::Neither; }

  /** Returns true if a device may clip faces at the sides, the near plane or the far plane of the view. */
  bool MayBeCut() const
  {
    return !this->AreAllBehindNear || this->ToScreen.MayBeCut(this->Around, this->Farthest);
  }

  /**
   * Returns true if a device may clip a face of the mesh. That is a face neither surely inside the view nor surely
   * beyond one of its sides.
   */
  bool MayBeCut(const MeshFace& face) const;

  /** Returns the homogeneous screen coordinates of a face of the mesh: column, line and depth, each times w, and w. */
  std::array<glm::dvec4, 3> CornersOnScreen(const MeshFace& face) const;

  /** Returns the face of the mesh that one of Faces() is a part of. */
  const MeshFace& WholeOf(std::uint32_t face) const
  {
    return this->Projected->Faces()[this->SourceOf(face)];
  }

  /** Returns the map that the mesh was projected with. */
  const ScreenMatrix& View() const { return this->ToScreen; }

  /** Returns the rectangle around a face, including the margin. */
  ScreenRectangle RectangleOf(const MeshFace& face) const;

  /** Returns true if a device may draw anything of the part that is cut off at the near plane. */
  bool MayShowBeforeNear() const { return !this->AreAllBehindNear && this->Rest.MayShowBefore(); }

private:
  void MakeRoom(std::size_t points);
  void Clip(const ScreenMatrix& toScreen, double leastRatio);
  std::uint32_t SourceOf(std::uint32_t face) const
  {
    return this->AreAllBehindNear ? face : this->Rest.Sources()[face];
  }

  const OccluderMesh* Projected = nullptr;
  ScreenMatrix ToScreen{};
  std::vector<float> Columns, Lines,
    Depths;                    ///< Places of the mesh's points, followed by those of the cuts.
  std::vector<float> Inverses; ///< 1/w of these points.
  std::vector<std::uint8_t> BehindNear; ///< One bit per point.
  bool AreAllBehindNear = false;
  NearClip Rest; ///< The part of the mesh behind the near plane, if not all of it is.
  ScreenRectangle Around{};
  float Farthest = 0.0f; ///< Least reversed depth of all points of faces.
  ScreenMargin DeviceMargin;
  ScreenMargin DeviceSnapping;
  ScreenRounding DeviceRounding{};
  std::vector<Facing> Facings;
};

}

#endif
