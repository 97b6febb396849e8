#include "inspection/PixelRays.h"

#include "scene/Matrices.h"
#include "scene/ViewMatrices.h"

#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <cmath>

namespace vitrine
{
namespace
{

PixelRegion ViewportOf(vtkRenderer* renderer)
{
  PixelRegion region;
  renderer->GetTiledSizeAndOrigin(&region.Width, &region.Height, &region.X, &region.Y);
  return region;
}

glm::dmat4 WorldToClipOf(vtkRenderer* renderer)
{
  const ViewMatrices matrices = ViewMatricesOf(renderer);
  return MatrixOf(matrices.data() + 16) * MatrixOf(matrices.data());
}
}

PixelRays::PixelRays(vtkRenderer* renderer)
  : Pixels(ViewportOf(renderer))
  , WorldToClip(WorldToClipOf(renderer))
  , ClipToWorld(glm::inverse(this->WorldToClip))
{
  // All rays of a perspective projection meet where x, y and w are 0.
  const glm::dvec4 eye = this->ClipToWorld * glm::dvec4(0.0, 0.0, 1.0, 0.0);
  this->HasEye = std::abs(eye.w) > 1e-12 * glm::length(glm::dvec3(eye));
  if (this->HasEye)
  {
    this->Eye = glm::dvec3(eye) / eye.w;
  }
}

glm::dvec3 PixelRays::ToDevice(const glm::dvec3& inWindow) const
{
  return { 2.0 * (inWindow.x - this->Pixels.X) / this->Pixels.Width - 1.0,
    2.0 * (inWindow.y - this->Pixels.Y) / this->Pixels.Height - 1.0, 2.0 * inWindow.z - 1.0 };
}

glm::dvec3 PixelRays::ToWorld(const glm::dvec3& inWindow) const
{
  const glm::dvec4 place = this->ClipToWorld * glm::dvec4(this->ToDevice(inWindow), 1.0);
  return glm::dvec3(place) / place.w;
}

glm::dvec3 PixelRays::ToWindow(const glm::dvec3& inWorld) const
{
  const glm::dvec4 clip = this->WorldToClip * glm::dvec4(inWorld, 1.0);
  const glm::dvec3 device = glm::dvec3(clip) / clip.w;
  return { this->Pixels.X + 0.5 * (device.x + 1.0) * this->Pixels.Width,
    this->Pixels.Y + 0.5 * (device.y + 1.0) * this->Pixels.Height, 0.5 * (device.z + 1.0) };
}

double PixelRays::Distance(const glm::dvec3& inWindow) const
{
  const glm::dvec3 from = this->HasEye ? this->Eye : this->ToWorld({ inWindow.x, inWindow.y, 0.0 });
  return glm::distance(from, this->ToWorld(inWindow));
}

}
