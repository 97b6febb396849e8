// Picking through a renderer with the pass set finds what it finds without it, and leaves the picture alone.
#include "Select.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkActor.h"
#include "vtkPropPicker.h"

#include <gtest/gtest.h>

#include <set>

namespace
{

constexpr int Width = 80;
constexpr int Height = 60;

void AddParts(TestScene& scene)
{
  scene.AddSphere(-0.4, 0.0, -0.2, 0.5, { 0.9, 0.5, 0.1, 1.0 });
  scene.AddSphere(0.3, 0.1, 0.2, 0.5, { 0.9, 0.5, 0.1, 0.4 });
  scene.AddSphere(0.6, -0.3, -0.3, 0.5, { 0.1, 0.5, 0.9, 0.6 });
  scene.AddRectangle(-1.0, -0.9, 0.2, -0.2, 0.4, { 0.2, 0.9, 0.2, 0.3 });
}

std::vector<vtkProp*> PickProps(TestScene& scene)
{
  std::vector<vtkProp*> picked;
  vtkNew<vtkPropPicker> picker;
  for (int y = 2; y < Height; y += 11)
  {
    for (int x = 2; x < Width; x += 13)
    {
      picked.push_back(picker->PickProp(x, y, scene.Renderer) ? picker->GetViewProp() : nullptr);
    }
  }
  return picked;
}

class Picking : public testing::TestWithParam<Method>
{
};

TEST_P(Picking, FindsWhatItFindsWithoutThePass)
{
  for (const int samples : GetParam().Samples())
  {
    SCOPED_TRACE(std::to_string(samples) + " samples");
    TestScene scene(Width, Height, samples);
    AddParts(scene);
    scene.Render();
    const int cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;
    const int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
    const Picked area = Select(scene.Renderer, cells, 5, 4, 70, 50);
    const Picked areaPoints = Select(scene.Renderer, points, 5, 4, 70, 50);
    const Picked point = Select(scene.Renderer, cells, 55, 32, 55, 32);
    const std::vector<vtkProp*> props = PickProps(scene);
    ASSERT_EQ(area.size(), 4u);
    ASSERT_EQ(point.size(), 1u);
    ASSERT_EQ(std::set<vtkProp*>(props.begin(), props.end()).size(), 5u); // none, too

    const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
    scene.Use(pass);
    const Picture before = scene.Render();
    EXPECT_EQ(Select(scene.Renderer, cells, 5, 4, 70, 50), area);
    EXPECT_EQ(Select(scene.Renderer, points, 5, 4, 70, 50), areaPoints);
    EXPECT_EQ(Select(scene.Renderer, cells, 55, 32, 55, 32), point);
    EXPECT_EQ(PickProps(scene), props);
    EXPECT_TRUE(Matches(scene.Render(), before));
    EXPECT_STREQ(pass->GetFallbackReason(), "");
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Picking, testing::ValuesIn(AllMethods()), MethodName());

}
