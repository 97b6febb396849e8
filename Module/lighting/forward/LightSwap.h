/**
 * Replaces all lights of a renderer by one stand-in light. VTK's mappers then write their text for one light, whatever
 * the number of lights.
 */
#ifndef VITRINE_LIGHTING_FORWARD_LIGHT_SWAP_H
#define VITRINE_LIGHTING_FORWARD_LIGHT_SWAP_H

#include "vtkLightCollection.h"
#include "vtkSmartPointer.h"

class vtkRenderer;
class vtkRenderPass;

namespace vitrine
{

/** Returns a collection with one light, positional or not. */
vtkSmartPointer<vtkLightCollection> MakeStandIn(bool isPositional);

/** Returns true if MakeStandIn() made the collection. */
bool IsStandIn(vtkLightCollection* lights);

/**
 * Replaces a renderer's collection of lights during its lifetime. Lights that are added meanwhile end up in the
 * renderer's own collection.
 */
class ScopedLights
{
public:
  ScopedLights(vtkRenderer* renderer, vtkLightCollection* lights);
  ~ScopedLights();
  ScopedLights(const ScopedLights&) = delete;
  void operator=(const ScopedLights&) = delete;

private:
  vtkRenderer* Renderer;
  vtkSmartPointer<vtkLightCollection> Before;
  vtkSmartPointer<vtkLightCollection> Meanwhile;
  int Count; ///< number of lights in Meanwhile at the start
};

/**
 * Gives the volumetric pass of a vtkRenderStepsPass the real lights during its lifetime, since volumes look up lights
 * themselves. Other passes are not changed.
 */
class ScopedVolumeLights
{
public:
  ScopedVolumeLights(vtkRenderPass* pass, vtkLightCollection* lights);
  ~ScopedVolumeLights();
  ScopedVolumeLights(const ScopedVolumeLights&) = delete;
  void operator=(const ScopedVolumeLights&) = delete;

private:
  vtkRenderPass* Pass;
  vtkSmartPointer<vtkRenderPass> Before;
};

}

#endif
