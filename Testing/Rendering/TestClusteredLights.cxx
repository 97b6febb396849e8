// Lights by cluster give VTK's picture to the bit; with a cut-off, within what it promises.
#include "LightScene.h"
#include "Select.h"
#include "TestMessages.h"
#include "vtkCallbackCommand.h"
#include "vtkDataObject.h"
#include "vtkLightCollection.h"
#include "vtkLineSource.h"
#include "vtkMapper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

class ClusteredLights : public testing::TestWithParam<LightSettings>
{
protected:
  LightScene Scene{ GetParam().IsParallel, GetParam().IsPhysical, GetParam().Multisamples };

  void ExpectAsVTK()
  {
    const Picture expected = this->Scene.InVTKsLight();
    const Picture clustered = this->Scene.InClusteredLight();
    EXPECT_TRUE(Matches(clustered, expected));
    EXPECT_TRUE(Matches(this->Scene.InWorldsLight(), expected));
    this->Scene.Renderer->RemoveAllLights();
    EXPECT_GT(LargestDifference(expected, this->Scene.InVTKsLight()), 20); // there is light
  }
};

TEST_P(ClusteredLights, OfAllKindsAreVTKs)
{
  this->Scene.AddLightsOfAllKinds();
  this->ExpectAsVTK();
  EXPECT_EQ(this->Scene.Lights->GetNumberOfLights(), 11);
}

TEST_P(ClusteredLights, ThatAreOnlyDirectionalAreVTKs)
{
  this->Scene.AddDirectionalLights();
  this->ExpectAsVTK();
}

INSTANTIATE_TEST_SUITE_P(
  Settings, ClusteredLights, testing::ValuesIn(PairsOfLightSettings), NameOfLightSettings);

TEST(ClusteredLight, OfOneHeadlightOrOffOrNoneIsVTKs)
{
  LightScene scene;
  EXPECT_TRUE(Matches(scene.InClusteredLight(), scene.InVTKsLight()));
  const auto headlight = scene.AddLight(LightKind::Headlight);
  EXPECT_TRUE(Matches(scene.InClusteredLight(), scene.InVTKsLight()));
  headlight->SwitchOff();
  EXPECT_TRUE(Matches(scene.InClusteredLight(), scene.InVTKsLight()));
  headlight->SwitchOn();
  scene.AddLight(LightKind::Point)->SwitchOff(); // VTK takes its formula all the same
  EXPECT_TRUE(Matches(scene.InClusteredLight(), scene.InVTKsLight()));
  scene.Renderer->RemoveAllLights();
  scene.Renderer->AutomaticLightCreationOn();
  EXPECT_TRUE(Matches(scene.InClusteredLight(), scene.InVTKsLight()));
}

TEST(ClusteredLight, FallsOnWhatOtherMethodsDrawTranslucent)
{
  for (const vtkSmartPointer<vtkRenderPass>& method : OtherTranslucentPasses())
  {
    LightScene scene;
    scene.Steps->SetTranslucentPass(method);
    for (int i = 0; i < 4; ++i)
    {
      scene.AddLight(i % 2 == 0 ? LightKind::Point : LightKind::Spot);
    }
    EXPECT_TRUE(Matches(scene.InClusteredLight(), scene.InVTKsLight()));
  }
}

// The grid follows the clipping range and the size of the window.
TEST(ClusteredLight, DoesNotDependOnTheGrid)
{
  LightScene scene(false);
  for (int i = 0; i < 20; ++i)
  {
    scene.AddLight(LightKind::Spot);
  }
  const Picture expected = scene.InClusteredLight();
  for (const int tile : { 1, 7, 64 })
  {
    for (const int slices : { 1, 5, 40 })
    {
      scene.Lights->SetTileSize(tile);
      scene.Lights->SetNumberOfSlices(slices);
      EXPECT_TRUE(Matches(scene.InClusteredLight(), expected));
    }
  }
  for (const int law : { vtkClusteredLightsPass::UNIFORM, vtkClusteredLightsPass::NDC_UNIFORM })
  {
    const double before = scene.Lights->GetMeanNumberOfLightsPerCluster();
    scene.Lights->SetSliceLaw(law);
    EXPECT_TRUE(Matches(scene.InClusteredLight(), expected));
    EXPECT_NE(scene.Lights->GetMeanNumberOfLightsPerCluster(), before);
  }
  scene.Lights->SetSliceLaw(vtkClusteredLightsPass::EXPONENTIAL);
  vtkCamera* const camera = scene.Renderer->GetActiveCamera();
  for (const double near : { 0.01, 0.5, 1.5 })
  {
    scene.Lights->SetTileSize(16);
    scene.Lights->SetNumberOfSlices(16);
    camera->SetClippingRange(near, 4.0 + near);
    EXPECT_TRUE(Matches(scene.InClusteredLight(), scene.InVTKsLight())) << near;
  }
}

