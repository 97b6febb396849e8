// What stencil masks do that other methods of the family do not: limits and what is said of them, marks and the filter.
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkProperty.h"
#include "vtkStencilMaskTransparencyPass.h"
#include "vtkTruthTransparencyPass.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

constexpr int Width = 20;
constexpr int Height = 18;

class StencilMask : public testing::TestWithParam<int>
{
protected:
  StencilMask() { this->Pass->SetNumberOfLayers(GetParam()); }

  vtkNew<vtkStencilMaskTransparencyPass> Pass;
};

void ExpectColor(const Rgba& color, const Rgba& expected, double tolerance)
{
  for (int c = 0; c < 4; ++c)
  {
    EXPECT_NEAR(255.0 * color[c], 255.0 * expected[c], tolerance) << "channel " << c;
  }
}

TEST_P(StencilMask, KeepsUpToItsNumberOfLayers)
{
  for (int layers = 1; layers <= GetParam(); ++layers)
  {
    SCOPED_TRACE(layers);
    TestScene scene(Width, Height);
    const std::vector<Rgba> plates = RandomPlates(layers, 0.4, 3);
    scene.AddPlates(plates, 4);
    scene.Use(this->Pass);
    ExpectColor(UniformColor(scene.Render()), CompositePlates(plates, TestBackground), 0.75);
    EXPECT_STREQ(this->Pass->GetFallbackReason(), "");
    EXPECT_EQ(this->Pass->GetLayersMax(), layers);
    EXPECT_EQ(this->Pass->GetFragmentCount(), layers * Width * Height);
    EXPECT_EQ(this->Pass->GetLostFragmentCount(), 0);
    EXPECT_EQ(this->Pass->GetSaturatedPixelCount(), 0);
  }
}

// Of more layers those that are drawn first are kept: the nearest, where they are drawn front to back.
TEST_P(StencilMask, KeepsTheFirstAndSaysHowManyWereLost)
{
  for (const int layers : { GetParam() + 1, 40, 240, 251 })
  {
    SCOPED_TRACE(layers);
    TestScene scene(Width, Height);
    const std::vector<Rgba> plates = RandomPlates(layers, 0.2, 5);
    for (int i = 0; i < layers; ++i)
    {
      scene.AddPlate(0.9 - 1.8 * i / layers, plates[i]);
    }
    scene.Use(this->Pass);
    const std::vector<Rgba> nearest(plates.begin(), plates.begin() + GetParam());
    ExpectColor(UniformColor(scene.Render()), CompositePlates(nearest, TestBackground), 0.6);
    EXPECT_EQ(this->Pass->GetLostFragmentCount(), (layers - GetParam()) * Width * Height);
    EXPECT_EQ(this->Pass->GetSaturatedPixelCount(), 0);
  }
}

// The stencil has 8 bits: the 257th fragment must not pass where the first did, and what is not counted is said.
TEST_P(StencilMask, LetsNoFragmentPassTwice)
{
  for (const int layers : { 255, 256, 257, 258, 272, 600 })
  {
    SCOPED_TRACE(layers);
    TestScene scene(Width, Height);
    const Rgba plate = RoundedTo8Bits({ 0.2, 0.8, 0.4, 0.1 });
    scene.AddPlates(std::vector<Rgba>(layers, plate), 5);
    scene.Use(this->Pass);
    const std::vector<Rgba> first(GetParam(), plate);
    ExpectColor(UniformColor(scene.Render()), CompositePlates(first, TestBackground), 1.4);
    EXPECT_EQ(this->Pass->GetSaturatedPixelCount(), Width * Height);
    EXPECT_LE(this->Pass->GetLostFragmentCount(), (layers - GetParam()) * Width * Height);
    EXPECT_GE(this->Pass->GetLostFragmentCount(), (240 - GetParam()) * Width * Height);
  }
}

