// Multisampled windows: opaque and translucent edges antialiased, exact in every sample.
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkABufferTransparencyPass.h"
#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkRenderStepsPass.h"
#include "vtkShaderProperty.h"
#include "vtkTranslucentPass.h"
#include "vtkTruthTransparencyPass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <set>

namespace
{

constexpr int Samples = 4;

// Each of a pixel's samples is rounded to 8 bits, for which tolerances leave room, and so is their mean.
constexpr double RoundingOfMeans = 0.5;

void AddParts(TestScene& scene)
{
  scene.AddSphere(0.3, 0.1, 0.2, 0.5, { 0.9, 0.5, 0.1, 0.4 });
  scene.AddSphere(-0.2, -0.1, -0.3, 0.7, { 0.1, 0.5, 0.9, 0.6 });
  scene.AddSphere(0.0, 0.3, 0.1, 0.4, { 0.6, 0.1, 0.9, 0.5 });
  scene.AddTriangle(
    { { { -0.9, -0.9, -0.5 }, { 0.9, -0.6, 0.1 }, { 0.0, 0.9, 0.7 } } }, { 0.9, 0.9, 0.3, 0.6 });
}

void AddOpaqueParts(TestScene& scene)
{
  scene.AddTriangle(
    { { { -0.9, 0.4, 0.8 }, { 0.1, -0.3, 0.8 }, { 0.2, 0.1, 0.8 } } }, { 1.0, 1.0, 1.0, 1.0 });
  scene.AddSphere(0.3, -0.4, 0.0, 0.4, { 0.8, 0.3, 0.3, 1.0 });
}

bool IsBetween(const Rgba& a, const Rgba& b, const Rgba& color)
{
  bool between = true;
  bool differs[2] = { false, false };
  for (int c = 0; c < 3; ++c)
  {
    between = between && color[c] >= std::min(a[c], b[c]) && color[c] <= std::max(a[c], b[c]);
    differs[0] = differs[0] || color[c] != a[c];
    differs[1] = differs[1] || color[c] != b[c];
  }
  return between && differs[0] && differs[1];
}

class Multisampling : public testing::TestWithParam<Method>
{
};

TEST_P(Multisampling, PartsAreTruth)
{
  TestScene scene(61, 47, Samples);
  AddParts(scene);
  ExpectTruth(scene, GetParam().Make(), GetParam().Tolerance + RoundingOfMeans);
}

TEST_P(Multisampling, PartsBehindAndThroughOpaqueOnesAreTruth)
{
  for (const bool stencil : { false, true })
  {
    TestScene scene(61, 47, Samples);
    scene.Window->SetStencilCapable(stencil);
    AddParts(scene);
    AddOpaqueParts(scene);
    ExpectTruth(scene, GetParam().Make(), GetParam().Tolerance + RoundingOfMeans);
  }
}

TEST_P(Multisampling, WritersOfDepthAreTruth)
{
  TestScene scene(61, 47, Samples);
  AddParts(scene);
  AddOpaqueParts(scene);
  scene.AddRectangle(-0.8, -0.5, 0.7, 0.6, -0.3, { 0.3, 0.9, 0.3, 0.5 })
    ->GetShaderProperty()
    ->AddFragmentShaderReplacement("//VTK::Depth::Impl", true,
      "gl_FragDepth = gl_FragCoord.z - 0.002 * gl_FragCoord.x;\n", false);
  ExpectTruth(scene, GetParam().Make(), GetParam().Tolerance + RoundingOfMeans);
}

// One layer needs no sorting: VTK's own blending of it is right, but for its rounding.
TEST_P(Multisampling, OneLayerIsAsVTKBlendsIt)
{
  TestScene scene(61, 47, Samples);
  AddOpaqueParts(scene);
  scene.AddTriangle(
    { { { -0.9, -0.9, -0.1 }, { 0.9, -0.6, -0.1 }, { 0.0, 0.9, -0.1 } } }, { 0.9, 0.9, 0.3, 0.6 });
  vtkNew<vtkTranslucentPass> blending;
  scene.Use(blending);
  const Picture expected = scene.Render();
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  scene.Use(pass);
  EXPECT_TRUE(Matches(scene.Render(), expected, 1));
  EXPECT_EQ(pass->GetMaximumNumberOfLayers(), 1);
}

TEST_P(Multisampling, OpaqueEdgesStayAntialiased)
{
  TestScene scene(61, 47, Samples);
  AddOpaqueParts(scene);
  vtkNew<vtkRenderStepsPass> steps;
  scene.Renderer->SetPass(steps);
  const Picture opaque = scene.Render();
  // What lies behind everything changes nothing in front of it.
  scene.AddPlate(-0.9, { 1.0, 0.0, 0.0, 0.5 });
  scene.Use(GetParam().Make());
  const Picture picture = scene.Render();
  const Rgba front = { 1.0, 1.0, 1.0, 1.0 };
  const Rgba behind = picture.At(60, 46);
  int edges = 0;
  for (int y = 0; y < 47; ++y)
  {
    for (int x = 0; x < 61; ++x)
    {
      if (opaque.At(x, y) == front)
      {
        ASSERT_EQ(picture.At(x, y), front) << x << ", " << y;
      }
      edges += IsBetween(front, behind, picture.At(x, y)) ? 1 : 0;
    }
  }
  EXPECT_GT(edges, 10);
}

// Lists of every bin.
TEST_P(Multisampling, StacksAreTheClosedForm)
{
  TestScene scene(9, 6, Samples);
  scene.Use(GetParam().Make());
  for (const int layers : { 3, 60, 200, 1100 })
  {
    SCOPED_TRACE(std::to_string(layers) + " layers");
    const std::vector<Rgba> plates = RandomPlates(layers, std::max(1.0 / 255, 1.0 / layers), 7);
    const vtkSmartPointer<vtkActor> actor = scene.AddPlates(plates, 8);
    ExpectColor(UniformColor(scene.Render()), CompositePlates(plates, TestBackground), 0.75);
    scene.Renderer->RemoveActor(actor);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Methods, Multisampling, testing::ValuesIn(MultisamplingMethods()), MethodName());

// A vertical edge from the left through every fraction of a pixel: as much of the plate as samples are covered.
class MultisamplingClosedForm : public Multisampling
{
};

TEST_P(MultisamplingClosedForm, CoverageIsWhatOneSampleInFourIsWorth)
{
  const Rgba plate = { 1.0, 0.0, 0.0, 1.0 / 255 * 204 };
  std::set<int> coverages;
  TestScene scene(8, 8, Samples);
  scene.Use(GetParam().Make());
  for (int step = 0; step < 16; ++step)
  {
    const double edge = (step + 0.5) / 16.0 * 0.25; // through the pixel at x = 4
    const vtkSmartPointer<vtkActor> actor = scene.AddRectangle(-2.0, -2.0, edge, 2.0, 0.0, plate);
    const Picture picture = scene.Render();
    scene.Renderer->RemoveActor(actor);
    const Rgba full = CompositePlates({ plate }, TestBackground);
    const double share = (picture.At(4, 4)[0] - TestBackground[0]) / (full[0] - TestBackground[0]);
    EXPECT_NEAR(Samples * share, std::lround(Samples * share), 0.03) << "edge at " << edge;
    coverages.insert(static_cast<int>(std::lround(Samples * share)));
    EXPECT_NEAR(picture.At(3, 4)[0], full[0], 0.6 / 255);
    EXPECT_NEAR(picture.At(5, 4)[0], TestBackground[0], 0.6 / 255);
  }
  EXPECT_EQ(coverages, (std::set<int>{ 0, 1, 2, 3, 4 }));
}

INSTANTIATE_TEST_SUITE_P(
  Methods, MultisamplingClosedForm, testing::ValuesIn(MultisamplingMethods()), MethodName());

class MultisamplingBands : public Multisampling
{
};

TEST_P(MultisamplingBands, AreTheWholePicture)
{
  TestScene scene(61, 47, Samples);
  AddParts(scene);
  AddOpaqueParts(scene);
  const vtkSmartPointer<vtkABufferTransparencyPass> pass = MakeABuffer(GetParam());
  scene.Use(pass);
  const Picture whole = scene.Render();
  EXPECT_EQ(pass->GetNumberOfBands(), 1);
  const vtkTypeInt64 bytes = pass->GetNumberOfFragments() * 12; // at least, with their coverage
  for (const int parts : { 3, 5, 8, 20, 60 })
  {
    SCOPED_TRACE(parts);
    pass->SetMemoryLimit(bytes / parts);
    EXPECT_TRUE(Matches(scene.Render(), whole));
    EXPECT_GE(pass->GetNumberOfBands(), parts);
    EXPECT_LE(pass->GetPoolBytes(), std::max<vtkTypeInt64>(pass->GetMemoryLimit(), 16 * 20));
    EXPECT_STREQ(pass->GetFallbackReason(), "");
  }
}

INSTANTIATE_TEST_SUITE_P(
  Methods, MultisamplingBands, testing::ValuesIn(ABufferMethods()), MethodName());

// Software sorts a pixel's list once, and each sample has the bits that a sort of its own gives, as devices do it.
// There are edges, opaque parts that cut glass, and lists of every bin.
class MultisamplingOneSort : public Multisampling
{
protected:
  static Picture Draw(const Method& method, int layers)
  {
    TestScene scene(61, 47, Samples);
    AddParts(scene);
    AddOpaqueParts(scene);
    scene.AddPlates(RandomPlates(layers, 1.0 / layers, 7), 8);
    scene.Use(method.Make());
    return scene.Render();
  }
};

TEST_P(MultisamplingOneSort, HasTheBitsOfOneSortASample)
{
  for (const int layers : { 3, 9, 25, 50, 150, 1100 })
  {
    SCOPED_TRACE(std::to_string(layers) + " layers");
    const Picture once = Draw(GetParam(), layers);
    setenv("VITRINE_DEVICE", "no-software", 1);
    const Picture ofEach = Draw(GetParam(), layers);
    unsetenv("VITRINE_DEVICE");
    EXPECT_TRUE(Matches(once, ofEach));
  }
}

INSTANTIATE_TEST_SUITE_P(
  Methods, MultisamplingOneSort, testing::ValuesIn(ABufferMethods()), MethodName());

class MultisamplingRefused : public Multisampling
{
};

TEST_P(MultisamplingRefused, IsSaidAndDrawnAsVTKDoes)
{
  TestScene scene(61, 47, Samples);
  AddParts(scene);
  AddOpaqueParts(scene);
  const Picture byVTK = scene.RenderAsVTK();
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  scene.Use(pass);
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_TRUE(Matches(scene.Render(), byVTK));
  }
  ExpectRefusal(pass, GetParam().RefusesSamples);
}

INSTANTIATE_TEST_SUITE_P(
  Methods, MultisamplingRefused, testing::ValuesIn(SingleSampleMethods()), MethodName());

}
