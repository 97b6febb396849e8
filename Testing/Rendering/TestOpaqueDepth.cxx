// What compares with a copy of an opaque depth of 32 bits hides what the depth buffer hides, to the last bit.
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkTruthTransparencyPass.h"

#include <gtest/gtest.h>

namespace
{

// Triangles of one oblique plane: a pixel's depths are the same but for the rounding of each.
class CoplanarTriangles
{
public:
  void Add(TestScene& scene, const Rgba& color)
  {
    scene.AddTriangle(
      { this->Corner(-3.0, -3.0), this->Corner(3.0, -3.0), this->Corner(0.0, 5.0) }, color);
  }

private:
  std::array<double, 3> Corner(double x, double y)
  {
    x += this->Random.Unit();
    y += this->Random.Unit();
    return { x, y, 0.013 * x + 0.0071 * y };
  }

  TestRandom Random = TestRandom(31);
};

vtkTypeInt64 FragmentsOfTruth(TestScene& scene)
{
  vtkNew<vtkTruthTransparencyPass> truth;
  scene.Use(truth);
  scene.Render();
  return truth->GetNumberOfFragments();
}

// How far the far plane is behind the oblique one: depths close to 1, halfway, and close to 0.
class OpaqueDepth : public testing::TestWithParam<double>
{
};

TEST_P(OpaqueDepth, OfAnObliquePlaneHidesWhatLiesInItAsTheDepthBufferDoes)
{
  TestScene scene(40, 30);
  scene.Renderer->GetActiveCamera()->SetClippingRange(
    GetParam() < 1.0 ? 0.5 : 1.9, 2.0 + GetParam());
  CoplanarTriangles triangles;
  for (int i = 0; i < 6; ++i)
  {
    triangles.Add(scene, { 0.1 * i, 0.5, 0.9, 0.4 });
  }
  const vtkTypeInt64 all = FragmentsOfTruth(scene);
  triangles.Add(scene, { 0.9, 0.4, 0.1, 1.0 });
  const vtkTypeInt64 seen = FragmentsOfTruth(scene);
  EXPECT_GT(seen, all / 20);
  EXPECT_LT(seen, all - all / 20);
  for (const Method& method : RoutedMethods())
  {
    SCOPED_TRACE(method.Name);
    ExpectTruth(scene, method.Make(), method.Tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(Planes, OpaqueDepth, testing::Values(0.1, 1.0, 100.0));

}