TEST(ClusteredLight, IsOffByNoMoreThanTheCutOff)
{
  for (const int count : { 64, 1000 })
  {
    LightScene scene(false);
    for (int i = 0; i < count; ++i)
    {
      scene.AddLight(LightKind::Point, 0.2, 1e5);
    }
    scene.AddLight(LightKind::Directional, 0.2);
    const Picture exact = scene.InClusteredLight();
    const double all = scene.Lights->GetMeanNumberOfLightsPerCluster();
    EXPECT_EQ(all, count + 1);
    scene.Lights->SetCutOff(0.5 / 255.0);
    EXPECT_TRUE(Matches(scene.InClusteredLight(), exact, 1)); // of what is rounded
    EXPECT_LT(scene.Lights->GetMeanNumberOfLightsPerCluster(), 0.5 * all);
    scene.Lights->SetCutOff(1.0);
    scene.InClusteredLight();
    EXPECT_LT(scene.Lights->GetMeanNumberOfLightsPerCluster(), 0.1 * all);
  }
}

// Each is faint where it is, and all together are not.
TEST(ClusteredLight, IsNotCutWhereManyAddUp)
{
  LightScene scene(false);
  for (int i = 0; i < 1000; ++i)
  {
    scene.AddLight(LightKind::Point, 6.0, 1e5);
  }
  const Picture exact = scene.InClusteredLight();
  scene.Lights->SetCutOff(0.5 / 255.0);
  EXPECT_TRUE(Matches(scene.InClusteredLight(), exact, 1));
}

TEST(ClusteredLight, InStereoIsVTKs)
{
  LightScene scene(false);
  scene.AddLight(LightKind::Point);
  scene.AddLight(LightKind::Spot);
  scene.Window->SetStereoTypeToAnaglyph();
  scene.Window->StereoRenderOn();
  EXPECT_TRUE(Matches(scene.InClusteredLight(), scene.InVTKsLight()));
}

// VTK alone turns all black by each of them.
TEST(ClusteredLight, ThatIsNoLightDarkensNothing)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double endless = std::numeric_limits<double>::infinity();
  LightScene scene;
  scene.AddLight(LightKind::Point);
  scene.AddLight(LightKind::Spot);
  const Picture expected = scene.InVTKsLight();
  scene.AddLight(LightKind::Point)->SetIntensity(none);
  scene.AddLight(LightKind::Point)->SetIntensity(endless);
  scene.AddLight(LightKind::Spot)->SetPosition(none, 0.0, 0.0);
  scene.AddLight(LightKind::Point)->SetAttenuationValues(0.0, 0.0, 0.0);
  EXPECT_TRUE(Matches(scene.InClusteredLight(), expected));
  EXPECT_EQ(scene.Lights->GetNumberOfLights(), 2);
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("2, 3, 4, 5"), std::string::npos) << messages[0];
  scene.InClusteredLight();
  EXPECT_TRUE(TakeMessages().empty());
}

TEST(ClusteredLight, ComesAndGoes)
{
  LightScene scene;
  for (const int count : { 1, 300, 3 })
  {
    scene.Renderer->RemoveAllLights();
    for (int i = 0; i < count; ++i)
    {
      scene.AddLight(LightKind::Spot);
    }
    scene.InClusteredLight();
    EXPECT_EQ(scene.Lights->GetNumberOfLights(), count);
  }
  const Picture last = scene.InClusteredLight();
  EXPECT_TRUE(Matches(last, scene.InVTKsLight()));
  EXPECT_GT(scene.Lights->GetBytes(), 0);
}

