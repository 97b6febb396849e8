// Lights by cubes of the world; that pictures are VTK's then is tested along with those of the view's clusters.
#include "LightScene.h"
#include "vtkMatrix4x4.h"

#include <gtest/gtest.h>

#include <cmath>

// The spot lights shine at the wall, which stands at z = -0.5.
TEST(WorldCells, HoldTheLightsThatReachThem)
{
  LightScene scene(false);
  for (const double x : { -1.0, 1.0 })
  {
    const auto light = scene.AddLight(LightKind::Spot, 1.0, 0.0);
    light->SetPosition(x, 0.0, 0.5);
    light->SetFocalPoint(x, 0.0, -0.5);
    light->SetConeAngle(15.0);
  }
  const Picture expected = scene.InVTKsLight();
  scene.Lights->SetGridSpace(vtkClusteredLightsPass::WORLD);
  const auto lightsAt = [&](double x, double y, double z)
  {
    const double place[4] = { x, y, z, 1.0 };
    double seen[4];
    scene.Renderer->GetActiveCamera()->GetModelViewTransformMatrix()->MultiplyPoint(place, seen);
    return scene.Lights->GetNumberOfLightsAt(seen[0], seen[1], seen[2]);
  };
  for (const int tile : { 4, 16, 30 })
  {
    SCOPED_TRACE(tile);
    scene.Lights->SetTileSize(tile);
    EXPECT_TRUE(Matches(scene.InClusteredLight(), expected));
    EXPECT_EQ(lightsAt(-1.0, 0.0, -0.5), 1);
    EXPECT_EQ(lightsAt(1.0, 0.0, -0.5), 1);
    EXPECT_EQ(lightsAt(0.0, 2.9, -0.5), 0);
    const double tiles = std::ceil(61.0 / tile) * std::ceil(47.0 / tile);
    EXPECT_NEAR(scene.Lights->GetNumberOfClusters(), 16.0 * tiles, 8.0 * tiles); // the box is flat
    EXPECT_LT(scene.Lights->GetNumberOfUsedClusters(), scene.Lights->GetNumberOfClusters());
  }
}

// What is lit at an edge of a face may lie far off then.
TEST(WorldCells, OfSeveralSamplesAreOne)
{
  LightScene scene(false, false, 4);
  scene.AddLight(LightKind::Point);
  scene.AddLight(LightKind::Spot);
  scene.InWorldsLight();
  EXPECT_EQ(scene.Lights->GetNumberOfClusters(), 1);
  EXPECT_EQ(scene.Lights->GetNumberOfUsedClusters(), 1);
}
