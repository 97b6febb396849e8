/**
 * Views with lights in them, and which lights reach a point by VTK's own formula.
 */
#ifndef VITRINE_LIGHT_SCENES_H
#define VITRINE_LIGHT_SCENES_H

#include "Core/lighting/ClusterGrid.h"
#include "Core/lighting/LightVolume.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <random>
#include <vector>

namespace light_scenes
{

inline double UniformIn(std::mt19937& random, double low, double high)
{
  return low + (high - low) * (random() / 4294967296.0);
}

inline glm::vec3 RandomDirection(std::mt19937& random)
{
  for (;;)
  {
    const double x = UniformIn(random, -1, 1), y = UniformIn(random, -1, 1);
    const glm::dvec3 v(x, y, UniformIn(random, -1, 1));
    const double length = glm::length(v);
    if (length > 0.1 && length <= 1.0)
    {
      return glm::vec3(v / length);
    }
  }
}

/** In doubles; a shader, in floats, finds the same but for its rounding. */
inline bool LightReaches(const vitrine::LightVolume& light, const glm::dvec3& point)
{
  const glm::dvec3 away = point - glm::dvec3(light.Position);
  const double distance = glm::length(away);
  if (distance > light.Range)
  {
    return false;
  }
  const double cosine = std::cos(glm::radians(static_cast<double>(light.ConeAngle)));
  return !(light.ConeAngle < 90.0f) || glm::dot(away / distance, glm::dvec3(light.Axis)) >= cosine;
}

struct LitView
{
  const char* Name;
  glm::dmat4 ToClip;
  int Width;
  int Height;
  double Near;
  double Far;
};

/** A window of `tiles` a side, of which one is drawn, as of VTK's tiled displays. */
inline glm::dmat4 TiledView(const glm::dmat4& toClip, double tiles, double x, double y)
{
  const glm::dmat4 scaled = glm::scale(glm::dmat4(1.0), glm::dvec3(tiles, tiles, 1.0));
  const glm::dmat4 moved =
    glm::translate(glm::dmat4(1.0), glm::dvec3(tiles - 1.0 - 2.0 * x, tiles - 1.0 - 2.0 * y, 0.0));
  return moved * scaled * toClip;
}

inline std::vector<LitView> AllLitViews()
{
  const auto perspective = [](double angle, double aspect, double near, double far)
  { return glm::perspective(glm::radians(angle), aspect, near, far); };
  return {
    { "perspective", perspective(60, 16.0 / 9, 0.5, 50), 640, 360, 0.5, 50 },
    { "wide", perspective(150, 1, 0.1, 20), 500, 500, 0.1, 20 },
    { "narrow", perspective(1, 1, 10, 100), 300, 300, 10, 100 },
    { "deep", perspective(40, 1.5, 1e-3, 1e3), 300, 200, 1e-3, 1e3 },
    { "off-axis", glm::frustum(0.1, 0.5, -0.3, -0.05, 0.4, 40.0), 400, 250, 0.4, 40 },
    { "tile", TiledView(perspective(60, 1, 0.5, 50), 4, 3, 0), 320, 320, 0.5, 50 },
    { "rolled",
      glm::rotate(glm::dmat4(1.0), 0.5, glm::dvec3(0, 0, 1)) * perspective(60, 1.3, 0.5, 50), 400,
      300, 0.5, 50 },
    { "parallel", glm::ortho(-4.0, 4.0, -3.0, 3.0, 1.0, 30.0), 400, 300, 1, 30 },
    { "parallel, near behind", glm::ortho(-4.0, 4.0, -3.0, 3.0, -10.0, 10.0), 400, 300, -10, 10 },
    { "parallel, off-axis", glm::ortho(1.0, 9.0, -7.0, -1.0, 0.0, 30.0), 400, 300, 0, 30 },
    { "one pixel", perspective(60, 1, 0.5, 50), 1, 1, 0.5, 50 },
    { "thin", perspective(60, 700, 0.5, 50), 700, 1, 0.5, 50 },
  };
}

/** A point that is seen, at a distance that lies anywhere between near and far in scale, too. */
inline glm::dvec3 PointSeen(const LitView& view, std::mt19937& random)
{
  const double share = UniformIn(random, 0, 1);
  const double depth = random() % 2 == 0 && view.Near > 0
    ? view.Near * std::pow(view.Far / view.Near, share)
    : view.Near + (view.Far - view.Near) * share;
  const glm::dvec4 clip = view.ToClip * glm::dvec4(0, 0, -depth, 1);
  const double x = UniformIn(random, -1, 1), y = UniformIn(random, -1, 1);
  const glm::dvec4 point = glm::inverse(view.ToClip) * glm::dvec4(x, y, clip.z / clip.w, 1.0);
  return glm::dvec3(point) / point.w;
}

/** Lights in what is seen, beside, behind and before it; cones of all angles; ranges of all sizes. */
inline std::vector<vitrine::LightVolume> RandomLights(
  const LitView& view, std::size_t count, std::mt19937& random)
{
  std::vector<vitrine::LightVolume> lights;
  for (std::size_t i = 0; i < count; ++i)
  {
    vitrine::LightVolume light;
    const glm::dvec3 seen = PointSeen(view, random);
    const double size = glm::length(seen);
    light.Range = static_cast<float>(size * std::pow(10.0, UniformIn(random, -3, 0.5)));
    const double aside = random() % 3 == 0 ? size : 0.7 * light.Range;
    light.Position = glm::vec3(seen + aside * glm::dvec3(RandomDirection(random)));
    light.Axis = RandomDirection(random);
    const float angles[] = { 180, 90, 89, 60, 30, 5, 0.1f };
    light.ConeAngle = angles[random() % 7];
    if (random() % 20 == 0)
    {
      light.Range = std::numeric_limits<float>::infinity();
    }
    lights.push_back(light);
  }
  return lights;
}

/** Whether a point of view coordinates is drawn. */
inline bool IsSeen(const LitView& view, const glm::dvec3& point)
{
  const glm::dvec4 clip = view.ToClip * glm::dvec4(point, 1.0);
  return clip.w > 0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w &&
    std::abs(clip.z) <= clip.w;
}

/** A view that is easy to reckon with: what is seen at distance d is 2d wide and 2d high. */
inline LitView SquareView(double near = 1.0, double far = 100.0, int size = 512)
{
  return { "square", glm::perspective(glm::radians(90.0), 1.0, near, far), size, size, near, far };
}

}

#endif
