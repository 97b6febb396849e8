// The linked-list pass against answers known in closed form.
#include "TestScene.h"

#include "vtkActor.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkTruthTransparencyPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace
{

struct Stack
{
  int Layers;
  double Alpha;
};

// Plates front to back, added to the scene in a shuffled order.
std::vector<Rgba> AddStack(TestScene& scene, const Stack& stack, std::uint64_t seed)
{
  TestRandom random(seed);
  std::vector<Rgba> plates;
  for (int i = 0; i < stack.Layers; ++i)
  {
    plates.push_back({ random.Unit(), random.Unit(), random.Unit(), stack.Alpha });
  }
  std::vector<int> order(plates.size());
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i)
  {
    std::swap(order[i - 1], order[random.Next() % i]);
  }
  for (const int i : order)
  {
    scene.AddPlate(0.9 - 1.8 * (i + 0.5) / stack.Layers, plates[i]);
  }
  return plates;
}

class ExactStack : public testing::TestWithParam<Stack>
{
};

TEST_P(ExactStack, LinkedListIsTheClosedForm)
{
  TestScene scene(20, 18);
  const std::vector<Rgba> plates = AddStack(scene, GetParam(), 7);
  const Rgba expected = CompositePlates(plates, { 0.2, 0.3, 0.4, 1.0 });
  vtkNew<vtkLinkedListTransparencyPass> pass;
  scene.Use(pass);
  const Picture picture = scene.Render();
  EXPECT_STREQ(pass->GetFallbackReason(), "");
  EXPECT_EQ(pass->GetLayersMax(), GetParam().Layers);
  EXPECT_EQ(pass->GetFragmentCount(), GetParam().Layers * 20 * 18);
  for (int y = 0; y < 18; ++y)
  {
    for (int x = 0; x < 20; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        ASSERT_NEAR(picture.At(x, y)[c], expected[c], 0.6 / 255)
          << x << ", " << y << ", channel " << c;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Layers, ExactStack,
  testing::Values(Stack{ 1, 0.5 }, Stack{ 2, 0.5 }, Stack{ 7, 0.3 }, Stack{ 8, 0.3 },
    Stack{ 9, 0.3 }, Stack{ 64, 0.1 }, Stack{ 65, 0.1 }, Stack{ 200, 0.01 }, Stack{ 1000, 0.004 }));

}
