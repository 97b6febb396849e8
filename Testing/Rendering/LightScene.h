/**
 * A few spheres before a wall, in the light of what a test puts there.
 */
#ifndef VITRINE_TESTING_LIGHT_SCENE_H
#define VITRINE_TESTING_LIGHT_SCENE_H

#include "TestScene.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkClusteredLightsPass.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkPrefixSumTransparencyPass.h"
#include "vtkProperty.h"
#include "vtkSeeThroughPass.h"
#include "vtkTranslucentPass.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

enum class LightKind
{
  Point,
  Spot,
  Directional,
  Camera, ///< positional, moves with the camera
  Headlight
};

constexpr std::array<LightKind, 5> AllLightKinds = { LightKind::Point, LightKind::Spot,
  LightKind::Directional, LightKind::Camera, LightKind::Headlight };

/** How a LightScene is seen, and of which materials it is. */
struct LightSettings
{
  bool IsParallel;
  bool IsPhysical;
  int Multisamples;
};

/** Any two settings in all their combinations. */
constexpr std::array<LightSettings, 4> PairsOfLightSettings = { { { true, false, 0 },
  { false, false, 4 }, { false, true, 0 }, { true, true, 4 } } };

inline std::string NameOfLightSettings(const testing::TestParamInfo<LightSettings>& info)
{
  return std::string(info.param.IsParallel ? "Parallel" : "Perspective") +
    (info.param.IsPhysical ? "Physical" : "Phong") +
    (info.param.Multisamples > 0 ? "Of4Samples" : "");
}

/** Passes for translucent geometry besides that of LightScene::Steps. */
inline std::vector<vtkSmartPointer<vtkRenderPass>> OtherTranslucentPasses()
{
  vtkNew<vtkOrderIndependentTranslucentPass> average;
  vtkNew<vtkTranslucentPass> geometry;
  average->SetTranslucentPass(geometry);
  return { vtkNew<vtkPrefixSumTransparencyPass>(), average, geometry };
}

struct LightScene : TestScene
{
  explicit LightScene(bool isParallel = true, bool isPhysical = false, int multisamples = 0)
    : TestScene(61, 47, multisamples)
  {
    for (int i = 0; i < 5; ++i)
    {
      const double opacity = i % 2 == 0 ? 1.0 : 0.5;
      const auto sphere = this->AddSphere(
        0.4 * i - 0.8, 0.3 * (i % 3) - 0.3, 0.1 * i, 0.35, { 0.9, 0.8, 0.7, opacity });
      sphere->GetProperty()->SetSpecular(0.4);
      sphere->GetProperty()->SetSpecularPower(20.0);
      this->Parts.push_back(sphere);
    }
    const auto wall = this->AddRectangle(-3.0, -3.0, 3.0, 3.0, -0.5, { 0.8, 0.8, 0.8, 1.0 });
    wall->GetProperty()->LightingOn();
    this->Parts.push_back(wall);
    for (const auto& part : this->Parts)
    {
      isPhysical ? part->GetProperty()->SetInterpolationToPBR()
                 : part->GetProperty()->SetInterpolationToPhong();
      part->GetProperty()->SetRoughness(0.6);
    }
    if (!isParallel)
    {
      vtkCamera* const camera = this->Renderer->GetActiveCamera();
      camera->ParallelProjectionOff();
      camera->SetPosition(0.4, 0.5, 3.0);
      camera->SetClippingRange(1.0, 5.0);
    }
    this->Renderer->AutomaticLightCreationOff();
    this->Lights->SetDelegatePass(this->Steps);
    this->Lights->SetTileSize(16);
    this->Lights->SetCutOff(0.0);
  }

  /** Somewhere in front of the wall; what reaches a point falls to a half at a distance of 1 / sqrt(`steepness`). */
  vtkSmartPointer<vtkLight> AddLight(LightKind kind, double strength = 0.5, double steepness = 4.0)
  {
    const auto between = [&](double low, double high)
    { return low + (high - low) * this->Random.Unit(); };
    auto light = vtkSmartPointer<vtkLight>::New();
    kind == LightKind::Headlight  ? light->SetLightTypeToHeadlight()
      : kind == LightKind::Camera ? light->SetLightTypeToCameraLight()
                                  : light->SetLightTypeToSceneLight();
    const std::array<double, 3> place = { between(-1.2, 1.2), between(-1.0, 1.0),
      between(-0.3, 0.9) };
    light->SetPosition(place[0], place[1], place[2]);
    light->SetFocalPoint(place[0] + between(-0.2, 0.2), place[1] + between(-0.2, 0.2), -0.5);
    light->SetPositional(
      kind == LightKind::Point || kind == LightKind::Spot || kind == LightKind::Camera);
    light->SetConeAngle(kind == LightKind::Spot ? between(15.0, 60.0) : 180.0);
    light->SetExponent(kind == LightKind::Spot ? 2.0 : 1.0);
    light->SetAttenuationValues(1.0, 0.0, steepness);
    light->SetDiffuseColor(this->Random.Unit(), this->Random.Unit(), this->Random.Unit());
    light->SetIntensity(strength);
    this->Renderer->AddLight(light);
    return light;
  }

  /** Two of each kind, one that is off, and one that takes light away: 11 that are on. */
  void AddLightsOfAllKinds()
  {
    for (int i = 0; i < 2; ++i)
    {
      for (const LightKind kind : AllLightKinds)
      {
        this->AddLight(kind, 0.3);
      }
    }
    this->AddLight(LightKind::Point)->SwitchOff();
    this->AddLight(LightKind::Spot, -0.2);
  }

  /** Two directional ones and a headlight. */
  void AddDirectionalLights()
  {
    this->AddLight(LightKind::Directional, 0.3);
    this->AddLight(LightKind::Directional, 0.3);
    this->AddLight(LightKind::Headlight, 0.3);
  }

  /** The frame as VTK lights it, with the same transparency. */
  Picture InVTKsLight()
  {
    this->Renderer->SetPass(this->Steps);
    return this->Render();
  }

  Picture InClusteredLight()
  {
    this->Renderer->SetPass(this->Lights);
    return this->Render();
  }

  /** By cubes of the world, in place of clusters of the view. */
  Picture InWorldsLight()
  {
    this->Lights->SetGridSpace(vtkClusteredLightsPass::WORLD);
    const Picture picture = this->InClusteredLight();
    this->Lights->SetGridSpace(vtkClusteredLightsPass::VIEW);
    return picture;
  }

  std::vector<vtkSmartPointer<vtkActor>>
    Parts; ///< spheres, of which every other one is translucent, and the wall
  vtkNew<vtkSeeThroughPass> Steps;
  vtkNew<vtkClusteredLightsPass> Lights;
  TestRandom Random = TestRandom(7);
};

#endif
