// Lights of deferred shading give VTK's picture to the bit.
#include "LightScene.h"
#include "TestMessages.h"
#include "vtkDeferredLightsPass.h"

#include <gtest/gtest.h>

namespace
{

struct DeferredSettings
{
  bool IsParallel;
  bool IsPhysical;
  int Multisamples;
};

std::string NameOf(const testing::TestParamInfo<DeferredSettings>& info)
{
  return std::string(info.param.IsParallel ? "Parallel" : "Perspective") +
    (info.param.IsPhysical ? "Physical" : "Phong") +
    (info.param.Multisamples > 0 ? "Of4Samples" : "");
}

struct DeferredScene : LightScene
{
  explicit DeferredScene(bool isParallel = true, bool isPhysical = false, int multisamples = 0)
    : LightScene(isParallel, isPhysical, multisamples)
  {
    this->Deferred->SetDelegatePass(this->Steps);
    this->Deferred->SetTileSize(16);
    this->Deferred->SetCutOff(0.0);
  }

  Picture InDeferredLight()
  {
    this->Renderer->SetPass(this->Deferred);
    return this->Render();
  }

  vtkNew<vtkDeferredLightsPass> Deferred;
};

class DeferredLights : public testing::TestWithParam<DeferredSettings>
{
protected:
  DeferredScene Scene{ GetParam().IsParallel, GetParam().IsPhysical, GetParam().Multisamples };

  void ExpectAsVTK()
  {
    const Picture expected = this->Scene.InVTKsLight();
    for (const int assignment : { vtkDeferredLightsPass::LIGHT_VOLUMES,
           vtkDeferredLightsPass::TILES, vtkDeferredLightsPass::CLUSTERS })
    {
      this->Scene.Deferred->SetAssignment(assignment);
      EXPECT_EQ(LargestDifference(expected, this->Scene.InDeferredLight()), 0) << assignment;
      EXPECT_EQ(this->Scene.Deferred->GetNumberOfDeferredProps(), 4);
    }
    this->Scene.Renderer->RemoveAllLights();
    EXPECT_GT(LargestDifference(expected, this->Scene.InVTKsLight()), 20); // there is light
  }
};

TEST_P(DeferredLights, OfAllKindsAreVTKs)
{
  for (int i = 0; i < 2; ++i)
  {
    for (const LightKind kind : { LightKind::Point, LightKind::Spot, LightKind::Directional,
           LightKind::Camera, LightKind::Headlight })
    {
      this->Scene.AddLight(kind, 0.3);
    }
  }
  this->Scene.AddLight(LightKind::Point)->SwitchOff();
  this->Scene.AddLight(LightKind::Spot, -0.2);
  this->ExpectAsVTK();
  EXPECT_EQ(this->Scene.Deferred->GetNumberOfLights(), 11);
}

TEST_P(DeferredLights, ThatAreOnlyDirectionalAreVTKs)
{
  this->Scene.AddLight(LightKind::Directional, 0.3);
  this->Scene.AddLight(LightKind::Directional, 0.3);
  this->Scene.AddLight(LightKind::Headlight, 0.3);
  this->ExpectAsVTK();
}

INSTANTIATE_TEST_SUITE_P(Settings, DeferredLights,
  testing::Values(DeferredSettings{ true, false, 0 }, DeferredSettings{ false, false, 4 },
    DeferredSettings{ false, true, 0 }, DeferredSettings{ true, true, 4 }),
  NameOf);

}
