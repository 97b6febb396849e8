#include "inspection/PropsInRegion.h"

#include "inspection/PixelRays.h"
#include "scene/ActorRules.h"
#include "scene/VisibleBox.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkMath.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <optional>

namespace vitrine
{
namespace
{

/** Pixels by which lines and points of usual width, and rounding, may reach beyond the bounds of a prop. */
constexpr double Margin = 3.0;

/** Returns by how many pixels an actor's lines and points reach beyond its bounds. */
double MarginOf(vtkActor* actor)
{
  vtkProperty* const property = actor->GetProperty();
  return Margin +
    std::max<double>(std::max(property->GetLineWidth(), property->GetPointSize()), 0.0);
}

/** A pyramid of pixels, as four planes in clip coordinates. */
class Pyramid
{
public:
  Pyramid(const PixelRays& rays, const PixelRegion& region, double margin)
    : ToClip(rays.ToClip())
  {
    const glm::dvec3 least = rays.ToDevice({ region.X - margin, region.Y - margin, 0.0 });
    const glm::dvec3 most =
      rays.ToDevice({ region.X + region.Width + margin, region.Y + region.Height + margin, 0.0 });
    this->Planes = { glm::dvec4(1.0, 0.0, 0.0, -least.x), glm::dvec4(-1.0, 0.0, 0.0, most.x),
      glm::dvec4(0.0, 1.0, 0.0, -least.y), glm::dvec4(0.0, -1.0, 0.0, most.y) };
  }

  /** Returns false only if no point of the box is inside. */
  bool MayMeet(const Box& box) const
  {
    std::array<int, 4> outside{};
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec3 low(box.Min), high(box.Max);
      const glm::dvec4 at = this->ToClip *
        glm::dvec4((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
          (corner & 4) != 0 ? high.z : low.z, 1.0);
      for (std::size_t i = 0; i < 4; ++i)
      {
        outside[i] += glm::dot(this->Planes[i], at) < 0.0 ? 1 : 0;
      }
    }
    return std::none_of(outside.begin(), outside.end(), [](int count) { return count == 8; });
  }

private:
  glm::dmat4 ToClip;
  std::array<glm::dvec4, 4> Planes;
};
}

std::vector<vtkProp*> PropsIn(vtkRenderer* renderer, const PixelRegion& region)
{
  const PixelRays rays(renderer);
  std::vector<vtkProp*> found;
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator place;
  props->InitTraversal(place);
  while (vtkProp* const prop = props->GetNextProp(place))
  {
    if (!prop->GetVisibility() || vtkActor2D::SafeDownCast(prop) || vtkVolume::SafeDownCast(prop))
    {
      continue;
    }
    vtkActor* const known = AsHideable(prop);
    const std::optional<Box> box = known ? BoxAround(known) : std::nullopt;
    if (!known || (box && Pyramid(rays, region, MarginOf(known)).MayMeet(*box)))
    {
      found.push_back(prop);
    }
  }
  return found;
}

}