TEST(ClusteredLight, TellsOfTheLastFrameAlone)
{
  LightScene scene(false);
  scene.AddLight(LightKind::Point);
  scene.InClusteredLight();
  EXPECT_EQ(scene.Lights->GetNumberOfLights(), 1);
  EXPECT_GT(scene.Lights->GetNumberOfUsedClusters(), 0);
  EXPECT_EQ(scene.Lights->GetNumberOfLightsAt(0.0, 0.0, -3.5), 1);
  scene.Renderer->RemoveAllLights();
  scene.AddLight(LightKind::Headlight);
  scene.InClusteredLight();
  EXPECT_EQ(scene.Lights->GetNumberOfLights(), 0);
  EXPECT_EQ(scene.Lights->GetNumberOfClusters(), 0);
  EXPECT_EQ(scene.Lights->GetNumberOfUsedClusters(), 0);
  EXPECT_EQ(scene.Lights->GetMeanNumberOfLightsPerCluster(), 0.0);
  EXPECT_EQ(scene.Lights->GetMaximumNumberOfLightsPerCluster(), 0);
  EXPECT_EQ(scene.Lights->GetAssignmentTime(), 0.0);
  EXPECT_EQ(scene.Lights->GetNumberOfLightsAt(0.0, 0.0, -3.5), 0);
}

// A list has 8 bytes, a light 64 and its number in a list 2; buffers have room for a quarter more.
TEST(ClusteredLight, TakesTheBytesThatItsListsTake)
{
  LightScene scene(false);
  for (int i = 0; i < 100; ++i)
  {
    scene.AddLight(LightKind::Spot);
  }
  scene.InClusteredLight();
  const auto roomy = [](vtkTypeInt64 bytes) { return bytes + bytes / 4; };
  const auto numbers = static_cast<vtkTypeInt64>(std::lround(
    scene.Lights->GetMeanNumberOfLightsPerCluster() * scene.Lights->GetNumberOfUsedClusters()));
  EXPECT_GT(numbers, 100);
  EXPECT_EQ(scene.Lights->GetBytes(),
    roomy(64 * 100) + roomy(8 * scene.Lights->GetNumberOfClusters()) + roomy(2 * numbers));
}

TEST(ClusteredLight, IsItsRenderersAlone)
{
  LightScene scene;
  scene.AddLight(LightKind::Point);
  scene.AddLight(LightKind::Spot);
  scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.5, 0.0, 1.0, 1.0);
  other->SetActiveCamera(scene.Renderer->GetActiveCamera());
  other->AddActor(scene.Parts.front());
  scene.Window->AddRenderer(other);
  const Picture expected = scene.InVTKsLight();
  EXPECT_TRUE(Matches(scene.InClusteredLight(), expected));
}

// What it held in the one must not be deleted in the other, where the same names are others'.
TEST(ClusteredLight, MovesFromWindowToWindow)
{
  LightScene first, second;
  Picture expected[2];
  for (int i = 0; i < 2; ++i)
  {
    LightScene& scene = i == 0 ? first : second;
    scene.AddLight(LightKind::Point);
    scene.AddLight(LightKind::Spot);
    expected[i] = scene.InVTKsLight();
  }
  for (int i = 0; i < 6; ++i)
  {
    LightScene& scene = i % 2 == 0 ? first : second;
    first.Lights->SetDelegatePass(scene.Steps);
    scene.Renderer->SetPass(first.Lights);
    EXPECT_TRUE(Matches(scene.Render(), expected[i % 2]));
  }
}

TEST(ClusteredLight, DoesNotHinderPicking)
{
  LightScene scene;
  scene.AddLight(LightKind::Point);
  scene.InClusteredLight();
  const Picked picked =
    Select(scene.Renderer, vtkDataObject::FIELD_ASSOCIATION_CELLS, 0, 0, 60, 46);
  scene.Renderer->SetPass(nullptr);
  EXPECT_EQ(picked, Select(scene.Renderer, vtkDataObject::FIELD_ASSOCIATION_CELLS, 0, 0, 60, 46));
  EXPECT_GT(picked.size(), 3u);
}

// Lines have no normals, and VTK declares lights for them all the same.
TEST(ClusteredLight, LeavesWhatIsNotLitAsItIs)
{
  LightScene scene;
  scene.AddLight(LightKind::Point);
  scene.AddLight(LightKind::Spot);
  vtkNew<vtkLineSource> line;
  line->SetPoint1(-0.9, -0.9, 0.8);
  line->SetPoint2(0.9, 0.8, 0.8);
  scene.AddSource(line, { 0.9, 0.1, 0.2, 1.0 });
  scene.Parts.back()->GetProperty()->LightingOff();
  EXPECT_TRUE(Matches(scene.InClusteredLight(), scene.InVTKsLight()));
}

