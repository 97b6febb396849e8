/** The rays through a renderer's pixels. */
#ifndef VITRINE_INSPECTION_PIXEL_RAYS_H
#define VITRINE_INSPECTION_PIXEL_RAYS_H

#include "Core/geometry/PixelRegion.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

class vtkRenderer;

namespace vitrine
{

/**
 * Converts between world coordinates (WC) and the window's pixels, in 64-bit float, by the matrices that the renderer
 * draws with. A place in the window is x and y in pixels, with centres of pixels at + 0.5, and the depth in [0, 1].
 */
class PixelRays
{
public:
  explicit PixelRays(vtkRenderer* renderer);

  /** The viewport of the renderer, in pixels. */
  const PixelRegion& Viewport() const { return this->Pixels; }

  const glm::dmat4& ToClip() const { return this->WorldToClip; }

  /** Returns a place in the window in normalised device coordinates, from -1 to 1. */
  glm::dvec3 ToDevice(const glm::dvec3& inWindow) const;

  glm::dvec3 ToWorld(const glm::dvec3& inWindow) const;
  glm::dvec3 ToWindow(const glm::dvec3& inWorld) const;

  /**
   * Returns the distance of a place along its ray, in units of the world: from the eye, or in parallel projection from
   * the near plane.
   */
  double Distance(const glm::dvec3& inWindow) const;

private:
  PixelRegion Pixels;
  glm::dmat4 WorldToClip;
  glm::dmat4 ClipToWorld;
  bool HasEye;
  glm::dvec3 Eye{ 0.0 };
};

}

#endif
