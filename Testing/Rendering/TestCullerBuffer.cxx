// The s-buffer as an image: what a frame's parts surely cover, and null where there was no such frame.
#include "CullerScene.h"
#include "Select.h"

#include "vtkDataArray.h"
#include "vtkEDLShading.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderStepsPass.h"

#include <gtest/gtest.h>

namespace
{

constexpr double Slack = 1e-4; // of depths: margins of floats are less

// The view that CullerScene::LookAhead() sets.
constexpr double Near = 1.0, Far = 8.0, Distance = 3.6;

class CullerBuffer : public CullerTest
{
protected:
  /** The image of a frame, with its size and kind looked at. */
  vtkSmartPointer<vtkImageData> ImageOfFrame()
  {
    Scene.Render();
    const vtkSmartPointer<vtkImageData> image = Scene.Culler->GetBufferImage(Scene.Renderer);
    EXPECT_TRUE(image);
    EXPECT_EQ(image->GetDimensions()[0], this->CountCells(Scene.Setting.Width));
    EXPECT_EQ(image->GetDimensions()[1], this->CountCells(Scene.Setting.Height));
    EXPECT_EQ(Scene.Culler->GetNumberOfBufferLines(), image->GetDimensions()[1]);
    EXPECT_EQ(image->GetDimensions()[2], 1);
    EXPECT_EQ(image->GetScalarType(), VTK_FLOAT);
    EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(), "ReversedDepth");
    return image;
  }

  /** Columns or lines of so many pixels, of which each is cut into up to four if it has four samples. */
  static int CountCells(int pixels)
  {
    const CullerSetting& setting = GetParam();
    const int perCell = (setting.Height + setting.BufferLines - 1) / setting.BufferLines;
    int ofPixel = 1;
    while (ofPixel < setting.Samples && 2 * ofPixel * setting.Height <= setting.BufferLines)
    {
      ofPixel *= 2;
    }
    return ofPixel * ((pixels + perCell - 1) / perCell);
  }

  /** Reversed, of what is so far in front of the camera. */
  double DepthAt(double distance) const
  {
    return Scene.Setting.IsParallel ? (Far - distance) / (Far - Near)
                                    : Near * (Far - distance) / (distance * (Far - Near));
  }
};

float ValueAt(vtkImageData* image, int column, int line)
{
  return image->GetScalarComponentAsFloat(column, line, 0, 0);
}

/** The least and the greatest value. */
std::array<double, 2> RangeOf(vtkImageData* image)
{
  std::array<double, 2> range;
  image->GetScalarRange(range.data());
  return range;
}

void AddCrossingBoxes(CullerScene& scene, std::uint64_t seed)
{
  TestRandom random(seed);
  for (int i = 0; i < 60; ++i)
  {
    const auto within = [&] { return 2.0 * random.Unit() - 1.0; };
    const double x = within(), y = within();
    scene.AddBox({ x, y, within() }, { 0.8 * random.Unit(), 0.8 * random.Unit(), 0.3 })
      ->SetOrientation(90.0 * random.Unit(), 90.0 * random.Unit(), 0.0);
  }
}

/** The window's z-buffer, from the bottom row up. */
std::vector<float> ReadDepths(CullerScene& scene)
{
  const int width = scene.Setting.Width, height = scene.Setting.Height;
  std::vector<float> depths(static_cast<std::size_t>(width) * height);
  scene.Window->GetZbufferData(0, 0, width - 1, height - 1, depths.data());
  return depths;
}

TEST_P(CullerBuffer, HoldsTheDepthOfAWall)
{
  Scene.AddWall();
  Scene.AddHidden();
  const std::array<double, 2> range = RangeOf(this->ImageOfFrame());
  EXPECT_LE(range[1], DepthAt(Distance));
  EXPECT_GE(range[0], DepthAt(Distance) - Slack);
}

// The left of the view is empty: above and below the middle alike, from the bottom to the top.
TEST_P(CullerBuffer, HoldsWhatIsNearestFromTheBottomUp)
{
  Scene.AddMesh(MeshOf({ Rectangle(-0.3, -2.5, 2.5, 2.5, 0.0) }));
  Scene.AddMesh(MeshOf({ Rectangle(-0.3, 0.3, 2.5, 2.5, 0.5) }));
  const vtkSmartPointer<vtkImageData> image = this->ImageOfFrame();
  const int right = image->GetDimensions()[0] - 1, top = image->GetDimensions()[1] - 1;
  EXPECT_EQ(ValueAt(image, 0, 0), 0.0f);
  EXPECT_EQ(ValueAt(image, 0, top), 0.0f);
  EXPECT_NEAR(ValueAt(image, right, 0), DepthAt(Distance), Slack);
  EXPECT_NEAR(ValueAt(image, right, top), DepthAt(Distance - 0.5), Slack);
}

TEST_P(CullerBuffer, IsEmptyWhereNothingHides)
{
  Scene.AddWall()->GetProperty()->SetOpacity(0.5);
  EXPECT_EQ(RangeOf(this->ImageOfFrame())[1], 0.0);
}