TEST(ClusteredLight, MayPassThroughPassesOfItsKind)
{
  LightScene scene;
  scene.AddLight(LightKind::Point);
  scene.AddLight(LightKind::Spot);
  const Picture expected = scene.InVTKsLight();
  vtkNew<vtkClusteredLightsPass> outer;
  outer->SetDelegatePass(scene.Lights);
  scene.Renderer->SetPass(outer);
  EXPECT_TRUE(Matches(scene.Render(), expected));
  outer->SetDelegatePass(outer);
  EXPECT_EQ(outer->GetDelegatePass(), scene.Lights);
  EXPECT_EQ(TakeMessages().size(), 1u);
}

TEST(ClusteredLight, ThatComesDuringAFrameStays)
{
  LightScene scene;
  scene.AddLight(LightKind::Point);
  scene.AddLight(LightKind::Spot);
  vtkNew<vtkCallbackCommand> add;
  add->SetClientData(&scene);
  add->SetCallback([](vtkObject*, unsigned long, void* data, void*)
    { static_cast<LightScene*>(data)->AddLight(LightKind::Point); });
  vtkMapper* const mapper = scene.Parts.front()->GetMapper();
  const unsigned long id = mapper->AddObserver(vtkCommand::EndEvent, add);
  scene.InClusteredLight();
  mapper->RemoveObserver(id);
  const int count = scene.Renderer->GetLights()->GetNumberOfItems();
  EXPECT_GT(count, 2);
  EXPECT_TRUE(Matches(scene.InClusteredLight(), scene.InVTKsLight()));
  EXPECT_EQ(scene.Lights->GetNumberOfLights(), count);
}

TEST(ClusteredLight, IsCutByWhatBackFacesGiveBack)
{
  LightScene scene;
  for (int i = 0; i < 20; ++i)
  {
    scene.AddLight(LightKind::Point, 0.2, 1e3);
  }
  scene.Lights->SetCutOff(0.05);
  scene.InClusteredLight();
  const double before = scene.Lights->GetMeanNumberOfLightsPerCluster();
  vtkNew<vtkProperty> back;
  back->SetDiffuseColor(20.0, 20.0, 20.0);
  scene.Parts.back()->SetBackfaceProperty(back);
  scene.InClusteredLight();
  EXPECT_GT(scene.Lights->GetMeanNumberOfLightsPerCluster(), before);
}

TEST(ClusteredLight, NeedsWhatDraws)
{
  LightScene scene;
  scene.Lights->SetDelegatePass(nullptr);
  scene.InClusteredLight();
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_FALSE(messages.empty());
  EXPECT_NE(messages[0].find("DelegatePass"), std::string::npos);
}

// A frame that VTK's mappers light has no clusters, whatever the frame before had.
TEST(ClusteredLight, HasStatisticsOfItsOwnFramesAlone)
{
  LightScene scene(false);
  scene.AddLightsOfAllKinds();
  scene.InClusteredLight();
  EXPECT_EQ(scene.Lights->GetNumberOfLights(), 11);
  EXPECT_GT(scene.Lights->GetNumberOfLightsAt(0.0, 0.0, -3.5), 0);
  scene.Renderer->UseShadowsOn();
  scene.InClusteredLight();
  EXPECT_STRNE(scene.Lights->GetFallbackReason(), "");
  EXPECT_EQ(scene.Lights->GetNumberOfLights(), 0);
  EXPECT_EQ(scene.Lights->GetNumberOfClusters(), 0);
  EXPECT_EQ(scene.Lights->GetNumberOfUsedClusters(), 0);
  EXPECT_EQ(scene.Lights->GetMeanNumberOfLightsPerCluster(), 0.0);
  EXPECT_EQ(scene.Lights->GetMaximumNumberOfLightsPerCluster(), 0);
  EXPECT_EQ(scene.Lights->GetAssignmentTime(), 0.0);
  EXPECT_EQ(scene.Lights->GetNumberOfLightsAt(0.0, 0.0, -3.5), 0);
  scene.Renderer->UseShadowsOff();
  scene.InClusteredLight();
  EXPECT_EQ(scene.Lights->GetNumberOfLights(), 11);
}

}
