// Parts that may shine through others which VTK blends among what is opaque.
#include "culling/SceneParts.h"

#include "Core/culling/ScreenProjection.h"
#include "culling/ActorRules.h"

#include "vtkActor.h"
#include "vtkMath.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <vector>

namespace vitrine
{

namespace
{

bool Overlap(const ScreenRectangle& a, const ScreenRectangle& b, float beside)
{
  return a.Left <= b.Right + beside && b.Left <= a.Right + beside && a.Bottom <= b.Top + beside &&
    b.Bottom <= a.Top + beside;
}

/** Where an actor is seen in the view, if it is; and how far beside that. */
void AddRectangleOf(vtkActor* actor, const glm::dvec3& origin, const ScreenProjection& view,
  std::vector<ScreenRectangle>& rectangles, float& beside)
{
  beside = std::max(beside,
    MostGrowthOf(actor)); // of those that cannot be hidden it is not known what a device rounds
  const double* const bounds = actor->GetBounds();
  if (!bounds || !vtkMath::AreBoundsInitialized(bounds))
  {
    return;
  }
  const glm::dvec3 least(bounds[0], bounds[2], bounds[4]);
  const glm::dvec3 greatest(bounds[1], bounds[3], bounds[5]);
  if (const auto rectangle = view.RectangleOf(Box::Around(least - origin, greatest - origin)))
  {
    rectangles.push_back(*rectangle);
  }
}
}

void SceneParts::ShowBehindBlended(const SampleGrid& samples, const ScreenProjection& view,
  const std::vector<std::uint8_t>& drawn, std::vector<std::uint8_t>& visible) const
{
  std::vector<ScreenRectangle> blended;
  float pixels = 0.0f;
  for (const std::uint32_t part : this->Drawn)
  {
    if (this->Blends[part])
    {
      AddRectangleOf(
        static_cast<vtkActor*>(this->PropOf[part]), this->Middle, view, blended, pixels);
    }
  }
  if (blended.empty())
  {
    return;
  }
  const float beside = pixels * samples.PixelSize();
  for (const BoxedPart& part : this->FindHiddenInView(view, samples, drawn, visible))
  {
    const ScreenRectangle own = view.RectangleOf(part.Bounds).value_or(Everywhere);
    visible[part.Part] = std::any_of(blended.begin(), blended.end(),
      [&](const ScreenRectangle& rectangle) { return Overlap(own, rectangle, beside); });
  }
}

}
