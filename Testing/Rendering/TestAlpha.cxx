// The ends of alpha's range, faint layers by the thousand, and transparent and graded backgrounds.
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkActor.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkTranslucentPass.h"

#include <gtest/gtest.h>

namespace
{

class Alpha : public testing::TestWithParam<Method>
{
};

TEST_P(Alpha, FromZeroToOne)
{
  for (const double alpha : { 0.0, 1.0 / 255, 0.4, 1.0 })
  {
    SCOPED_TRACE(alpha);
    TestScene scene(6, 5);
    std::vector<Rgba> plates = RandomPlates(6, 0.4, 1);
    plates[2][3] = alpha;
    scene.AddPlates(plates, 2);
    scene.Use(GetParam().Make());
    ExpectColor(UniformColor(scene.Render()), CompositePlates(plates, TestBackground), 0.75);
  }
}

// In front of everything, alpha 1 leaves nothing of it, and alpha 0 everything.
TEST_P(Alpha, OneInFrontHidesExactly)
{
  for (const int layers : { 1, 8, 20, 70, 200 })
  {
    if (!GetParam().Keeps(layers))
    {
      continue;
    }
    TestScene scene(6, 5);
    std::vector<Rgba> plates = RandomPlates(layers, 0.4, 3);
    plates[0] = { 0.2, 0.8, 0.4, 1.0 };
    scene.AddPlates(plates, 4);
    scene.Use(GetParam().Make());
    EXPECT_EQ(UniformColor(scene.Render()), plates[0]) << layers << " layers";
  }
}

// Storage rounds to the nearest: what lies alone keeps its colour to half a step.
TEST_P(Alpha, OneKeepsAnyColor)
{
  TestScene scene(6, 5);
  for (const double step : { 0.1, 0.3, 0.7, 0.9 })
  {
    const Rgba color = { (100.0 + step) / 255, (30.0 + step) / 255, (200.0 + step) / 255, 1.0 };
    const vtkSmartPointer<vtkActor> actor = scene.AddPlate(0.0, color);
    actor->ForceTranslucentOn();
    scene.Use(GetParam().Make());
    ExpectColor(UniformColor(scene.Render()), color, 0.51);
    scene.Renderer->RemoveActor(actor);
  }
}

TEST_P(Alpha, ZeroIsAsIfNothingWereThere)
{
  TestScene scene(6, 5);
  scene.AddPlates(RandomPlates(20, 0.0, 5), 6);
  scene.AddRectangle(-2.0, -2.0, 2.0, 2.0, 0.0, { 1.0, 1.0, 1.0, 0.0 });
  scene.Use(GetParam().Make());
  EXPECT_EQ(UniformColor(scene.Render()), TestBackground);
}

TEST_P(Alpha, OfAnyBackground)
{
  for (const double alpha : { 0.0, 0.4, 1.0 })
  {
    SCOPED_TRACE(alpha);
    TestScene scene(6, 5);
    scene.Renderer->SetBackgroundAlpha(alpha);
    const std::vector<Rgba> plates = RandomPlates(9, 0.2, 7);
    scene.AddPlates(plates, 8);
    scene.Use(GetParam().Make());
    Rgba background = TestBackground;
    background[3] = alpha;
    ExpectColor(UniformColor(scene.Render()), CompositePlates(plates, background), 0.75);
  }
}

TEST_P(Alpha, OverAGradedBackground)
{
  TestScene scene(20, 30);
  scene.Renderer->GradientBackgroundOn();
  scene.Renderer->SetBackground2(0.9, 0.1, 0.5);
  scene.AddRectangle(-0.5, -0.8, 0.5, 0.8, 0.0, { 0.4, 0.8, 0.2, 0.4 });
  vtkNew<vtkTranslucentPass> blending;
  scene.Use(blending);
  const Picture expected = scene.Render();
  scene.Use(GetParam().Make());
  EXPECT_TRUE(Matches(scene.Render(), expected, 1, GetParam().EdgeShare));
}

INSTANTIATE_TEST_SUITE_P(Methods, Alpha, testing::ValuesIn(AllMethods()), MethodName());

// A thousand faint layers: each counts in half floats.
class FaintLayers : public Alpha
{
};

TEST_P(FaintLayers, AddUp)
{
  TestScene scene(5, 4);
  const Rgba plate = { 0.2, 0.8, 1.0, 0.004 };
  const std::vector<Rgba> plates(1000, plate);
  // Of the property, whose alpha is a float, where those of vertices are bytes.
  const vtkSmartPointer<vtkActor> actor = scene.AddPlates(plates, 9);
  actor->GetMapper()->ScalarVisibilityOff();
  actor->GetProperty()->SetColor(plate[0], plate[1], plate[2]);
  actor->GetProperty()->SetOpacity(plate[3]);
  const Picture picture = ExpectTruth(scene, GetParam().Make(), 0.75);
  ExpectColor(UniformColor(picture), CompositePlates(plates, TestBackground), 0.75);
}

// 8 bits round this alpha by a fiftieth.
INSTANTIATE_TEST_SUITE_P(Methods, FaintLayers,
  testing::ValuesIn(MethodsThat(
    [](const Method& method) { return !method.KeepsEightBits() && method.Keeps(1000); })),
  MethodName());

}
