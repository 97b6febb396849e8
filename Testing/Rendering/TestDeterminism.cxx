// The same scene is the same picture to the byte: drawn again, and with its actors in any order.
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkActor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{

class Determinism : public testing::TestWithParam<Method>
{
};

void AddClutter(TestScene& scene)
{
  TestRandom random(21);
  for (int i = 0; i < 12; ++i)
  {
    const double x = random.Unit() - 0.5;
    const double y = random.Unit() - 0.5;
    scene.AddSphere(
      x, y, 0.2 * random.Unit(), 0.5, { random.Unit(), random.Unit(), random.Unit(), 0.3 });
  }
}

TEST_P(Determinism, AHundredFramesAreEqual)
{
  TestScene scene(64, 48);
  AddClutter(scene);
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  scene.Use(pass);
  const Picture first = scene.Render();
  for (int frame = 1; frame < 100; ++frame)
  {
    ASSERT_TRUE(Matches(scene.Render(), first)) << "frame " << frame;
  }
}

// Four actors, two of which coincide and one of which cuts through the others.
TEST_P(Determinism, AllOrdersOfFourActorsAreEqual)
{
  TestScene scene(40, 30);
  std::array<vtkSmartPointer<vtkActor>, 4> actors = {
    scene.AddRectangle(-0.8, -0.8, 0.4, 0.4, 0.1, { 0.9, 0.1, 0.2, 0.5 }),
    scene.AddRectangle(-0.4, -0.4, 0.8, 0.8, 0.1, { 0.1, 0.9, 0.2, 0.5 }),
    scene.AddSphere(0.0, 0.0, 0.0, 0.6, { 0.2, 0.3, 0.9, 0.4 }),
    scene.AddTriangle(
      { { { -0.9, -0.9, -0.5 }, { 0.9, -0.6, 0.1 }, { 0.0, 0.9, 0.7 } } }, { 0.9, 0.9, 0.3, 0.6 }),
  };
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  scene.Use(pass);
  const Picture first = scene.Render();
  std::array<int, 4> order;
  std::iota(order.begin(), order.end(), 0);
  while (std::next_permutation(order.begin(), order.end()))
  {
    scene.Renderer->RemoveAllViewProps();
    for (const int i : order)
    {
      scene.Renderer->AddActor(actors[i]);
    }
    // Places of a group that another order chooses round differently, by a step.
    EXPECT_TRUE(
      Matches(scene.Render(), first, GetParam().EdgeShare > 0.0 ? 1 : 0, GetParam().EdgeShare))
      << order[0] << order[1] << order[2] << order[3];
  }
}

// Among equal depths the smaller packed colour is the nearer: compared by alpha, blue, green, red.
TEST_P(Determinism, CoincidentPlatesOrderByPackedColor)
{
  const std::vector<std::vector<Rgba>> stacks = {
    { { 1.0, 1.0, 1.0, 0.2 }, { 0.0, 0.0, 0.0, 0.6 } }, // alpha first
    { { 1.0, 1.0, 0.2, 0.6 }, { 0.0, 0.0, 0.8, 0.6 } }, // then blue
    { { 1.0, 0.2, 0.4, 0.6 }, { 0.0, 0.8, 0.4, 0.6 } }, // then green
    { { 0.2, 0.6, 0.4, 0.6 }, { 0.8, 0.6, 0.4, 0.6 } }, // then red
    { { 0.2, 0.6, 0.4, 0.6 }, { 0.2, 0.6, 0.4, 0.6 }, { 0.8, 0.6, 0.4, 0.6 } },
    { { 0.2, 0.6, 0.4, 0.2 }, { 0.2, 0.6, 0.4, 0.4 }, { 0.2, 0.4, 0.6, 0.4 },
      { 0.2, 0.6, 0.6, 0.4 }, { 0.4, 0.6, 0.6, 0.4 }, { 0.0, 0.0, 0.0, 0.6 } },
  };
  for (const std::vector<Rgba>& stack : stacks)
  {
    TestScene scene(8, 6);
    for (const bool reversed : { false, true })
    {
      scene.Renderer->RemoveAllViewProps();
      std::vector<Rgba> order = stack;
      if (reversed)
      {
        std::reverse(order.begin(), order.end());
      }
      for (const Rgba& color : order)
      {
        scene.AddPlate(0.25, color);
      }
      SCOPED_TRACE(std::to_string(stack.size()) + " plates" + (reversed ? ", reversed" : ""));
      scene.Use(GetParam().Make());
      ExpectColor(UniformColor(scene.Render()), CompositePlates(stack, TestBackground), 0.6);
    }
  }
}

// Ties in lists of every bin: each plate stands at one of three heights.
TEST_P(Determinism, ManyCoincidentPlatesOrderByPackedColor)
{
  for (const int layers : { 8, 13, 24, 40, 64, 65, 100, 1100 })
  {
    if (!GetParam().Keeps(layers))
    {
      continue;
    }
    SCOPED_TRACE(std::to_string(layers) + " layers");
    TestScene scene(6, 5);
    std::vector<Rgba> plates = RandomPlates(layers, layers > 100 ? 0.01 : 0.2, 31);
    for (std::size_t i = 0; i + 3 < plates.size(); i += 5)
    {
      plates[i + 3] = plates[i]; // twins, at the same height
    }
    std::vector<double> heights;
    std::vector<std::vector<Rgba>> byHeight(3);
    for (int i = 0; i < layers; ++i)
    {
      heights.push_back(0.5 - 0.5 * (i % 3));
      byHeight[i % 3].push_back(plates[i]);
    }
    scene.AddPlates(plates, heights, 32);
    std::vector<Rgba> sorted;
    for (std::vector<Rgba>& height : byHeight)
    {
      std::sort(height.begin(), height.end(),
        [](const Rgba& a, const Rgba& b)
        { return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend()); });
      sorted.insert(sorted.end(), height.begin(), height.end());
    }
    scene.Use(GetParam().Make());
    ExpectColor(UniformColor(scene.Render()), CompositePlates(sorted, TestBackground), 0.75);
  }
}

// None of many fragments that are the same to the bit is taken for another, however many a method sorts at a time.
TEST_P(Determinism, EqualFragmentsAllCount)
{
  for (const int layers : { 2, 9, 65, 200, 1100 })
  {
    if (!GetParam().Keeps(layers))
    {
      continue;
    }
    SCOPED_TRACE(std::to_string(layers) + " layers");
    TestScene scene(6, 5);
    const double alpha = std::ceil(3.0 * 255.0 / (layers + 5)) / 255.0; // exact in 8 bits
    const std::vector<Rgba> plates(layers, { 0.8, 0.6, 0.2, alpha });
    scene.AddPlates(plates, std::vector<double>(layers, 0.25), 8);
    scene.Use(GetParam().Make());
    ExpectColor(UniformColor(scene.Render()), CompositePlates(plates, TestBackground), 0.75);
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Determinism, testing::ValuesIn(AllMethods()), MethodName());

}
