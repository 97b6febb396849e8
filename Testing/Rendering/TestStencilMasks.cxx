// What stencil masks do that other methods of the family do not: limits and what is said of them, marks and the filter.
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
    EXPECT_EQ(this->Pass->GetMaximumNumberOfLayers(), layers);
    EXPECT_EQ(this->Pass->GetNumberOfFragments(), layers * Width * Height);
    EXPECT_EQ(this->Pass->GetNumberOfLostFragments(), 0);
    EXPECT_EQ(this->Pass->GetNumberOfSaturatedPixels(), 0);
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
    EXPECT_EQ(this->Pass->GetNumberOfLostFragments(), (layers - GetParam()) * Width * Height);
    EXPECT_EQ(this->Pass->GetNumberOfSaturatedPixels(), 0);
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
    EXPECT_EQ(this->Pass->GetNumberOfSaturatedPixels(), Width * Height);
    EXPECT_LE(this->Pass->GetNumberOfLostFragments(), (layers - GetParam()) * Width * Height);
    EXPECT_GE(this->Pass->GetNumberOfLostFragments(), (240 - GetParam()) * Width * Height);
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
  EXPECT_EQ(this->Pass->GetMaximumNumberOfLayers(), GetParam());
  EXPECT_EQ(this->Pass->GetNumberOfLostFragments(), 0);
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
  EXPECT_TRUE(Matches(scene.Render(), filtered));
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

// One pixel differs from all around it in what each test of neighbours checks. A failed test adds 0.25 for sums of
// depths, 0.75 for parity and 0.5 for colour. The maximum is 1.5.
TEST(StencilMaskFilter, MarksByDepthParityAndColor)
{
  const struct
  {
    int Layers; // more than around it
    double Alpha;
    double DepthLimit;
    double Error;
  } cases[] = { { 1, 0.6, 0.01, 1.5 }, { 1, 0.01, 0.01, 1.0 }, { 2, 0.6, 0.01, 0.75 },
    { 2, 0.01, 0.01, 0.25 }, { 2, 0.6, 100.0, 0.5 }, { 1, 0.01, 100.0, 0.75 },
    { 2, 0.01, 100.0, 0.0 } };
  for (const auto& c : cases)
  {
    SCOPED_TRACE(std::to_string(c.Layers) + " layers of alpha " + std::to_string(c.Alpha));
    TestScene scene(20, 20);
    scene.AddPlate(-0.5, { 0.2, 0.4, 0.8, 0.5 });
    for (int i = 0; i < c.Layers; ++i)
    {
      scene.AddRectangle(0.0, 0.0, 0.1, 0.1, 0.1 * i, { 1.0, 1.0, 0.2, c.Alpha });
    }
    vtkNew<vtkStencilMaskTransparencyPass> pass;
    pass->ShowMarksOn();
    pass->SetDepthLimit(c.DepthLimit);
    scene.Use(pass);
    const Picture marks = scene.Render();
    EXPECT_NEAR(marks.At(10, 10)[0], c.Error / 1.5, 0.6 / 255);
    EXPECT_EQ(marks.At(9, 10)[0], 0.0);
  }
}

// Along an edge through a column of pixels that covers their centres but not all of their groups, a layer is missing.
// Pixels there become the mean of their neighbours with as many layers: those inside, and those above and below, which
// are no better and count 0.3.
TEST(StencilMaskFilter, TakesTheWeightedMeanOfNeighboursAlike)
{
  TestScene scene(40, 30);
  scene.AddPlate(-0.5, { 0.9, 0.2, 0.1, 0.5 });
  scene.AddRectangle(-2.0, -2.0, 0.7 / 15, 2.0, 0.5, { 0.1, 0.9, 0.8, 0.5 });
  vtkNew<vtkStencilMaskTransparencyPass> pass;
  pass->SetNumberOfLayers(9);
  scene.Use(pass);
  const Picture repaired = scene.Render();
  pass->FilterOff();
  const Picture asItIs = scene.Render();
  const double inside = std::exp(-0.5) + 2.0 * std::exp(-1.0) + std::exp(-2.0);
  const double along = 1.0 + 0.3 * 2.0 * (std::exp(-0.5) + std::exp(-2.0));
  Rgba expected;
  for (int c = 0; c < 4; ++c)
  {
    expected[c] = (inside * asItIs.At(18, 15)[c] + along * asItIs.At(20, 15)[c]) / (inside + along);
  }
  ExpectColor(repaired.At(20, 15), expected, 1.1); // of rounded colours, rounded
  EXPECT_GT(std::abs(asItIs.At(20, 15)[1] - asItIs.At(18, 15)[1]), 0.1);
  EXPECT_EQ(repaired.At(18, 15), asItIs.At(18, 15));
  EXPECT_EQ(repaired.At(22, 15), asItIs.At(22, 15));
}

// What no test marks stays as it is, though it differs from its neighbours.
TEST(StencilMaskFilter, LeavesShading)
{
  TestScene scene(40, 40);
  scene.AddSphere(0.0, 0.0, 0.0, 5.0, { 0.9, 0.5, 0.1, 0.5 }, 8)->SetPosition(0.0, 0.0, -4.9);
  vtkNew<vtkStencilMaskTransparencyPass> pass;
  scene.Use(pass);
  pass->ShowMarksOn();
  const Picture marks = scene.Render();
  pass->ShowMarksOff();
  const Picture filtered = scene.Render();
  pass->FilterOff();
  const Picture asItIs = scene.Render();
  int left = 0;
  int wrong = 0;
  for (int i = 0; i < 40 * 40; ++i)
  {
    if (marks.Bytes[4 * i] < 200) // 1.25 of 1.5
    {
      ++left;
      wrong += filtered.At(i % 40, i / 40) != asItIs.At(i % 40, i / 40);
    }
  }
  EXPECT_GT(left, 1000);
  EXPECT_EQ(wrong, 0);
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
  EXPECT_TRUE(Matches(scene.Render(), full));
  EXPECT_EQ(pass->GetBytes(), bytes - 2 * 8 * Width * Height);
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
  ExpectRefusal(pass, "lines and points");
  actor->GetProperty()->SetRepresentationToSurface();
  scene.Render();
  EXPECT_STREQ(pass->GetFallbackReason(), "");
}

}
