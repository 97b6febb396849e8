/**
 * The scene of lights, in which all passes are held to VTK's picture at once.
 */
#ifndef VITRINE_TESTING_STABLE_SCENE_H
#define VITRINE_TESTING_STABLE_SCENE_H

#include "DeferredScene.h"
#include "vtkLightCollection.h"

#include <cmath>

using Place = std::array<double, 3>;

/** A positional light, from one place towards another. What is not a spot light shines all around. */
struct Beam
{
  Place From;
  Place To;
  double Angle = 180.0;
  double Steepness = 0.0;
};

struct StableScene : DeferredScene
{
  explicit StableScene(bool isParallel = false, bool isPhysical = false)
    : DeferredScene(isParallel, isPhysical)
  {
  }

  vtkCamera* Camera() { return this->Renderer->GetActiveCamera(); }

  void SetCutOff(double cutOff)
  {
    this->Lights->SetCutOff(cutOff);
    this->Deferred->SetCutOff(cutOff);
  }

  void SetGrid(int tileSize, int slices)
  {
    for (vtkClusteredLightsPass* const pass : { static_cast<vtkClusteredLightsPass*>(this->Lights),
           static_cast<vtkClusteredLightsPass*>(this->Deferred) })
    {
      pass->SetTileSize(tileSize);
      pass->SetNumberOfSlices(slices);
    }
  }

  vtkSmartPointer<vtkLight> AddBeam(const Beam& beam)
  {
    auto light = this->AddLight(LightKind::Spot, 0.7, beam.Steepness);
    light->SetPosition(beam.From.data());
    light->SetFocalPoint(beam.To.data());
    light->SetConeAngle(beam.Angle);
    light->SetDiffuseColor(1.0, 0.9, 0.8);
    return light;
  }

  /** Six lights at least, since VTK compiles shaders for each number: the rest shines at nothing. */
  void Shine(const std::vector<Beam>& beams)
  {
    this->Renderer->RemoveAllLights();
    for (const Beam& beam : beams)
    {
      this->AddBeam(beam);
    }
    for (std::size_t i = beams.size(); i < 6; ++i)
    {
      this->AddBeam({ { 0.0, 0.0, 9.0 }, { 0.0, 0.0, 20.0 }, 30.0 });
    }
  }

  /** Spot lights of one angle, at all that there is from all around. */
  void ShineAround(double angle, double steepness = 0.0)
  {
    std::vector<Beam> beams;
    for (int i = 0; i < 6; ++i)
    {
      const double turn = 1.1 * i + 0.3;
      beams.push_back({ { 1.4 * std::cos(turn), 1.1 * std::sin(turn), 0.3 * i - 0.2 },
        { 0.7 * std::sin(3.0 * turn), 0.6 * std::cos(2.0 * turn), -0.5 }, angle, steepness });
    }
    this->Shine(beams);
  }

  /** Expects a frame by each pass to be so, give or take some steps of 1/255. */
  void ExpectFrames(const Picture& expected, int tolerance)
  {
    EXPECT_TRUE(Matches(this->InWorldsLight(), expected, tolerance)) << "world";
    EXPECT_TRUE(Matches(this->InClusteredLight(), expected, tolerance)) << "forward";
    for (const int assignment : DeferredAssignments)
    {
      this->Deferred->SetAssignment(assignment);
      EXPECT_TRUE(Matches(this->InDeferredLight(), expected, tolerance)) << assignment;
    }
  }

  /** Expects VTK's picture to the bit, and within a step with the cut-off that is the default. There must be light. */
  void ExpectStable()
  {
    const Picture expected = this->InVTKsLight();
    const vtkSmartPointer<vtkLightCollection> lit = this->Renderer->GetLights();
    vtkNew<vtkLightCollection> none;
    this->Renderer->SetLightCollection(none);
    EXPECT_GT(LargestDifference(expected, this->InClusteredLight()), 20);
    this->Renderer->SetLightCollection(lit);
    this->SetCutOff(0.0);
    this->ExpectFrames(expected, 0);
    this->SetCutOff(0.5 / 255.0);
    this->ExpectFrames(expected, 1);
    this->Renderer->SetLightCollection(none);
  }
};

#endif
