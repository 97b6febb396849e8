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
 * The points of a mesh on the screen, and which way its faces go around there. One object serves mesh after mesh, so that a
 * walk asks for no memory.
 */
class MeshProjection
{
public:
  enum class Facing : std::uint8_t
  {
    Neither, ///< it has no area, or not all of it lies behind the near plane
    Front,   ///< counter-clockwise on the screen
    Back
  };

  /**
   * @param toScreen  of the mesh's model coordinates
   * @returns whether there are points and all lie behind the near plane, so that Rectangle() holds them all; else it is clipped
   */
  bool Project(const OccluderMesh& mesh, const ScreenMatrix& toScreen);

  /**
   * Cuts a mesh that is clipped farther behind the near plane: less is left, and margins are narrower.
   * @param toScreen  with which it was projected
   * @returns whether anything is cut off by that
   */
  bool ClipFarther(const ScreenMatrix& toScreen);

  const OccluderMesh& Mesh() const { return *this->Projected; }

  /** The mesh's, or of what of it lies behind the near plane. */
  const std::vector<MeshFace>& Faces() const
  {
    return this->AreAllBehindNear ? this->Projected->Faces() : this->Rest.Faces();
  }
  const std::vector<MeshEdge>& Edges() const
  {
    return this->AreAllBehindNear ? this->Projected->Edges() : this->Rest.Edges();
  }

  /** The patch of the mesh that one of Faces() belongs to. */
  std::uint32_t PatchOf(std::uint32_t face) const
  {
    return this->Projected->Patches()[this->SourceOf(face)];
  }

  ScreenPoint Point(std::uint32_t i) const
  {
    return { this->Columns[i], this->Lines[i], this->Depths[i] };
  }

  /** Where all points of the mesh are, as they lie in memory: eight at a time, as their coordinates do. */
  const std::vector<float>& ColumnsOfPoints() const { return this->Columns; }
  const std::vector<float>& LinesOfPoints() const { return this->Lines; }
  const std::vector<float>& DepthsOfPoints() const { return this->Depths; }

  /** Around all points of faces, margin included. */
  const ScreenRectangle& Rectangle() const { return this->Around; }

  /** By how much a device may draw points elsewhere. */
  const ScreenMargin& Margin() const { return this->DeviceMargin; }

  /** The same of a face's: less where all of it is farther than the nearest point. */
  ScreenMargin MarginOf(const MeshFace& face) const
  {
    return this->DeviceRounding.MarginAt(this->InverseW(face), this->DeviceSnapping);
  }

  /** 1 over w of a point that is behind the near plane. */
  float InverseW(std::uint32_t point) const { return this->Inverses[point]; }

  /** The same of a face's nearest corner. */
  float InverseW(const MeshFace& face) const
  {
    return std::max({ this->Inverses[face[0]], this->Inverses[face[1]], this->Inverses[face[2]] });
  }

  /** What a device's floats round of points. */
  const ScreenRounding& Rounding() const { return this->DeviceRounding; }

  /** What of that a rasteriser moves points by where it looks what they cover; depths stay those of the points that it did not move. */
  const ScreenMargin& Snapping() const { return this->DeviceSnapping; }

  /** Which way one of Faces() goes around. */
  Facing TurnOf(const MeshFace& face) const
  {
    const ScreenPoint a = this->Point(face[0]), b = this->Point(face[1]), c = this->Point(face[2]);
    const float area =
      (b.Column - a.Column) * (c.Line - a.Line) - (c.Column - a.Column) * (b.Line - a.Line);
    return area > 0.0f ? Facing::Front : area < 0.0f ? Facing::Back : Facing::Neither;
  }

  /** Which way a face of the mesh goes around. */
  Facing FacingOf(const MeshFace& face) const
  {
    const bool isWhole = this->AreAllBehindNear ||
      (this->IsBehindNear(face[0]) && this->IsBehindNear(face[1]) && this->IsBehindNear(face[2]));
    return isWhole ? this->TurnOf(face) : Facing::Neither;
  }

  /** Whether all points are behind the near plane. */
  bool IsBehindNear() const { return this->AreAllBehindNear; }

  /** Whether a point, which may be before the near plane, is not. */
  bool IsBehindNear(std::uint32_t point) const
  {
    return (this->BehindNear[point / LaneCount] >> (point % LaneCount) & 1) != 0;
  }

  /** Finds which way all of Faces() go around. */
  void FindFacings();
  Facing FacingOf(std::uint32_t face) const { return this->Facings[face]; }

  /** Has a face count no more, as facing neither way. */
  void Drop(std::uint32_t face) { this->Facings[face] = Facing::Neither; }

  /** Whether a device may cut faces at the sides of the view, or its near or far plane. */
  bool MayBeCut() const
  {
    return !this->AreAllBehindNear || this->ToScreen.MayBeCut(this->Around, this->Farthest);
  }

  /** Whether it may cut a face of the mesh: that is neither surely within the view nor surely beyond one of its sides. */
  bool MayBeCut(const MeshFace& face) const;

  /** Corners of a face of the mesh: column, line and depth, each times w, and w. */
  std::array<glm::dvec4, 3> CornersOnScreen(const MeshFace& face) const;

  /** The face of the mesh that one of Faces() is of. */
  const MeshFace& WholeOf(std::uint32_t face) const
  {
    return this->Projected->Faces()[this->SourceOf(face)];
  }

  /** What the mesh was projected with. */
  const ScreenMatrix& View() const { return this->ToScreen; }

  /** Around a face, margin included. */
  ScreenRectangle RectangleOf(const MeshFace& face) const;

  /** Whether anything may be drawn of what is cut off at the near plane. */
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
  std::vector<float> Columns, Lines, Depths; ///< of the points, those where the mesh is cut last
  std::vector<float> Inverses;               ///< of the same points' w
  std::vector<std::uint8_t> BehindNear;      ///< a bit for each point
  bool AreAllBehindNear = false;
  NearClip Rest; ///< where they are not
  ScreenRectangle Around{};
  float Farthest = 0.0f; ///< depth of all points of faces
  ScreenMargin DeviceMargin;
  ScreenMargin DeviceSnapping;
  ScreenRounding DeviceRounding{};
  std::vector<Facing> Facings;
};

}

#endif
