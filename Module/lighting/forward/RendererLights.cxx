#include "lighting/forward/RendererLights.h"

#include "Core/lighting/FloatSlack.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderer.h"
#include "vtkTransform.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vitrine
{

namespace
{
using Triple = std::array<double, 3>;

/** Accesses a protected member of any renderer. */
class AnyRenderer : public vtkRenderer
{
public:
  static vtkLightCollection*& LightsIn(vtkRenderer* renderer)
  {
    return renderer->*(&AnyRenderer::Lights);
  }
};

/** A light's position and direction in view coordinates. */
struct Placed
{
  Triple Position;
  Triple Direction;
};

Placed PlaceOf(vtkLight* light, vtkOpenGLRenderer* renderer)
{
  const double* const target = light->GetTransformedFocalPoint();
  const Triple focus = { target[0], target[1], target[2] };
  const double* const from = light->GetTransformedPosition();
  const Triple position = { from[0], from[1], from[2] };
  Triple direction;
  vtkMath::Subtract(focus.data(), position.data(), direction.data());
  vtkMath::Normalize(direction.data());
  vtkTransform* const toView = renderer->GetActiveCamera()->GetModelViewTransformObject();
  Placed placed;
  toView->TransformNormal(direction.data(), placed.Direction.data());
  toView->TransformPoint(position.data(), placed.Position.data());
  vtkTransform* const users =
    light->LightTypeIsSceneLight() ? nullptr : renderer->GetUserLightTransform();
  if (users)
  {
    users->TransformNormal(placed.Direction.data(), placed.Direction.data());
    users->TransformPoint(placed.Position.data(), placed.Position.data());
  }
  return placed;
}

template <class From>
void Put(const From& from, float (&to)[3])
{
  std::transform(
    &from[0], &from[0] + 3, to, [](double value) { return static_cast<float>(value); });
}

bool IsPositional(const VitrineLight& packed)
{
  return packed.SquaredRange >= 0.0f;
}

// Returns a lower bound of VTK's cosine for points within the cone, or 0 without a cone. VTK does not normalize the
// direction and tests the cone only below 90 degrees. The slack covers the rounding of VTK's floats.
float LeastCosineOf(const VitrineLight& packed)
{
  if (!IsPositional(packed) || !(packed.ConeAngle < 90.0f))
  {
    return 0.0f;
  }
  const double length = glm::length(glm::dvec3(glm::make_vec3(packed.Direction)));
  const double slack = 2.0 * CosineSlack * std::max(1.0, length);
  return static_cast<float>(std::cos(glm::radians(static_cast<double>(packed.ConeAngle))) - slack);
}

VitrineLight Pack(vtkLight* light, const Placed& placed)
{
  VitrineLight packed{};
  const double* const color = light->GetDiffuseColor();
  const double intensity = light->GetIntensity();
  Put(Triple{ color[0] * intensity, color[1] * intensity, color[2] * intensity }, packed.Color);
  Put(placed.Direction, packed.Direction);
  Put(placed.Position, packed.Position);
  Put(light->GetAttenuationValues(), packed.Attenuation);
  packed.ConeAngle = static_cast<float>(light->GetConeAngle());
  packed.Exponent = static_cast<float>(light->GetExponent());
  packed.SquaredRange = light->GetPositional() ? std::numeric_limits<float>::max() : -1.0f;
  packed.LeastCosine = LeastCosineOf(packed);
  return packed;
}

LightFalloff FalloffOf(vtkLight* light)
{
  // A light that is not positional has no attenuation.
  return LightFalloff(glm::make_vec3(light->GetDiffuseColor()), light->GetIntensity(),
    light->GetPositional() ? glm::dvec3(glm::make_vec3(light->GetAttenuationValues()))
                           : glm::dvec3(1.0, 0.0, 0.0));
}

LightVolume VolumeOf(const VitrineLight& packed)
{
  LightVolume volume;
  volume.Position = glm::make_vec3(packed.Position);
  volume.Axis = glm::make_vec3(packed.Direction);
  // Other lights keep the default, which shines in all directions.
  if (IsPositional(packed))
  {
    volume.ConeAngle = packed.ConeAngle;
  }
  return volume;
}

bool IsFinite(const VitrineLight& packed)
{
  const float* const numbers = packed.Position;
  return std::all_of(numbers, numbers + sizeof(packed) / sizeof(float),
    [](float number) { return std::isfinite(number); });
}
}

vtkLightCollection*& LightsOf(vtkRenderer* renderer)
{
  return AnyRenderer::LightsIn(renderer);
}

LightFormula FormulaOf(vtkLightCollection* lights)
{
  int count = 0;
  bool isPositional = false, isHeadlight = true;
  vtkCollectionSimpleIterator i;
  for (lights->InitTraversal(i); vtkLight* light = lights->GetNextLight(i);)
  {
    count += light->GetSwitch() ? 1 : 0;
    isHeadlight &= light->GetSwitch() && light->LightTypeIsHeadlight();
    isPositional |= light->GetPositional() != 0; // VTK also counts lights that are off
  }
  if (count == 0)
  {
    return LightFormula::None;
  }
  return isPositional           ? LightFormula::Positional
    : count > 1 || !isHeadlight ? LightFormula::Directional
                                : LightFormula::Headlight;
}

void RendererLights::TakeRanges()
{
  for (std::size_t i = 0; i < this->Packed.size(); ++i)
  {
    if (IsPositional(this->Packed[i]))
    {
      const float range = LightShape(this->Volumes[i]).Range;
      this->Packed[i].SquaredRange = range * range;
    }
  }
}

void RendererLights::Take(vtkOpenGLRenderer* renderer)
{
  *this = {};
  vtkLightCollection* const lights = LightsOf(renderer);
  vtkCollectionSimpleIterator i;
  int number = 0;
  for (lights->InitTraversal(i); vtkLight* light = lights->GetNextLight(i); ++number)
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    const VitrineLight packed = Pack(light, PlaceOf(light, renderer));
    const LightFalloff falloff = FalloffOf(light);
    if (!IsFinite(packed) || falloff.IsDegenerate())
    {
      this->Left += (this->Left.empty() ? "" : ", ") + std::to_string(number);
      continue;
    }
    this->Packed.push_back(packed);
    this->Falloffs.push_back(falloff);
    this->Volumes.push_back(VolumeOf(packed));
  }
}

}
