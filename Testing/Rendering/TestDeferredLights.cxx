// Lights of deferred shading give VTK's picture to the bit; with a cut-off, within what it promises.
#include "Core/lighting/ClusterGrid.h"
#include "Core/lighting/UsedClusters.h"
#include "DeferredScene.h"
#include "TestMessages.h"
#include "vtkMatrix4x4.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

namespace
{

class DeferredLights : public testing::TestWithParam<LightSettings>
{
protected:
  DeferredScene Scene{ GetParam().IsParallel, GetParam().IsPhysical, GetParam().Multisamples };
};

TEST_P(DeferredLights, OfAllKindsAreVTKs)
{
  this->Scene.AddLightsOfAllKinds();
  this->Scene.ExpectAsVTK(DeferredParts);
  EXPECT_EQ(this->Scene.Deferred->GetNumberOfLights(), 11);
  const Picture lit = this->Scene.InDeferredLight();
  this->Scene.Renderer->RemoveAllLights();
  EXPECT_GT(LargestDifference(lit, this->Scene.InDeferredLight()), 20); // there is light
}

TEST_P(DeferredLights, ThatAreOnlyDirectionalAreVTKs)
{
  this->Scene.AddDirectionalLights();
  this->Scene.ExpectAsVTK(DeferredParts);
}

INSTANTIATE_TEST_SUITE_P(
  Settings, DeferredLights, testing::ValuesIn(PairsOfLightSettings), NameOfLightSettings);

TEST(DeferredLight, Of32LightsIsVTKs)
{
  DeferredScene scene(false);
  scene.AddLights(16);
  scene.ExpectAsVTK(DeferredParts);
}

TEST(DeferredLight, OfSurfacesOfBothFormulasIsVTKs)
{
  DeferredScene scene;
  scene.AddLights(2);
  scene.Parts[0]->GetProperty()->SetInterpolationToPBR();
  scene.Parts[0]->GetProperty()->SetMetallic(0.7);
  scene.Parts[0]->GetProperty()->SetEdgeTint(0.9, 0.6, 0.3);
  scene.Parts[0]->GetProperty()->SetBaseIOR(1.8);
  scene.Parts[2]->GetProperty()->SetInterpolationToFlat();
  scene.Parts[4]->GetProperty()->SetInterpolationToGouraud();
  scene.ExpectAsVTK(DeferredParts);
}

TEST(DeferredLight, LeavesWhatOtherMethodsDrawTranslucent)
{
  for (const vtkSmartPointer<vtkRenderPass>& method : OtherTranslucentPasses())
  {
    DeferredScene scene;
    scene.Steps->SetTranslucentPass(method);
    scene.AddLights(2);
    EXPECT_TRUE(Matches(scene.InDeferredLight(), scene.InVTKsLight()));
  }
}

TEST(DeferredLight, DoesNotDependOnTheGrid)
{
  DeferredScene scene(false);
  scene.AddLights(6);
  const Picture expected = scene.InDeferredLight();
  for (const int tile : { 1, 7, 64 })
  {
    for (const int slices : { 1, 5, 40 })
    {
      for (const int assignment : DeferredAssignments)
      {
        scene.Deferred->SetTileSize(tile);
        scene.Deferred->SetNumberOfSlices(slices);
        scene.Deferred->SetAssignment(assignment);
        EXPECT_TRUE(Matches(scene.InDeferredLight(), expected))
          << tile << " " << slices << " " << assignment;
      }
    }
  }
}

TEST(DeferredLight, IsOffByNoMoreThanTheCutOff)
{
  DeferredScene scene(false);
  for (int i = 0; i < 300; ++i)
  {
    scene.AddLight(LightKind::Point, 0.2, 1e5);
  }
  for (const int assignment : DeferredAssignments)
  {
    scene.Deferred->SetAssignment(assignment);
    scene.Deferred->SetCutOff(0.0);
    const Picture exact = scene.InDeferredLight();
    const double all = scene.Deferred->GetMeanNumberOfLightsPerCluster();
    scene.Deferred->SetCutOff(0.5 / 255.0);
    EXPECT_TRUE(Matches(scene.InDeferredLight(), exact, 1)); // of what is rounded
    EXPECT_LT(scene.Deferred->GetMeanNumberOfLightsPerCluster(), 0.5 * all) << assignment;
  }
}

/** The grid of a scene's frame. */
vitrine::ClusterGrid GridOf(DeferredScene& scene)
{
  vtkMatrix4x4* const toClip = scene.Renderer->GetActiveCamera()->GetProjectionTransformMatrix(
    scene.Renderer->GetTiledAspectRatio(), -1, 1);
  return { glm::transpose(glm::make_mat4(toClip->GetData())), 61, 47,
    { scene.Deferred->GetTileSize(), scene.Deferred->GetNumberOfSlices() } };
}

// Of lights without end each is in the list of each cluster that gets one.
TEST(DeferredLight, IsInListsOfClustersThatShowSomething)
{
  for (const int samples : { 0, 4 })
  {
    DeferredScene scene(false, false, samples);
    scene.Renderer->RemoveActor(scene.Parts.back());
    scene.AddLight(LightKind::Point);
    scene.AddLight(LightKind::Directional);
    scene.InDeferredLight();
    const auto clusters = static_cast<double>(scene.Deferred->GetNumberOfClusters());
    const auto used = static_cast<double>(scene.Deferred->GetNumberOfUsedClusters());
    EXPECT_EQ(scene.Deferred->GetMeanNumberOfLightsPerCluster(), 2.0);
    std::vector<float> depths(61 * 47);
    scene.Window->GetZbufferData(0, 0, 60, 46, depths.data());
    const vitrine::ClusterGrid grid = GridOf(scene);
    vitrine::UsedClusters judge(grid);
    judge.AddDepths(depths.data(), 61, 47);
    EXPECT_NEAR(used, judge.Count(), samples > 0 ? 3.0 : 0.5);
    EXPECT_LT(used, 0.3 * clusters);
    EXPECT_GT(used, 5.0);
  }
}

TEST(DeferredLight, CountsLightsAtPlaces)
{
  DeferredScene scene;
  scene.AddLight(LightKind::Point);
  scene.AddLight(LightKind::Directional);
  for (const int assignment : DeferredAssignments)
  {
    scene.Deferred->SetAssignment(assignment);
    scene.InDeferredLight();
    EXPECT_EQ(scene.Deferred->GetNumberOfLightsAt(0.0, 0.9, -1.5), 2) << assignment; // on the wall
  }
  EXPECT_EQ(scene.Deferred->GetNumberOfLightsAt(0.0, 0.9, -0.3), 0); // before it
}

}
