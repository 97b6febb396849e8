/**
 * The scene of lights, lit from a G-buffer.
 */
#ifndef VITRINE_TESTING_DEFERRED_SCENE_H
#define VITRINE_TESTING_DEFERRED_SCENE_H

#include "LightScene.h"
#include "vtkDeferredLightsPass.h"

#include <array>

constexpr std::array<int, 3> DeferredAssignments = { vtkDeferredLightsPass::LIGHT_VOLUMES,
  vtkDeferredLightsPass::TILES, vtkDeferredLightsPass::CLUSTERS };

constexpr int DeferredParts = 4; ///< of a LightScene: those that are opaque

struct DeferredScene : LightScene
{
  explicit DeferredScene(bool isParallel = true, bool isPhysical = false, int multisamples = 0)
    : LightScene(isParallel, isPhysical, multisamples)
  {
    this->Deferred->SetDelegatePass(this->Steps);
    this->Deferred->SetTileSize(16);
    this->Deferred->SetCutOff(0.0);
  }

  void AddLights(int pairs)
  {
    for (int i = 0; i < pairs; ++i)
    {
      this->AddLight(LightKind::Point);
      this->AddLight(LightKind::Spot);
    }
  }

  Picture InDeferredLight()
  {
    this->Renderer->SetPass(this->Deferred);
    return this->Render();
  }

  /** Expects VTK's picture to the bit, whatever lights are assigned to, with so many props deferred. */
  void ExpectAsVTK(int deferred)
  {
    const Picture expected = this->InVTKsLight();
    for (const int assignment : DeferredAssignments)
    {
      this->Deferred->SetAssignment(assignment);
      EXPECT_TRUE(Matches(this->InDeferredLight(), expected)) << assignment;
      EXPECT_EQ(this->Deferred->GetNumberOfDeferredProps(), deferred) << assignment;
    }
  }

  vtkNew<vtkDeferredLightsPass> Deferred;
};

#endif
