/**
 * One light in place of all: VTK's mappers write their text for it, whatever the number of lights.
 */
#ifndef VITRINE_LIGHTING_FORWARD_LIGHT_SWAP_H
#define VITRINE_LIGHTING_FORWARD_LIGHT_SWAP_H

#include "vtkLightCollection.h"
#include "vtkSmartPointer.h"

class vtkRenderer;
class vtkRenderPass;

namespace vitrine
{

/** A collection of one light, positional or not. */
vtkSmartPointer<vtkLightCollection> MakeStandIn(bool isPositional);

/** Whether a collection is such a one. */
bool IsStandIn(vtkLightCollection* lights);

/** A renderer has another collection of lights while this lives. Lights that are added to it meanwhile come to the renderer's own. */
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
  int Count; ///< of the lights in it
};

/** Volumes look up lights themselves, so what draws them in a vtkRenderStepsPass has the real ones while this lives. Other passes stay as they are. */
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
