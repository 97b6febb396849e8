/**
 * Lights of a scene.
 */
#ifndef VITRINE_PROGRAM_LIGHTS_H
#define VITRINE_PROGRAM_LIGHTS_H

#include <array>
#include <cstddef>
#include <vector>

class vtkRenderer;

namespace program
{

/** A light at a place, with the meaning that vtkLight gives to each number. */
struct Light
{
  std::array<double, 3> Position;
  std::array<double, 3> Direction = { 0.0, -1.0, 0.0 }; ///< of a spot light
  std::array<double, 3> Color = { 1.0, 1.0, 1.0 };
  double Intensity = 1.0;
  std::array<double, 3> Attenuation = { 1.0, 0.0, 0.0 }; ///< a, b, c of 1 / (a + b d + c d^2)
  double ConeAngle = 90.0; ///< degrees from the axis of a spot light; 90 lights all around
  double Exponent = 1.0;   ///< of the cosine from the axis; spot lights only
};

/** The most that can be asked for. */
inline constexpr int MostLights = 1048576;

/**
 * The most lights that VTK's own shaders may draw. 64 take seconds to compile, 1,024 take minutes, and more end the
 * program.
 */
inline constexpr std::size_t MostLightsOfVTK = 64;

/** Have the renderer be lit by these alone; by the headlight that VTK makes if there are none. */
void SetLights(const std::vector<Light>& lights, vtkRenderer* renderer);

}
#endif
