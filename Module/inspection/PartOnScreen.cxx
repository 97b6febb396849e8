#include "inspection/PartOnScreen.h"

#include "scene/Matrices.h"

#include "vtkActor.h"
#include "vtkDataSet.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine
{
namespace
{

std::optional<BoxCorners> CornersOfBounds(const double* bounds)
{
  if (!bounds || !vtkMath::AreBoundsInitialized(bounds))
  {
    return std::nullopt;
  }
  BoxCorners corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    corners[i] = { bounds[i & 1], bounds[2 + (i >> 1 & 1)], bounds[4 + (i >> 2)] };
  }
  return corners;
}
}

std::optional<BoxCorners> CornersOf(vtkProp* prop)
{
  return CornersOfBounds(prop->GetBounds());
}

std::optional<BoxCorners> CornersOfBlock(vtkActor* actor, vtkDataObject* data)
{
  auto* const set = vtkDataSet::SafeDownCast(data);
  std::optional<BoxCorners> corners =
    set ? CornersOfBounds(set->GetBounds()) : std::optional<BoxCorners>();
  if (corners)
  {
    const glm::dmat4 place = MatrixOf(actor->GetMatrix()->GetData());
    for (glm::dvec3& corner : *corners)
    {
      corner = glm::dvec3(place * glm::dvec4(corner, 1.0));
    }
  }
  return corners;
}

PixelRegion RegionOf(const BoxCorners& corners, const PixelRays& rays, int margin)
{
  const PixelRegion& all = rays.Viewport();
  glm::dvec2 least(std::numeric_limits<double>::infinity());
  glm::dvec2 most = -least;
  for (const glm::dvec3& corner : corners)
  {
    if (!((rays.ToClip() * glm::dvec4(corner, 1.0)).w > 0.0))
    {
      return all;
    }
    const glm::dvec2 place(rays.ToWindow(corner));
    least = glm::min(least, place);
    most = glm::max(most, place);
  }
  const auto pixel = [](double at, int low, int high)
  { return static_cast<int>(std::clamp<double>(std::floor(at), low, high)); };
  const int left = pixel(least.x - margin, all.X, all.X + all.Width);
  const int right = pixel(most.x + margin + 1.0, all.X, all.X + all.Width);
  const int bottom = pixel(least.y - margin, all.Y, all.Y + all.Height);
  const int top = pixel(most.y + margin + 1.0, all.Y, all.Y + all.Height);
  return { left, bottom, right - left, top - bottom };
}

}
