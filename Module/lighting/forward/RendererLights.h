/**
 * Collects a renderer's lights for shaders and for the light grid.
 */
#ifndef VITRINE_LIGHTING_FORWARD_RENDERER_LIGHTS_H
#define VITRINE_LIGHTING_FORWARD_RENDERER_LIGHTS_H

#include "Core/lighting/LightFalloff.h"
#include "Core/lighting/LightVolume.h"
#include "Shaders/SharedLayout.h"

#include <string>
#include <vector>

class vtkLightCollection;
class vtkOpenGLRenderer;
class vtkRenderer;

namespace vitrine
{

/** The lighting formulas of VTK's mappers. */
enum class LightFormula
{
  None,        ///< no light is on
  Headlight,   ///< a single headlight: a shorter formula with different rounding
  Directional, ///< no light is positional
  Positional
};

/** Returns the formula that VTK selects for a collection of lights. */
LightFormula FormulaOf(vtkLightCollection* lights);

/** Returns the renderer's collection of lights. Assigning it does not mark the renderer as modified. */
vtkLightCollection*& LightsOf(vtkRenderer* renderer);

/** The lights that are on, in view coordinates (VC), in the order in which VTK adds them up. */
struct RendererLights
{
  std::vector<VitrineLight> Packed;
  std::vector<LightFalloff> Falloffs;
  std::vector<LightVolume> Volumes; ///< with infinite ranges
  /** Numbers of lights that are left out because they would turn everything black. Empty if there are none. */
  std::string Left;

  /** Takes the lights as VTK's renderer passes them to shaders. The camera must be up to date. */
  void Take(vtkOpenGLRenderer* renderer);

  /** Copies the ranges of Volumes to Packed. Call it after the ranges have been set. */
  void TakeRanges();
};

}

#endif
