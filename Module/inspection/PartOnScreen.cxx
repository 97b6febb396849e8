#include "inspection/PartOnScreen.h"

#include "scene/Matrices.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine
{
namespace
{

/** The number of a part's faces from which only some are looked at for its area. */
constexpr vtkIdType MostFaces = 256;

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

double AreaOnScreen(vtkActor* actor, vtkDataObject* data, const PixelRays& rays)
{
  auto* const surface = vtkPolyData::SafeDownCast(data);
  if (!surface || !surface->GetPolys() || !surface->GetPoints())
  {
    return 0.0;
  }
  const glm::dmat4 toClip = rays.ToClip() * MatrixOf(actor->GetMatrix()->GetData());
  const double pixels = 0.25 * rays.Viewport().Width * rays.Viewport().Height; // of the unit square
  const vtkIdType faces = surface->GetPolys()->GetNumberOfCells();
  const vtkIdType stride = std::max<vtkIdType>(1, faces / MostFaces);
  double area = 0.0;
  for (vtkIdType face = 0; face < faces; face += stride)
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    surface->GetPolys()->GetCellAtId(face, count, corners);
    const auto placeOf = [&](vtkIdType i)
    {
      double at[3];
      surface->GetPoint(corners[i], at);
      const glm::dvec4 clip = toClip * glm::dvec4(at[0], at[1], at[2], 1.0);
      return glm::dvec3(clip.x / clip.w, clip.y / clip.w, clip.w);
    };
    for (vtkIdType i = 2; i < count; ++i)
    {
      const glm::dvec3 a = placeOf(0);
      const glm::dvec3 b = placeOf(i - 1);
      const glm::dvec3 c = placeOf(i);
      const glm::dvec2 middle = glm::abs(glm::dvec2(a + b + c) / 3.0);
      if (a.z > 0.0 && b.z > 0.0 && c.z > 0.0 && middle.x < 1.0 && middle.y < 1.0)
      {
        const glm::dvec2 u(b - a);
        const glm::dvec2 v(c - a);
        area += 0.5 * std::abs(u.x * v.y - u.y * v.x);
      }
    }
  }
  return 0.5 * area * pixels * static_cast<double>(stride);
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
