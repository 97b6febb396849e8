// What stencil routing does that other methods of the family do not: samples and passes, the stencil's reach, refusals.
#include "Core/lists/StencilRouting.h"
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkProperty.h"
#include "vtkStencilRoutedTransparencyPass.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

constexpr int Width = 20;
constexpr int Height = 18;

// Plates that are drawn front to back, so that the nearest are kept where not all are.
void AddPlatesInOrder(TestScene& scene, const std::vector<Rgba>& plates)
{
  const auto count = static_cast<double>(plates.size());
  for (std::size_t i = 0; i < plates.size(); ++i)
  {
    scene.AddPlate(0.9 - 1.8 * static_cast<double>(i) / count, plates[i]);
  }
}

void AddShellsLinesAndPoints(TestScene& scene)
{
  for (int i = 0; i < 6; ++i)
  {
    scene.AddSphere(
      0.1 * i - 0.3, 0.05 * i, 0.0, 0.9 - 0.1 * i, { 0.9 - 0.1 * i, 0.5, 0.15 * i, 0.4 });
  }
  vtkProperty* lines =
    scene.AddSphere(0.0, 0.0, 0.0, 0.8, { 0.1, 0.9, 0.9, 0.6 }, 9)->GetProperty();
  lines->SetRepresentationToWireframe();
  lines->SetLineWidth(3.0);
  vtkProperty* points =
    scene.AddSphere(0.2, 0.1, 0.0, 0.7, { 0.9, 0.2, 0.9, 0.6 }, 9)->GetProperty();
  points->SetRepresentationToPoints();
  points->SetPointSize(5.0);
}

// Runs for each number of samples per pass. A driver that lacks so many, or does not test them one by one, must be
// refused by name.
class StencilRouted : public testing::TestWithParam<int>
{
protected:
  StencilRouted() { this->Pass->SetSamplesPerPass(GetParam()); }

  // Whether the driver routes so many samples. What the pass says where it does not is tested once.
  bool IsRouted()
  {
    TestScene scene(Width, Height);
    scene.AddPlate(0.0, { 0.2, 0.4, 0.6, 0.5 });
    scene.Use(this->Pass);
    scene.Render();
    scene.Render();
    this->Messages = TakeMessages();
    return this->Reason().empty();
  }
  std::string Reason() { return this->Pass->GetFallbackReason(); }

  std::vector<std::string> Messages;
  vtkNew<vtkStencilRoutedTransparencyPass> Pass;
};

TEST_P(StencilRouted, IsThereOrSaysOnceWhyNot)
{
  if (this->IsRouted())
  {
    EXPECT_EQ(this->Messages.size(), 0u);
    return;
  }
  EXPECT_GT(GetParam(), 1); // one sample is what every driver has
  EXPECT_NE(this->Reason().find(std::to_string(GetParam()) + " samples"), std::string::npos);
  EXPECT_EQ(this->Messages.size(), 1u);
  EXPECT_NE(this->Messages[0].find(this->Reason()), std::string::npos);
}

TEST_P(StencilRouted, IsExactUpToTheReachOfTheStencil)
{
  if (!this->IsRouted())
  {
    GTEST_SKIP() << this->Reason();
  }
  const int k = std::max(GetParam(), 1);
  const vitrine::StencilRoute route(k);
  const int reach = GetParam() == 0 ? 224 : k * route.MostPasses();
  for (const int layers : { 1, k - 1, k, k + 1, 2 * k, 2 * k + 1, 33, 64, 65, 200, reach })
  {
    if (layers == 0)
    {
      continue;
    }
    SCOPED_TRACE(layers);
    TestScene scene(Width, Height);
    const std::vector<Rgba> plates = RandomPlates(layers, std::min(0.5, 3.0 / layers), 3);
    scene.AddPlates(plates, 4);
    scene.Use(this->Pass);
    for (int frame = 0; frame < 2; ++frame)
    {
      ExpectColor(UniformColor(scene.Render()), CompositePlates(plates, TestBackground), 0.6);
      EXPECT_STREQ(this->Pass->GetFallbackReason(), "");
      EXPECT_EQ(this->Pass->GetMaximumNumberOfLayers(), layers);
      EXPECT_EQ(this->Pass->GetNumberOfFragments(), layers * Width * Height);
      EXPECT_EQ(this->Pass->GetMeanNumberOfLayers(), layers);
      EXPECT_EQ(this->Pass->GetNumberOfLostFragments(), 0);
      EXPECT_EQ(this->Pass->GetNumberOfSaturatedPixels(), 0);
    }
    if (GetParam() > 0)
    {
      EXPECT_EQ(this->Pass->GetNumberOfGeometryPasses(), (layers + k - 1) / k);
    }
  }
}

// Beyond that the first that are drawn are kept, none twice, and what is missing is said once.
TEST_P(StencilRouted, SaysWhatIsBeyondTheReach)
{
  if (!this->IsRouted())
  {
    GTEST_SKIP() << this->Reason();
  }
  bool hasWarned = false;
  for (const int layers : { 255, 256, 257, 300, 513 })
  {
    SCOPED_TRACE(layers);
    TestScene scene(4, 3);
    const std::vector<Rgba> plates = RandomPlates(layers, 0.01, 5);
    AddPlatesInOrder(scene, plates);
    scene.Use(this->Pass);
    const Picture picture = scene.Render();
    if (GetParam() > 0)
    {
      const int kept = GetParam() * vitrine::StencilRoute(GetParam()).MostPasses();
      const std::vector<Rgba> first(plates.begin(), plates.begin() + kept);
      ExpectColor(UniformColor(picture), CompositePlates(first, TestBackground), 0.75);
    }
    EXPECT_EQ(this->Pass->GetNumberOfSaturatedPixels(), 4 * 3);
    EXPECT_GT(this->Pass->GetNumberOfLostFragments(), 0);
    EXPECT_EQ(this->Pass->GetMaximumNumberOfLayers(), 255);
    const std::vector<std::string> messages = TakeMessages();
    EXPECT_EQ(messages.size(), hasWarned ? 0u : 1u);
    hasWarned = true;
  }
}

