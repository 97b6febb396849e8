#ifndef VITRINE_CORE_CULLING_COVER_SCREEN_PATCHES_H
#define VITRINE_CORE_CULLING_COVER_SCREEN_PATCHES_H

#include "Core/culling/screen/MeshProjection.h"
#include "Core/culling/steady/CutFaces.h"
#include "Core/culling/steady/SlantedDepth.h"
#include "Core/geometry/BeyondAll.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * The faces of an occluder that count in a view, in patches of faces with about the same direction. A plane of depth
 * stands for each patch. It lies behind all faces of the patch, close to them. A face whose depth is hardly known would
 * spoil the plane, so it is a patch of its own.
 */
class ScreenPatches
{
public:
  static constexpr std::uint32_t None = 0xffffffffu;

  struct Patch
  {
    SlantedDepth Bound;
    float Left = BeyondAll; ///< columns that the patch may be drawn on
    float Right = -BeyondAll;
    float Bottom = BeyondAll; ///< lines that the patch may be drawn on
    float Top = -BeyondAll;
  };

  /**
   * Finds the patches of a projected mesh.
   * @param projection  the projected occluder, with its facings
   * @param facing      the faces that count
   * @param samples     the sample positions
   */
  void Find(
    const MeshProjection& projection, MeshProjection::Facing facing, const SampleGrid& samples);

  std::size_t Count() const { return this->Patches.size(); }
  const Patch& operator[](std::uint32_t patch) const { return this->Patches[patch]; }

  /** Returns the index of the patch of a face, or None if the face does not count. */
  std::uint32_t IndexOf(std::uint32_t face) const { return this->PatchOf[face]; }

private:
  struct CountedFace
  {
    std::uint32_t Face;
    SlantedDepth Bound;
  };

  /** Sums over the corners of the faces of a patch, relative to the first corner. */
  struct Fit
  {
    ScreenPoint Origin{};
    int Faces = 0;
    double Columns = 0.0, Lines = 0.0, Depths = 0.0;
    double ColumnColumns = 0.0, ColumnLines = 0.0, LineLines = 0.0;
    double ColumnDepths = 0.0, LineDepths = 0.0;

    void Add(const ScreenPoint& point);
    SlantedDepth BestPlane() const;
  };

  void FindFaces(MeshProjection::Facing facing);
  std::uint32_t NumberFor(std::uint32_t face, bool isAlone);
  void AddFace(const CountedFace& counted, std::uint32_t patch);
  void FitPlanes();
  void MoveBehind(const CountedFace& counted, Patch& patch) const;

  const MeshProjection* Projection = nullptr;
  CutFaces Cuts;
  std::vector<CountedFace> Faces;
  std::vector<Patch> Patches;
  std::vector<Fit> Fits;               ///< for each patch
  std::vector<std::uint32_t> PatchOf;  ///< for each face its patch, or None
  std::vector<std::uint32_t> NumberOf; ///< for each patch of the mesh its patch here, or None
};

}

#endif
