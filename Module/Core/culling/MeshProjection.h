#ifndef VITRINE_CORE_CULLING_MESH_PROJECTION_H
#define VITRINE_CORE_CULLING_MESH_PROJECTION_H

#include "Core/culling/OccluderMesh.h"
#include "Core/culling/SBuffer.h"
#include "Core/culling/ScreenProjection.h"

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
    Neither, ///< not all of it lies behind the near plane
    Front,   ///< counter-clockwise on the screen
    Back
  };

  /**
   * @param toScreen  of the mesh's model coordinates
   * @returns whether there are points and all lie behind the near plane, so that Rectangle() holds them all
   */
  bool Project(const OccluderMesh& mesh, const ScreenMatrix& toScreen);

  const OccluderMesh& Mesh() const { return *this->Projected; }
  const std::vector<ScreenPoint>& Points() const { return this->OnScreen; }

  /** Around all points, margin included. */
  const ScreenRectangle& Rectangle() const { return this->Around; }

  /** By how much a device may draw points elsewhere. */
  const ScreenMargin& Margin() const { return this->DeviceMargin; }

  /** Finds which way the faces go around. */
  void FindFacings();
  Facing FacingOf(std::uint32_t face) const { return this->Facings[face]; }

private:
  const OccluderMesh* Projected = nullptr;
  std::vector<ScreenPoint> OnScreen;
  std::vector<std::uint8_t> IsBehindNear;
  bool AreAllBehindNear = false;
  ScreenRectangle Around{};
  ScreenMargin DeviceMargin;
  std::vector<Facing> Facings;
};

}

#endif
