/**
 * The lights that the pixels of a G-buffer go through.
 */
#ifndef VITRINE_LIGHTING_DEFERRED_DEFERRED_LISTS_H
#define VITRINE_LIGHTING_DEFERRED_DEFERRED_LISTS_H

#include "Core/lighting/LightRectangles.h"
#include "lighting/forward/LightBuffers.h"
#include "lighting/forward/ViewGrid.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vitrine
{

struct RendererLights;

/** What lights are assigned to. */
enum class LightsBy
{
  Volume, ///< a rectangle of the picture, of each light
  Tile,
  Cluster
};

struct DeferredGrid
{
  LightsBy By = LightsBy::Cluster;
  ClusterSettings Clusters;
  double PixelsAside = 0.0; ///< that pixels may be from the places that they show
};

class DeferredLists
{
public:
  /** Tells which clusters of a grid hold something; nothing if that is not known. */
  using FindMarks = std::function<std::vector<std::uint8_t>(const ViewGrid&)>;

  /** Returns an empty string, or why the driver cannot hold the lists. */
  std::string Assign(vtkOpenGLRenderer* renderer, const DeferredGrid& grid,
    const RendererLights& lights, const FindMarks& findMarks);

  /** Of tiles, or clusters. */
  const LightLists& Lists() const { return this->OfGrid; }
  const ViewGrid& Shown() const { return *this->Grid; }
  const ClusterGrid& Clusters() const { return this->Grid->Clusters(); }

  /** Of each light that reaches something, in the order in which shaders number them, where they are assigned to volumes. */
  const std::vector<LightRectangle>& Rectangles() const { return this->Volumes; }

  void SetUniforms(vtkShaderProgram* program) const;

  /** How many of them hold something; all where that is not known. */
  std::uint32_t UsedCount() const { return this->Used; }

  /** That the last assignment took, without what it waited for the device. */
  double Seconds() const { return this->TimeTaken; }

  LightBuffers Buffers;

private:
  void AssignTo(const DeferredGrid& grid, vtkOpenGLRenderer* renderer, const RendererLights& lights,
    std::vector<std::uint8_t>& marks);

  LightAssigner Assigner;
  std::optional<ViewGrid> Grid;
  LightLists OfGrid;
  std::vector<LightRectangle> Volumes;
  std::uint32_t Used = 0;
  double TimeTaken = 0.0;
};

}

#endif
