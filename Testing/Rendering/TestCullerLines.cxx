// Tests lines and points, which are drawn beyond their ends and beyond a viewport's border. Culling must lose no pixel.
#include "CullerScene.h"

#include <gtest/gtest.h>

namespace
{

class CullerLines : public CullerTest
{
protected:
  vtkSmartPointer<vtkActor> AddLine(const Point3& from, const Point3& to, double green)
  {
    return Scene.AddLine(from, to, { 0.9, green, 0.1, 1.0 });
  }
};

}

// They end close behind the wall, and go on through it where they are drawn beyond that.
TEST_P(CullerLines, BehindAWallThatAreSeenFromTheirEnd)
{
  Scene.AddWall();
  TestRandom random(410);
  std::vector<vtkSmartPointer<vtkActor>> lines;
  for (int i = 0; i < 400; ++i)
  {
    const double x = 1.6 * random.Unit() - 0.8, y = 1.6 * random.Unit() - 0.8;
    const double away = Scene.Setting.IsParallel ? 1.0 : 1.1; // along the view
    const double aside = Scene.PixelSize() * (2.0 * random.Unit() - 1.0);
    lines.push_back(
      this->AddLine({ x, y, -0.002 }, { away * x + aside, away * y, -0.35 }, 0.002 * i));
  }
  Scene.LookAhead();
  EXPECT_TRUE(Scene.ShowsUnculled(lines));
  EXPECT_EQ(Scene.ExpectSame(), 0) << "each may be drawn through the wall";
  Scene.AddHidden();
  EXPECT_EQ(Scene.ExpectSame(), 63) << "boxes are not";
}

TEST_P(CullerLines, BehindAWallAreHiddenOtherwise)
{
  Scene.AddWall();
  for (int i = 0; i < 20; ++i)
  {
    this->AddLine({ -0.6, 0.05 * i - 0.5, -0.1 }, { 0.6, 0.05 * i - 0.45, -0.2 }, 0.04 * i);
  }
  Scene.LookAhead();
  EXPECT_EQ(Scene.ExpectSame(), 20);
}

// Nothing hides what they have beside the viewport.
TEST_P(CullerLines, ReachBeyondAViewport)
{
  Scene.AddWall();
  const double z = -0.05, top = 0.5 * Scene.PixelSize() * Scene.Setting.Height;
  const double away = Scene.Setting.IsParallel ? 1.0 : 1.0 - z / 3.6; // from where the eye is
  std::vector<vtkSmartPointer<vtkActor>> drawn;
  for (int i = 0; i < 40; ++i)
  {
    const double beside = (i % 2 ? 1.0 - 0.001 * i : 0.001 * i - 1.0) * top;
    const double x = away * beside * Scene.Setting.Width / Scene.Setting.Height;
    const double y = 0.04 * i - 0.8;
    const bool isOfPoints = i % 4 < 2;
    drawn.push_back(isOfPoints ? Scene.AddBox({ x, y, z }, { 0.002, 0.05, 0.002 })
                               : this->AddLine({ x, y, z }, { x, y + 0.1, z }, 0.02 * i));
    drawn.back()->GetProperty()->SetLineWidth(5.0f);
    drawn.back()->GetProperty()->SetPointSize(7.0f);
    drawn.back()->GetProperty()->SetRepresentation(isOfPoints ? VTK_POINTS : VTK_SURFACE);
  }
  vtkNew<vtkRenderer> behind; // clears all of the window
  behind->SetBackground(0.1, 0.2, 0.3);
  Scene.Window->AddRenderer(behind);
  Scene.Window->SetNumberOfLayers(2);
  Scene.Renderer->SetLayer(1);
  Scene.Renderer->SetViewport(0.25, 0.25, 0.75, 0.75);
  Scene.LookAhead();
  EXPECT_TRUE(Scene.ShowsUnculled(drawn) || Scene.Setting.Samples == 0) << "as llvmpipe has it";
  EXPECT_EQ(Scene.ExpectSame(), 0) << "as devices may draw points there that llvmpipe does not";
  Scene.AddHidden();
  EXPECT_EQ(Scene.ExpectSame(), 63) << "boxes do not";
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerLines, testing::ValuesIn(CullerSettings()), CullerSettingName);
