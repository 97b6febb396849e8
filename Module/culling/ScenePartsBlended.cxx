// Parts that may shine through props that VTK blends in its opaque pass.
#include "culling/SceneParts.h"

#include "Core/culling/screen/ScreenProjection.h"
#include "culling/PropPolicy.h"

#include "vtkMath.h"
#include "vtkProp.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <string>
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

/** Adds the rectangle of a prop, if it is in the view. A prop without bounds may be everywhere. */
void AddRectangleOf(vtkProp* prop, const glm::dvec3& origin, const ScreenProjection& view,
  std::vector<ScreenRectangle>& rectangles)
{
  const double* const bounds = prop->GetBounds();
  if (!bounds)
  {
    rectangles.push_back(Everywhere);
    return;
  }
  if (!vtkMath::AreBoundsInitialized(bounds))
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

bool SceneParts::BlendsAnywhere() const
{
  return std::any_of(this->Drawn.begin(), this->Drawn.end(),
    [&](std::uint32_t part) { return std::isinf(this->Blends[part].Beside); });
}

bool SceneParts::BlendsSomewhere() const
{
  return std::any_of(this->Drawn.begin(), this->Drawn.end(),
    [&](std::uint32_t part) { return this->Blends[part].MayBlend(); });
}

std::string SceneParts::DescribeBlended() const
{
  const auto found = std::max_element(this->Drawn.begin(), this->Drawn.end(),
    [&](std::uint32_t a, std::uint32_t b) { return this->Blends[a].IsLessThan(this->Blends[b]); });
  const Blending& blends = this->Blends[*found];
  const std::vector<PropRow>& rows = PropRows();
  const vtkProp* const prop = this->Living[*found]; // null if it was deleted after the frame
  return (prop ? std::string(prop->GetClassName()) : "a deleted prop") + ": " +
    rows[blends.Why].Condition +
    (blends.Anywhere == NoPropRow ? "" : std::string("; ") + rows[blends.Anywhere].Why);
}

void SceneParts::ShowBehindBlended(const SampleGrid& samples, const ScreenProjection& view,
  const std::vector<std::uint8_t>& drawn, std::vector<std::uint8_t>& visible) const
{
  const std::vector<BoxedPart> hidden = this->FindHiddenInView(view, samples, drawn, visible);
  if (hidden.empty())
  {
    return; // bounds take long, as they update pipelines
  }
  std::vector<ScreenRectangle> blended;
  float pixels = 0.0f;
  for (const std::uint32_t part : this->Drawn)
  {
    if (this->Blends[part].MayBlend())
    {
      pixels = std::max(pixels, this->Blends[part].Beside);
      AddRectangleOf(this->PropOf[part], this->Middle, view, blended);
    }
  }
  const float beside = pixels * samples.PixelSize();
  for (const BoxedPart& part : hidden)
  {
    const ScreenRectangle own = view.RectangleOf(part.Bounds).value_or(Everywhere);
    if (std::any_of(blended.begin(), blended.end(),
          [&](const ScreenRectangle& rectangle) { return Overlap(own, rectangle, beside); }))
    {
      visible[part.Part] = MayShineThrough;
    }
  }
}

}