// A failed stencil test counts before the depth is tested: hidden fragments must get to neither.
TEST_P(StencilMask, DoesNotCountWhatOpaqueGeometryHides)
{
  TestScene scene(Width, Height);
  scene.AddPlate(0.0, { 0.4, 0.4, 0.8, 1.0 });
  std::vector<Rgba> visible = RandomPlates(GetParam(), 0.3, 8);
  for (int i = 0; i < 40; ++i)
  {
    scene.AddPlate(-0.9 + 0.02 * i, { 1.0, 0.0, 0.0, 0.5 });
  }
  for (int i = 0; i < GetParam(); ++i)
  {
    scene.AddPlate(0.9 - 0.8 * i / GetParam(), visible[i]);
  }
  scene.Use(this->Pass);
  ExpectColor(UniformColor(scene.Render()), CompositePlates(visible, { 0.4, 0.4, 0.8, 1.0 }), 1.4);
  EXPECT_EQ(this->Pass->GetLayersMax(), GetParam());
  EXPECT_EQ(this->Pass->GetLostFragmentCount(), 0);
}

// Not the larger target's places but the pixels' centres are shaded: gradients come out as truth has them.
TEST_P(StencilMask, ShadesTheCentresOfPixels)
{
  TestScene scene(60, 50);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
  scene.AddTriangle(
    { { { -9.0, -9.0, -0.5 }, { 9.0, -9.0, 0.5 }, { 0.0, 14.0, 0.3 } } }, { 0.9, 0.4, 0.1, 0.5 });
  scene.AddTriangle(
    { { { -9.0, -9.0, 0.5 }, { 9.0, -9.0, -0.5 }, { 0.0, 14.0, -0.3 } } }, { 0.1, 0.4, 0.9, 0.5 });
  scene.AddSphere(0.0, 0.0, 0.0, 0.95, { 0.9, 0.9, 0.2, 0.6 }, 4)->GetProperty()->LightingOn();
  vtkNew<vtkTruthTransparencyPass> truth;
  scene.Use(truth);
  scene.Render();
  this->Pass->FilterOff();
  scene.Use(this->Pass);
  const Picture picture = scene.Render();
  const auto* expected = static_cast<const float*>(truth->GetResult()->GetScalarPointer());
  int wrong = 0;
  for (std::size_t i = 0; i < picture.Bytes.size(); ++i)
  {
    wrong += std::abs(picture.Bytes[i] - 255.0 * expected[i]) > 1.4;
  }
  // The sphere's 16 edges and its outline cross some 150 of the 3000 pixels.
  EXPECT_LE(wrong, 4 * 150);
}

INSTANTIATE_TEST_SUITE_P(
  Layers, StencilMask, testing::Values(4, 8, 9, 16), testing::PrintToStringParamName());

double SquaredError(const Picture& picture, vtkImageData* truth)
{
  const auto* expected = static_cast<const float*>(truth->GetScalarPointer());
  double sum = 0.0;
  for (std::size_t i = 0; i < picture.Bytes.size(); ++i)
  {
    sum += std::pow(picture.Bytes[i] / 255.0 - expected[i], 2);
  }
  return sum;
}

TEST(StencilMaskFilter, RepairsEdges)
{
  for (const int layers : { 8, 9, 16 })
  {
    SCOPED_TRACE(layers);
    TestScene scene(90, 70);
    scene.AddSphere(0.2, 0.1, 0.0, 0.6, { 0.9, 0.5, 0.1, 0.5 }, 24);
    scene.AddSphere(-0.3, -0.1, 0.2, 0.5, { 0.1, 0.5, 0.9, 0.5 }, 24);
    vtkNew<vtkTruthTransparencyPass> truth;
    scene.Use(truth);
    scene.Render();
    vtkNew<vtkStencilMaskTransparencyPass> pass;
    pass->SetNumberOfLayers(layers);
    scene.Use(pass);
    const double repaired = SquaredError(scene.Render(), truth->GetResult());
    pass->FilterOff();
    const double asItIs = SquaredError(scene.Render(), truth->GetResult());
    EXPECT_GT(asItIs, 0.0);
    EXPECT_LT(repaired, 0.9 * asItIs);
  }
}