TEST_P(CullerBuffer, IsNullWithoutAFrameThatWasCulled)
{
  vtkHierarchicalSBufferCuller* culler = Scene.Culler;
  Scene.AddWall();
  EXPECT_FALSE(culler->GetBufferImage(nullptr));
  EXPECT_FALSE(culler->GetBufferImage(Scene.Renderer));
  this->ImageOfFrame();
  EXPECT_FALSE(culler->GetBufferImage(vtkSmartPointer<vtkRenderer>::New()));

  culler->CullingOff();
  Scene.Render();
  EXPECT_FALSE(culler->GetBufferImage(Scene.Renderer));
  culler->CullingOn();
  this->ImageOfFrame();

  vtkNew<vtkEDLShading> shading; // looks beyond the view
  shading->SetDelegatePass(vtkSmartPointer<vtkRenderStepsPass>::New());
  Scene.Renderer->SetPass(shading);
  Scene.Render();
  EXPECT_FALSE(culler->GetBufferImage(Scene.Renderer));
  shading->ReleaseGraphicsResources(Scene.Window);
  Scene.Renderer->SetPass(nullptr);
  this->ImageOfFrame();
}

// A window that smooths lines blends their edges with what is behind: its frames are culled by the view alone.
TEST_P(CullerBuffer, IsNullWithoutAFrameInWhichPartsHide)
{
  Scene.AddWall();
  vtkRenderWindow* const window = Scene.Window;
  window->LineSmoothingOn();
  Scene.Render();
  EXPECT_FALSE(Scene.Culler->GetBufferImage(Scene.Renderer));
  window->LineSmoothingOff();
  this->ImageOfFrame();
  window->LineSmoothingOn();
  Scene.Render();
  EXPECT_FALSE(Scene.Culler->GetBufferImage(Scene.Renderer));
}

TEST_P(CullerBuffer, StaysAsItIsWhileOnePicks)
{
  Scene.AddWall();
  Scene.AddHidden();
  const std::array<double, 2> before = RangeOf(this->ImageOfFrame());
  Select(Scene.Renderer, vtkDataObject::FIELD_ASSOCIATION_CELLS, 1, 1, 20, 20);
  EXPECT_EQ(RangeOf(Scene.Culler->GetBufferImage(Scene.Renderer)), before);
}

// The left half of the window shows a wall, the right one nothing that hides.
TEST_P(CullerBuffer, IsOfTheRendererThatIsAskedFor)
{
  const vtkSmartPointer<vtkActor> wall = Scene.AddWall();
  vtkNew<vtkRenderer> other;
  other->AddCuller(Scene.Culler);
  other->SetViewport(0.5, 0.0, 1.0, 1.0);
  vtkNew<vtkActor> glass;
  glass->SetMapper(wall->GetMapper());
  glass->GetProperty()->SetOpacity(0.5);
  other->AddActor(glass);
  Scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  Scene.Window->AddRenderer(other);
  Scene.Render();
  const vtkSmartPointer<vtkImageData> left = Scene.Culler->GetBufferImage(Scene.Renderer);
  const vtkSmartPointer<vtkImageData> right = Scene.Culler->GetBufferImage(other);
  ASSERT_TRUE(left && right);
  EXPECT_GT(RangeOf(left)[0], 0.0);
  EXPECT_EQ(RangeOf(right)[1], 0.0);

  // Images that somebody keeps stay as they are.
  const std::array<double, 2> before = RangeOf(left);
  wall->VisibilityOff();
  Scene.AddBox({ 0.0, 0.0, 0.0 }, { 0.1, 0.1, 0.1 });
  Scene.Render();
  EXPECT_EQ(RangeOf(Scene.Culler->GetBufferImage(Scene.Renderer))[0], 0.0);
  EXPECT_EQ(RangeOf(left), before);
}

// With lines of one pixel, the middle of a column is a pixel centre, where a z-buffer holds no greater depth. Depths
// that VTK reads of multisampled buffers are not at pixel centres.
TEST(CullerBufferDepths, AreNowhereNearerThanTheZBuffer)
{
  for (const bool isParallel : { false, true })
  {
    SCOPED_TRACE(isParallel ? "parallel" : "perspective");
    CullerScene scene({ "", 0, isParallel, 270, 93, 79 });
    AddCrossingBoxes(scene, 310);
    scene.Render();
    const vtkSmartPointer<vtkImageData> image = scene.Culler->GetBufferImage(scene.Renderer);
    const std::vector<float> depths = ReadDepths(scene);
    ASSERT_EQ(static_cast<std::size_t>(image->GetNumberOfPoints()), depths.size());
    const auto* values = static_cast<const float*>(image->GetScalarPointer());
    int covered = 0;
    for (std::size_t i = 0; i < depths.size(); ++i)
    {
      ASSERT_TRUE(values[i] >= 0.0f && values[i] <= 1.0f) << i;
      ASSERT_LE(depths[i], 1.0f - values[i] + 1e-6f) << i;
      covered += values[i] > 0.0f;
    }
    EXPECT_GT(covered, static_cast<int>(depths.size() / 6));
  }
}

TEST(CullerBufferLifetime, IsKeptByItsOwner)
{
  vtkSmartPointer<vtkImageData> image;
  {
    CullerScene scene(CullerSettings()[0]);
    scene.AddWall();
    scene.Render();
    image = scene.Culler->GetBufferImage(scene.Renderer);
  }
  EXPECT_GT(RangeOf(image)[0], 0.0);
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerBuffer, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
