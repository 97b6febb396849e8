/**
 * Replaces all lights of a renderer by one stand-in light. VTK's mappers then write their text for one light, whatever
 * the number of lights.
 */
#ifndef VITRINE_LIGHTING_FORWARD_LIGHT_SWAP_H
#define VITRINE_LIGHTING_FORWARD_LIGHT_SWAP_H

#include "vtkLightCollection.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkRenderer;
class vtkRenderPass;
class vtkSequencePass;

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
 * Gives the real lights to the volumetric passes below a pass during its lifetime, since volumes look up lights
 * themselves. It knows those of vtkRenderStepsPass, vtkDualDepthPeelingPass and vtkSequencePass.
 */
class ScopedVolumeLights
{
public:
  ScopedVolumeLights(vtkRenderPass* pass, vtkLightCollection* lights);
  ~ScopedVolumeLights();
  ScopedVolumeLights(const ScopedVolumeLights&) = delete;
  void operator=(const ScopedVolumeLights&) = delete;

private:
  void GiveLights(vtkRenderPass* parent, vtkLightCollection* lights);
  template <class Parent>
  void GiveLightsToStep(Parent* parent, vtkLightCollection* lights);
  void GiveLightsInSequence(vtkSequencePass* sequence, vtkLightCollection* lights);

  /** Functions in the order of the changes that they undo. */
  std::vector<std::function<void()>> Undo;
};

}

#endif
