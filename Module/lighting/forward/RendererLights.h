/**
 * A renderer's lights, as shaders and the light grid have them.
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

/** How VTK's mappers write their light. */
enum class LightFormula
{
  None,        ///< no light is on
  Headlight,   ///< one alone: a shorter formula, which rounds otherwise
  Directional, ///< none is positional
  Positional
};

/** What VTK makes of a renderer's lights. */
LightFormula FormulaOf(vtkLightCollection* lights);

/** The renderer's collection of lights, which can be replaced without that the renderer counts as modified. */
vtkLightCollection*& LightsOf(vtkRenderer* renderer);

/** Lights that are on, in view coordinates (VC), in the order in which VTK adds up what they give. */
struct RendererLights
{
  std::vector<VitrineLight> Packed;
  std::vector<LightFalloff> Falloffs;
  std::vector<LightVolume> Volumes; ///< their ranges are infinite
  std::string
    Left; ///< which lights are left out, as they would turn all that is lit black; empty if none is

  /** Takes them as VTK's renderer hands them to shaders, from a camera that is up to date. */
  void Take(vtkOpenGLRenderer* renderer);

  /** Tells shaders the ranges of the volumes, once they are known. */
  void TakeRanges();
};

}

#endif
