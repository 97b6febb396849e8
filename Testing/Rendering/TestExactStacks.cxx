// Stacks of plates around the limits of every bin, against the answer known in closed form.
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/Capabilities.h"
#include "vtkABufferTransparencyPass.h"
#include "vtkActor.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>

namespace
{

constexpr int Width = 20;
constexpr int Height = 18;

class ExactStack : public testing::TestWithParam<Method>
{
};

void ExpectClosedForm(const Picture& picture, const std::vector<Rgba>& plates, double tolerance)
{
  ExpectColor(UniformColor(picture), CompositePlates(plates, TestBackground), tolerance);
}

TEST_P(ExactStack, IsTheClosedForm)
{
  TestScene scene(Width, Height);
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  scene.Use(pass);
  for (const int layers : { 1, 2, 7, 8, 9, 15, 16, 17, 23, 24, 25, 31, 32, 33, 47, 48, 49, 63, 64,
         65, 95, 96, 97, 127, 128, 129, 200, 1000, 1023, 1024, 1025 })
  {
    if (!GetParam().Keeps(layers))
    {
      continue;
    }
    SCOPED_TRACE(std::to_string(layers) + " layers");
    // Faint enough for the farthest to show.
    const double alpha = std::max(std::min(0.5, 3.0 / layers), 0.004);
    const std::vector<Rgba> plates = RandomPlates(layers, alpha, 7);
    const vtkSmartPointer<vtkActor> actor = scene.AddPlates(plates, 8);
    ExpectClosedForm(scene.Render(), plates, std::max(0.6, GetParam().Tolerance * 0.5));
    EXPECT_STREQ(pass->GetFallbackReason(), "");
    EXPECT_EQ(pass->GetMaximumNumberOfLayers(), layers);
    EXPECT_EQ(pass->GetNumberOfFragments(), layers * Width * Height);
    EXPECT_EQ(pass->GetMeanNumberOfLayers(), layers);
    scene.Renderer->RemoveActor(actor);
  }
}

TEST_P(ExactStack, Of4000Layers)
{
  TestScene scene(3, 2);
  const std::vector<Rgba> plates = RandomPlates(4000, 1.0 / 255, 9);
  scene.AddPlates(plates, 10);
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  scene.Use(pass);
  const Picture picture = scene.Render();
  if (!GetParam().Keeps(4000))
  {
    EXPECT_GT(pass->GetNumberOfLostFragments(), 0);
    EXPECT_EQ(pass->GetNumberOfSaturatedPixels(), 3 * 2);
    TakeMessages();
    return;
  }
  ExpectClosedForm(picture, plates, 0.6);
  EXPECT_EQ(pass->GetNumberOfLostFragments(), 0);
  EXPECT_EQ(pass->GetMaximumNumberOfLayers(), 4000);
  EXPECT_EQ(pass->GetNumberOfFragments(), 4000 * 3 * 2);
}

// Lists are so long that the work on each must not grow with their square. Drivers end the loops of a shader after a
// number of rounds, llvmpipe after 65,535 in all. Layers, of one depth or apart, are so faint that together they take a
// fifth of a step, and a plate shows behind them.
TEST_P(ExactStack, SeesThroughAnyNumberOfFaintLayers)
{
  TestScene scene(2, 1);
  const Rgba behind = { 1.0, 0.0, 0.2, 0.8 };
  scene.AddPlate(-0.95, behind);
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  scene.Use(pass);
  for (const int layers : { 5000, 9000, 19999 })
  {
    for (const double spacing : { 0.0, 1.8 / layers })
    {
      if (!GetParam().Keeps(layers + 1))
      {
        continue;
      }
      SCOPED_TRACE(std::to_string(layers) + " layers " + std::to_string(spacing) + " apart");
      std::vector<double> heights(layers);
      for (int i = 0; i < layers; ++i)
      {
        heights[i] = 0.9 - spacing * i;
      }
      const vtkSmartPointer<vtkActor> actor =
        scene.AddPlates(RandomPlates(layers, 1.0 / 255, 11), heights, 12);
      actor->GetProperty()->SetOpacity(1e-5);
      ExpectClosedForm(scene.Render(), { behind }, std::max(0.6, GetParam().Tolerance * 0.5) + 0.2);
      EXPECT_EQ(pass->GetMaximumNumberOfLayers(), layers + 1);
      scene.Renderer->RemoveActor(actor);
    }
  }
}

// llvmpipe would drop the farthest in silence.
TEST_P(ExactStack, RefusesLongerListsThanTheDriversLoops)
{
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  if (!vtkABufferTransparencyPass::SafeDownCast(pass))
  {
    GTEST_SKIP() << "it keeps no lists";
  }
  TestScene scene(1, 1);
  scene.Use(pass);
  scene.AddPlates(RandomPlates(20000, 1.0 / 255, 13), 14);
  scene.Render();
  EXPECT_STREQ(pass->GetFallbackReason(), "");
  if (!vitrine::IsSoftwareRasteriser())
  {
    GTEST_SKIP() << "the driver is not known to end loops";
  }
  scene.AddPlate(-0.95, { 1.0, 0.0, 0.2, 0.5 });
  scene.Render();
  ExpectRefusal(pass, "a pixel has 20001 fragments");
}

// Neighbours of every length, so that tiles hold lists of many lengths and bins lie side by side.
TEST_P(ExactStack, WithADifferentLengthInEveryColumn)
{
  const int steps = GetParam().Keeps(140) ? 140 : GetParam().MaxLayers;
  TestScene scene(steps, 2);
  std::vector<Rgba> plates = RandomPlates(steps, 0.02, 15);
  for (int i = 0; i < steps; ++i)
  {
    // Plate i covers the columns from i on, and lies behind the plates before it.
    const double left = -0.5 * steps + i;
    scene.AddRectangle(left, -1.0, 0.5 * steps, 1.0, 0.9 - 0.01 * i, plates[i]);
  }
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  scene.Use(pass);
  const Picture picture = scene.Render();
  EXPECT_EQ(pass->GetMaximumNumberOfLayers(), steps);
  EXPECT_EQ(pass->GetNumberOfFragments(), steps * (steps + 1) / 2 * 2);
  for (int x = 0; x < steps; ++x)
  {
    SCOPED_TRACE("column " + std::to_string(x));
    const std::vector<Rgba> here(plates.begin(), plates.begin() + x + 1);
    ExpectColor(picture.At(x, 1), CompositePlates(here, TestBackground), 0.75);
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, ExactStack, testing::ValuesIn(AllMethods()), MethodName());

}