// Where nothing is wrong, nothing is marked, and the filter changes nothing.
TEST(StencilMaskFilter, LeavesWhatHasNoEdges)
{
  TestScene scene(Width, Height);
  scene.AddPlates(RandomPlates(6, 0.4, 3), 4);
  vtkNew<vtkStencilMaskTransparencyPass> pass;
  scene.Use(pass);
  const Picture filtered = scene.Render();
  pass->FilterOff();
  EXPECT_TRUE(scene.Render() == filtered);
  pass->ShowMarksOn();
  EXPECT_EQ(UniformColor(scene.Render()), (Rgba{ 0.0, 0.0, 0.0, 1.0 }));
}

// A plate's outline is marked, and no pixel two steps away from it.
TEST(StencilMaskFilter, MarksTheOutline)
{
  TestScene scene(40, 40);
  scene.AddRectangle(-0.5, -0.5, 0.512, 0.512, 0.0, { 0.9, 0.5, 0.1, 0.5 });
  vtkNew<vtkStencilMaskTransparencyPass> pass;
  pass->ShowMarksOn();
  scene.Use(pass);
  const Picture marks = scene.Render();
  int marked = 0;
  for (int y = 0; y < 40; ++y)
  {
    for (int x = 0; x < 40; ++x)
    {
      if (marks.At(x, y)[0] > 0.8)
      {
        ++marked;
        const auto atOutline = [](int i) { return std::abs(i - 10) < 2 || std::abs(i - 30) < 2; };
        EXPECT_TRUE(atOutline(x) || atOutline(y)) << x << ", " << y;
      }
    }
  }
  EXPECT_GE(marked, 20);
}

TEST(StencilMaskDepths, OfHalfFloatsOrderWhatIsFarEnoughApart)
{
  TestScene scene(Width, Height);
  const std::vector<Rgba> plates = RandomPlates(8, 0.4, 3);
  scene.AddPlates(plates, 4);
  vtkNew<vtkStencilMaskTransparencyPass> pass;
  scene.Use(pass);
  const Picture full = scene.Render();
  const vtkTypeInt64 bytes = pass->GetBytes();
  pass->SetDepthStorageToHalfFloat();
  EXPECT_TRUE(scene.Render() == full);
  EXPECT_EQ(pass->GetBytes(), bytes - 2 * 8 * Width * Height);
}

TEST(StencilMaskSettings, OfOtherValuesAreErrors)
{
  vtkNew<vtkStencilMaskTransparencyPass> pass;
  pass->SetNumberOfLayers(12);
  EXPECT_EQ(pass->GetNumberOfLayers(), 8);
  pass->SetDepthStorage(7);
  EXPECT_EQ(pass->GetDepthStorage(), vtkStencilMaskTransparencyPass::FULL_FLOAT);
  EXPECT_EQ(TakeMessages().size(), 2u);
}

TEST(StencilMaskRefusals, OfWhatCountsInPixels)
{
  TestScene scene(Width, Height);
  vtkNew<vtkStencilMaskTransparencyPass> pass;
  scene.Use(pass);
  scene.AddPlate(0.3, { 0.1, 0.5, 0.9, 0.5 });
  const vtkSmartPointer<vtkActor> actor =
    scene.AddSphere(0.0, 0.0, 0.0, 0.5, { 0.9, 0.5, 0.1, 0.5 });
  scene.Render();
  EXPECT_STREQ(pass->GetFallbackReason(), "");
  actor->GetProperty()->SetRepresentationToWireframe();
  scene.Render();
  EXPECT_NE(std::string(pass->GetFallbackReason()).find("lines and points"), std::string::npos);
  EXPECT_EQ(TakeMessages().size(), 1u);
  actor->GetProperty()->SetRepresentationToSurface();
  scene.Render();
  EXPECT_STREQ(pass->GetFallbackReason(), "");
}

TEST(StencilMaskRefusals, OfSeveralSamplesAPixel)
{
  TestScene scene(Width, Height, 4);
  scene.AddPlate(0.3, { 0.1, 0.5, 0.9, 0.5 });
  vtkNew<vtkStencilMaskTransparencyPass> pass;
  scene.Use(pass);
  scene.Render();
  EXPECT_NE(std::string(pass->GetFallbackReason()).find("4 samples"), std::string::npos);
  EXPECT_EQ(TakeMessages().size(), 1u);
}

}
