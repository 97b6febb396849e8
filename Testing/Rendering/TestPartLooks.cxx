// Looks of chosen parts: outlines through all that hides them (look/vtkPartOutlines), and x-rays (look/vtkPartXRay).
// Testing/Python/test_highlight.py and test_x_ray.py have more, by the same classes.

#include "CompositeMapper.h"
#include "TestMessages.h"
#include "TestScene.h"

#include "vtkActor.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartOutlines.h"
#include "vtkPartXRay.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkVolume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace
{

const Rgba Orange = { 1.0, 128.0 / 255.0, 0.0, 1.0 };

/** Returns true if a pixel is of the border of the rectangle that [-0.5, 0.5] in both directions covers. */
bool IsOfBorder(const Picture& picture, int x, int y, int width)
{
  const int left = picture.Width / 4;
  const int low = picture.Height / 4;
  const int away =
    std::min({ x - left, picture.Width - 1 - left - x, y - low, picture.Height - 1 - low - y });
  return away >= 0 && away < width;
}

/** Expects that a pixel is the background behind black that lets this share of light through. */
void ExpectLight(const Rgba& color, double share)
{
  const Rgba& all = TestBackground;
  ExpectColor(color, { share * all[0], share * all[1], share * all[2], color[3] }, 1.0);
}

/** Expects that what was done since has said one thing. */
void ExpectSaid(const std::string& text)
{
  const std::vector<std::string> said = TakeMessages();
  ASSERT_EQ(said.size(), 1u) << text;
  EXPECT_NE(said.front().find(text), std::string::npos) << said.front();
}

TEST(PartOutlines, AreTheBorderOfAPartBehindOthers)
{
  TestScene scene(64, 64);
  vtkActor* const part = scene.AddRectangle(-0.5, -0.5, 0.5, 0.5, -0.5, { 1.0, 1.0, 1.0, 1.0 });
  scene.AddPlate(0.5, { 0.2, 0.2, 0.2, 1.0 });
  const Picture before = scene.Render();
  vtkNew<vtkPartOutlines> outlines;
  outlines->AddPart(part);
  outlines->Attach(scene.Renderer);
  for (const int width : { 1, 3 })
  {
    outlines->SetWidth(width);
    const Picture picture = scene.Render();
    for (int y = 0; y < picture.Height; ++y)
    {
      for (int x = 0; x < picture.Width; ++x)
      {
        ExpectColor(
          picture.At(x, y), IsOfBorder(picture, x, y, width) ? Orange : before.At(x, y), 0.0);
      }
    }
  }
  EXPECT_STREQ(outlines->GetFallbackReason(), "");
  EXPECT_GT(outlines->GetBytes(), 0);
  outlines->Detach();
  EXPECT_TRUE(Matches(scene.Render(), before));
}

TEST(PartOutlines, AreOfTheNearerPartWhateverTheOrder)
{
  for (const bool swapped : { false, true })
  {
    TestScene scene(64, 64);
    vtkActor* const part = scene.AddRectangle(-0.5, -0.5, 0.5, 0.5, 0.0, { 1.0, 1.0, 1.0, 0.5 });
    vtkActor* const within =
      scene.AddRectangle(-0.25, -0.25, 0.25, 0.25, -0.5, { 0.0, 0.0, 1.0, 0.5 });
    scene.AddPlate(0.5, { 0.2, 0.2, 0.2, 1.0 });
    vtkNew<vtkPartOutlines> outlines;
    outlines->AddPart(swapped ? within : part);
    outlines->AddPart(swapped ? part : within);
    outlines->SetWidth(1);
    outlines->Attach(scene.Renderer);
    ExpectColor(
      scene.Render().At(24, 32), { 0.2, 0.2, 0.2, 1.0 }, 0.0); // at the edge of the farther part
  }
}

TEST(PartOutlines, AreRoundAtCorners)
{
  // A notch: two rectangles of one part, whose inner corner is in the middle of the view.
  TestScene scene(64, 64);
  vtkActor* const part = scene.AddRectangle(-0.5, -0.5, 0.5, 0.5, 0.0, { 1.0, 1.0, 1.0, 1.0 });
  vtkActor* const other = scene.AddRectangle(0.0, 0.0, 0.6, 0.6, 0.1, { 1.0, 1.0, 1.0, 1.0 });
  vtkNew<vtkPartOutlines> outlines;
  outlines->AddPart(part);
  outlines->AddPart(other);
  outlines->AddExcludedPart(other);
  outlines->SetWidth(4);
  outlines->Attach(scene.Renderer);
  const Picture picture = scene.Render();
  ExpectColor(picture.At(31, 31), Orange, 0.0);
  ExpectColor(picture.At(30, 30), Orange, 0.0);
  ExpectColor(picture.At(29, 29), { 1.0, 1.0, 1.0, 1.0 }, 0.0); // sqrt(18) from the pixel at 32, 32
  ExpectColor(picture.At(40, 40), { 1.0, 1.0, 1.0, 1.0 }, 0.0); // excluded
}

TEST(PartOutlines, AreInTheirViewport)
{
  TestScene scene(64, 64);
  scene.Renderer->SetViewport(0.5, 0.5, 1.0, 1.0);
  vtkActor* const part = scene.AddRectangle(-0.5, -0.5, 0.5, 0.5, 0.0, { 1.0, 1.0, 1.0, 1.0 });
  vtkNew<vtkPartOutlines> outlines;
  outlines->AddPart(part);
  outlines->SetWidth(1);
  outlines->Attach(scene.Renderer);
  const Picture picture = scene.Render();
  ExpectColor(picture.At(40, 48), Orange, 0.0);
  ExpectColor(picture.At(41, 48), { 1.0, 1.0, 1.0, 1.0 }, 0.0);
}

TEST(PartOutlines, RefuseWhatIsNoPart)
{
  vtkNew<vtkPartOutlines> outlines;
  vtkNew<vtkVolume> volume;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  outlines->AddPart(nullptr);
  ExpectSaid("AddPart() takes an actor, and cannot take null");
  outlines->AddPart(volume);
  ExpectSaid("cannot take vtk");
  outlines->SetOpacity(nan);
  ExpectSaid("Opacity cannot be");
  outlines->SetWidth(9);
  ExpectSaid("Width cannot be 9");
  outlines->Attach(nullptr);
  ExpectSaid("Attach() takes a renderer");
  EXPECT_EQ(outlines->GetNumberOfParts(), 0);
}

TEST(PartXRay, IsItsFormulaForAPlateThatFacesTheEye)
{
  TestScene scene(16, 16);
  vtkActor* const plate = scene.AddPlate(0.0, { 0.0, 0.0, 0.0, 1.0 });
  vtkNew<vtkPartXRay> xray;
  xray->AddPart(plate);
  xray->SetFloor(0.25);
  xray->Attach(scene.Renderer);
  ExpectLight(scene.Render().At(8, 8), 0.75);
  EXPECT_LT(plate->GetProperty()->GetOpacity(), 1.0);
  xray->Detach();
  EXPECT_EQ(plate->GetProperty()->GetOpacity(), 1.0);
  ExpectLight(scene.Render().At(8, 8), 0.0);
}

TEST(PartXRay, IsOfItsBlocks)
{
  TestScene scene(16, 16);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 2; ++i)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(i - 1.0, -1.0, 0.0);
    plane->SetPoint1(i, -1.0, 0.0);
    plane->SetPoint2(i - 1.0, 1.0, 0.0);
    plane->Update();
    blocks->SetBlock(i, plane->GetOutput());
  }
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  actor->GetProperty()->SetOpacity(0.5);
  scene.Renderer->AddActor(actor);
  vtkNew<vtkPartXRay> xray;
  xray->AddPart(actor, 2);
  xray->SetFloor(0.5);
  xray->Attach(scene.Renderer);
  const Picture picture = scene.Render();
  ExpectLight(picture.At(4, 8), 0.5);
  ExpectLight(picture.At(12, 8), 0.75);
}

TEST(PartXRay, IsOneForARenderer)
{
  TestScene scene(16, 16);
  vtkActor* const plate = scene.AddPlate(0.0, { 0.0, 0.0, 0.0, 1.0 });
  vtkNew<vtkPartXRay> first;
  vtkNew<vtkPartXRay> second;
  for (vtkPartXRay* xray : { first.Get(), second.Get() })
  {
    xray->AddPart(plate);
    xray->Attach(scene.Renderer);
  }
  EXPECT_EQ(vtkPartXRay::GetAttached(scene.Renderer), second.Get());
  EXPECT_EQ(first->GetRenderer(), nullptr);
  scene.Render();
}
}
