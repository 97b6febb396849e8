/**
 * Assigns lights to the pixels of a G-buffer.
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

/** The unit that lights are assigned to. */
enum class LightsBy
{
  Volume, ///< a rectangle of the picture for each light
  Tile,
  Cluster
};

struct DeferredGrid
{
  LightsBy By = LightsBy::Cluster;
  ClusterSettings Clusters;
  /** Largest distance in pixels between a pixel and the projection of the point that it shows. */
  double PixelsAside = 0.0;
};

class DeferredLists
{
public:
  /** Returns the marks of a grid's clusters that contain something. It returns an empty vector if that is not known. */
  using FindMarks = std::function<std::vector<std::uint8_t>(const ViewGrid&)>;

  /** Assigns lights and writes the buffers. Returns an empty string, or why the driver cannot hold the lists. */
  std::string Assign(vtkOpenGLRenderer* renderer, const DeferredGrid& grid,
    const RendererLights& lights, const FindMarks& findMarks);

  /** Returns the lists by tile or cluster. */
  const LightLists& Lists() const { return this->OfGrid; }
  const ViewGrid& Shown() const { return *this->Grid; }
  const ClusterGrid& Clusters() const { return this->Grid->Clusters(); }

  /**
   * For LightsBy::Volume: returns the rectangles of all lights that reach something, in the order of their numbers in
   * shaders.
   */
  const std::vector<LightRectangle>& Rectangles() const { return this->Volumes; }

  void SetUniforms(vtkShaderProgram* program) const;

  /** Returns the number of tiles or clusters that contain something, or of all of them if that is not known. */
  std::uint32_t UsedCount() const { return this->Used; }

  /** Returns the time of the last assignment in seconds, without waiting for the device. */
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