TEST_P(StencilRouted, KeepsWhatItsPassesTake)
{
  if (!this->IsRouted() || GetParam() == 0)
  {
    GTEST_SKIP() << "the number of samples is the driver's choice, or: " << this->Reason();
  }
  const int layers = 100;
  const int kept = std::min(3 * GetParam(), layers);
  TestScene scene(Width, Height);
  const std::vector<Rgba> plates = RandomPlates(layers, 0.05, 5);
  AddPlatesInOrder(scene, plates);
  this->Pass->SetMaximumNumberOfPasses(3);
  scene.Use(this->Pass);
  const std::vector<Rgba> first(plates.begin(), plates.begin() + kept);
  scene.Render();
  ExpectColor(UniformColor(scene.Render()), CompositePlates(first, TestBackground), 0.75);
  EXPECT_EQ(this->Pass->GetNumberOfLostFragments(), (layers - kept) * Width * Height);
  EXPECT_EQ(this->Pass->GetNumberOfFragments(), layers * Width * Height);
  EXPECT_EQ(this->Pass->GetNumberOfSaturatedPixels(), 0);
  EXPECT_EQ(
    this->Pass->GetNumberOfGeometryPasses(), std::min(3, (layers + GetParam() - 1) / GetParam()));
  EXPECT_EQ(TakeMessages().size(), kept < layers ? 1u : 0u);
}

// A failed stencil test counts before the depth is tested: hidden fragments must get to neither.
TEST_P(StencilRouted, DoesNotCountWhatOpaqueGeometryHides)
{
  if (!this->IsRouted())
  {
    GTEST_SKIP() << this->Reason();
  }
  TestScene scene(Width, Height);
  scene.AddPlate(0.0, { 0.4, 0.4, 0.8, 1.0 });
  for (int i = 0; i < 40; ++i)
  {
    scene.AddPlate(-0.9 + 0.02 * i, { 1.0, 0.0, 0.0, 0.5 });
  }
  const std::vector<Rgba> visible = RandomPlates(5, 0.3, 8);
  for (int i = 0; i < 5; ++i)
  {
    scene.AddPlate(0.9 - 0.1 * i, visible[i]);
  }
  scene.Use(this->Pass);
  ExpectColor(UniformColor(scene.Render()), CompositePlates(visible, { 0.4, 0.4, 0.8, 1.0 }), 0.75);
  EXPECT_EQ(this->Pass->GetMaximumNumberOfLayers(), 5);
  EXPECT_EQ(this->Pass->GetNumberOfFragments(), 5 * Width * Height);
}

// No defects at edges: shells, lines whose width counts in pixels, and points.
TEST_P(StencilRouted, IsTruthAtEdges)
{
  if (!this->IsRouted())
  {
    GTEST_SKIP() << this->Reason();
  }
  TestScene scene(61, 47);
  AddShellsLinesAndPoints(scene);
  ExpectTruth(scene, this->Pass, 0.75);
}

// The images that fragments are kept in begin and end elsewhere than a viewport does.
TEST_P(StencilRouted, IsExactInPartOfAWindow)
{
  if (!this->IsRouted())
  {
    GTEST_SKIP() << this->Reason();
  }
  TestScene scene(61, 47);
  AddShellsLinesAndPoints(scene);
  scene.Renderer->SetViewport(0.31, 0.17, 0.83, 0.9);
  scene.Use(this->Pass);
  const Picture picture = scene.Render();
  EXPECT_STREQ(this->Pass->GetFallbackReason(), "");
  vtkNew<vtkLinkedListTransparencyPass> lists;
  scene.Use(lists);
  EXPECT_TRUE(Matches(scene.Render(), picture, 1));
  EXPECT_EQ(lists->GetNumberOfFragments(), this->Pass->GetNumberOfFragments());
}

INSTANTIATE_TEST_SUITE_P(
  Samples, StencilRouted, testing::Values(0, 1, 4, 8), testing::PrintToStringParamName());

TEST(StencilRoutedWindows, MayChangeTheirSize)
{
  TestScene scene(64, 48);
  const std::vector<Rgba> plates = RandomPlates(9, 0.3, 3);
  scene.AddPlates(plates, 4);
  vtkNew<vtkStencilRoutedTransparencyPass> pass;
  scene.Use(pass);
  for (const auto& [width, height] :
    { std::pair(1, 1), { 33, 17 }, { 61, 39 }, { 2, 3 }, { 64, 48 } })
  {
    scene.Window->SetSize(width, height);
    ExpectColor(UniformColor(scene.Render()), CompositePlates(plates, TestBackground), 0.75);
    EXPECT_EQ(pass->GetNumberOfFragments(), 9 * width * height);
    EXPECT_STREQ(pass->GetFallbackReason(), "");
  }
}

TEST(StencilRoutedRefusals, OfSeveralSamplesAPixel)
{
  TestScene scene(Width, Height, 4);
  scene.AddPlate(0.3, { 0.1, 0.5, 0.9, 0.5 });
  vtkNew<vtkStencilRoutedTransparencyPass> pass;
  scene.Use(pass);
  scene.Render();
  EXPECT_NE(std::string(pass->GetFallbackReason()).find("4 samples"), std::string::npos);
  EXPECT_EQ(TakeMessages().size(), 1u);
}

}
