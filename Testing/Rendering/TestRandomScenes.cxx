// Seeded scenes of intersecting parts, by every method, against truth.
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkActor.h"

#include <gtest/gtest.h>

namespace
{

double Between(TestRandom& random, double low, double high)
{
  return low + (high - low) * random.Unit();
}

Rgba RandomColor(TestRandom& random)
{
  const double red = random.Unit();
  const double green = random.Unit();
  const double blue = random.Unit();
  return { red, green, blue, Between(random, 0.3, 0.9) };
}

void AddSpheres(TestScene& scene, TestRandom& random, int count)
{
  for (int i = 0; i < count; ++i)
  {
    const double x = Between(random, -0.7, 0.7);
    const double y = Between(random, -0.5, 0.5);
    const double z = Between(random, -0.4, 0.4);
    scene.AddSphere(x, y, z, Between(random, 0.2, 0.5), RandomColor(random));
  }
}

void AddTriangles(TestScene& scene, TestRandom& random, int count)
{
  for (int i = 0; i < count; ++i)
  {
    std::array<std::array<double, 3>, 3> corners;
    for (std::array<double, 3>& corner : corners)
    {
      corner = { Between(random, -2.0, 2.0), Between(random, -1.5, 1.5),
        Between(random, -0.9, 0.9) };
    }
    scene.AddTriangle(corners, RandomColor(random));
  }
}

class RandomScene : public testing::TestWithParam<std::uint64_t>
{
};

TEST_P(RandomScene, OfIntersectingSpheresIsTruth)
{
  TestRandom random(GetParam());
  TestScene scene(90, 70);
  AddSpheres(scene, random, 9);
  ExpectAllAreTruth(scene);
}

TEST_P(RandomScene, OfIntersectingTrianglesIsTruth)
{
  TestRandom random(GetParam());
  TestScene scene(90, 70);
  AddTriangles(scene, random, 12);
  ExpectAllAreTruth(scene);
}

TEST_P(RandomScene, AroundOpaquePartsIsTruth)
{
  TestRandom random(GetParam());
  TestScene scene(90, 70);
  scene.AddSphere(0.2, 0.1, 0.0, 0.45, { 0.8, 0.8, 0.8, 1.0 });
  scene.AddRectangle(-0.9, -0.6, -0.2, 0.6, 0.1, { 0.4, 0.1, 0.1, 1.0 });
  AddSpheres(scene, random, 5);
  AddTriangles(scene, random, 5);
  ExpectAllAreTruth(scene);
}

// Methods that are inexact at edges are exact besides them; this scene has edges in a third of its pixels.
TEST_P(RandomScene, OfSpheresIsTruthBesidesEdges)
{
  TestRandom random(GetParam());
  TestScene scene(180, 140);
  scene.AddSphere(0.2, 0.1, 0.0, 0.45, { 0.8, 0.8, 0.8, 1.0 });
  AddSpheres(scene, random, 4);
  for (const Method& method : MaskMethods())
  {
    SCOPED_TRACE(method.Name);
    ExpectTruth(scene, method.Make(), method.Tolerance, 0.33);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Seeds, RandomScene, testing::Values(1, 2, 3), testing::PrintToStringParamName());

// Each of three triangles lies before the next: no order of whole triangles is right.
TEST(CyclicTriangles, AreTruth)
{
  TestScene scene(90, 70);
  scene.AddTriangle(
    { { { -0.9, -0.5, 0.6 }, { 0.8, -0.7, -0.6 }, { 0.7, -0.3, -0.6 } } }, { 1.0, 0.1, 0.1, 0.5 });
  scene.AddTriangle(
    { { { 0.9, -0.7, 0.6 }, { 0.1, 0.8, -0.6 }, { -0.2, 0.7, -0.6 } } }, { 0.1, 1.0, 0.1, 0.6 });
  scene.AddTriangle(
    { { { 0.1, 0.9, 0.6 }, { -0.7, -0.8, -0.6 }, { -0.5, -0.9, -0.6 } } }, { 0.1, 0.1, 1.0, 0.7 });
  ExpectAllAreTruth(scene);
  for (const Method& method : MaskMethods())
  {
    SCOPED_TRACE(method.Name);
    ExpectTruth(scene, method.Make(), method.Tolerance, method.EdgeShare);
  }
}

}
