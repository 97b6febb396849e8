// Sections of a cube, pixel by pixel; and what a section leaves behind, in windows that come and go.
#include "SectionScene.h"
#include "TestMessages.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkIdList.h"
#include "vtkLayerPicker.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkPartXRay.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{

constexpr Rgba EdgeColor = { 0.0, 1.0, 1.0, 1.0 };
constexpr Rgba OtherColor = { 0.0, 1.0, 0.0, 1.0 };

TEST(SectionPicture, HasACapOverWhatIsBehindThePlane)
{
  for (const int samples : { 0, 4 })
  {
    SCOPED_TRACE(std::to_string(samples) + " samples");
    SectionScene scene(samples);
    EXPECT_TRUE(Matches(scene.Render(), SectionScene::Capped()));
    scene.Section->CapsOff();
    EXPECT_TRUE(Matches(scene.Render(), SectionScene::Open()));
    scene.Section->CapsOn();
    scene.Plane->SetOrigin(0.0, 0.0, -0.25); // the plate is beyond the plane too
    EXPECT_TRUE(Matches(scene.Render(), SectionScene::Capped()));
    scene.Plane->SetOrigin(0.0, 0.0, -0.6);
    EXPECT_TRUE(Matches(scene.Render(), SectionScene::PictureOf({})));
  }
}

TEST(SectionPicture, HasEdgesOfTheirWidthWithinTheCap)
{
  SectionScene scene;
  scene.Section->SetEdgeColor(EdgeColor[0], EdgeColor[1], EdgeColor[2]);
  for (const int width : { 1, 4 })
  {
    SCOPED_TRACE(width);
    scene.Section->SetEdgeWidth(width);
    const PixelBox inner{ 8 + width, 8 + width, 24 - width, 24 - width };
    EXPECT_TRUE(Matches(scene.Render(),
      SectionScene::PictureOf({ { SectionScene::CubeBox, EdgeColor }, { inner, CubeColor } })));
  }
}

// Any plane removes, so the half on the left is left; beyond all planes there is the quarter at the front right.
TEST(SectionPicture, OfTwoPlanesLacksAHalfOrAQuarter)
{
  SectionScene scene;
  scene.Section->SetEdgeWidth(1);
  scene.Section->SetEdgeColor(EdgeColor[0], EdgeColor[1], EdgeColor[2]);
  vtkNew<vtkPlane> left;
  left->SetNormal(-1.0, 0.0, 0.0);
  scene.Section->AddPlane(left);
  EXPECT_TRUE(Matches(scene.Render(),
    SectionScene::PictureOf({ { { 8, 8, 16, 24 }, EdgeColor }, { { 9, 9, 16, 23 }, CubeColor } })));
  scene.Section->RemoveBeyondAllOn();
  EXPECT_TRUE(Matches(scene.Render(),
    SectionScene::PictureOf({ { SectionScene::CubeBox, CubeColor },
      { { 16, 8, 24, 24 }, EdgeColor }, { { 16, 9, 23, 23 }, CubeColor } })));
}

TEST(SectionPicture, OfABoxHasItsInsideOrAPit)
{
  SectionScene scene;
  scene.Section->RemoveAllPlanes();
  scene.Section->SetBox(-0.25, 0.25, -0.25, 0.25, -0.25, 0.25, true);
  const PixelBox inside = SectionScene::PlateBox;
  EXPECT_TRUE(Matches(scene.Render(), SectionScene::PictureOf({ { inside, CubeColor } })));
  scene.Section->CapsOff();
  EXPECT_TRUE(Matches(scene.Render(), SectionScene::PictureOf({ { inside, PlateColor } })));
  scene.Section->SetBox(-0.25, 0.25, -0.25, 0.25, 0.125, 1.0, false); // down to before the plate
  EXPECT_TRUE(Matches(scene.Render(), SectionScene::Open()));
  scene.Section->CapsOn();
  EXPECT_TRUE(Matches(scene.Render(), SectionScene::Capped()));
  scene.Section->RemoveBox();
  scene.Section->CapsOff();
  EXPECT_TRUE(Matches(scene.Render(), SectionScene::Capped())); // whole
}

TEST(SectionPicture, HasStripesWherePartsInterfere)
{
  SectionScene scene;
  scene.AddCube(0.0, 0.75, OtherColor);
  const Picture striped = scene.Render();
  for (int x = 8; x < 28; ++x)
  {
    const Rgba color = striped.At(x, 14);
    const double place = (x + 14 + 1) / 12.0; // of the middle of the pixel
    const bool isWhite = place - std::floor(place) >= 0.5;
    ExpectColor(color,
      x < 16      ? CubeColor
        : x >= 24 ? OtherColor
        : isWhite ? Rgba{ 1.0, 1.0, 1.0, 1.0 }
                  : Rgba{ 0.9, 0.1, 0.1, 1.0 },
      0.75);
  }
  vtkNew<vtkIdList> pairs;
  scene.Section->GetInterferingParts(pairs);
  ASSERT_EQ(pairs->GetNumberOfIds(), 2);
  EXPECT_EQ(pairs->GetId(0) + pairs->GetId(1), 1);
  scene.Section->InterferenceStripesOff();
  EXPECT_TRUE(Matches(scene.Render(),
    SectionScene::PictureOf(
      { { { 8, 8, 28, 24 }, OtherColor }, { SectionScene::CubeBox, CubeColor } })));
}

// Each of several ranks has some of the parts, and their caps must be where one rank has them.
TEST(SectionPicture, HasCapsWhoseDepthFollowsFromBoundsOfTheScene)
{
  const auto depthOfCap = [](bool hasOtherPart, bool hasBounds)
  {
    SectionScene scene;
    if (hasOtherPart)
    {
      vtkNew<vtkCubeSource> source;
      source->SetBounds(0.6, 0.7, -0.5, 0.5, -40.0, 0.5);
      scene.AddSource(source, OtherColor);
    }
    if (hasBounds)
    {
      scene.Section->SetSceneBounds(-0.5, 0.7, -0.5, 0.5, -40.0, 0.5);
    }
    scene.Render();
    vtkNew<vtkLayerPicker> picker;
    picker->SetRenderer(scene.Renderer);
    picker->SetPosition(16, 16);
    EXPECT_TRUE(picker->Pick()) << picker->GetProblem();
    return picker->GetWindowDepth(0);
  };
  EXPECT_NE(depthOfCap(true, false), depthOfCap(false, false));
  EXPECT_EQ(depthOfCap(true, true), depthOfCap(false, true));
}

/**
 * Draws frames of a cube with a cap and an x-ray before white: the first ones, and after changes. The cube is so dark
 * that it is black where its cap is opaque, and a step brighter where it is as translucent as opaque parts of x-rays.
 */
std::vector<Picture> FramesWithXRay(bool isXRayFirst)
{
  SectionScene scene;
  scene.Renderer->SetBackground(1.0, 1.0, 1.0);
  const double dark = 0.45 / 255.0;
  scene.Cube->GetProperty()->SetColor(dark, dark, dark);
  vtkNew<vtkLinkedListTransparencyPass> pass;
  scene.Use(pass);
  vtkNew<vtkPartXRay> xray;
  xray->AddPart(scene.Cube);
  xray->SetFloor(0.0);
  if (isXRayFirst)
  {
    scene.Section->Detach();
  }
  xray->Attach(scene.Renderer);
  if (isXRayFirst)
  {
    scene.Section->Attach(scene.Renderer);
  }
  std::vector<Picture> frames = { scene.Render(), scene.Render() };
  xray->RemoveAllParts();
  frames.push_back(scene.Render());
  xray->AddPart(scene.Cube);
  scene.Plane->SetOrigin(0.0, 0.0, -0.25);
  frames.push_back(scene.Render());
  return frames;
}

TEST(SectionPicture, HasCapsOfXRaysThatWereAttachedBeforeOrLater)
{
  const std::vector<Picture> before = FramesWithXRay(true);
  const std::vector<Picture> later = FramesWithXRay(false);
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    SCOPED_TRACE("frame " + std::to_string(i));
    EXPECT_TRUE(Matches(later[i], before[i]));
    EXPECT_EQ(before[i].At(10, 10)[0], i == 2 ? 0.0 : 1.0 / 255.0); // 2 has no x-ray
  }
}

// A rank has such data of parts whose cells are those of another one. Splats need no cells.
TEST(Section, CutsNoPointsWithoutCells)
{
  SectionScene scene;
  const int parts = scene.Section->GetNumberOfCutParts();
  EXPECT_GT(parts, 0);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-1.0, -1.0, -1.0);
  points->InsertNextPoint(1.0, 1.0, 1.0);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
  EXPECT_EQ(scene.Section->GetNumberOfCutParts(), parts);
  vtkNew<vtkPointGaussianMapper> splats;
  splats->SetInputData(data);
  actor->SetMapper(splats);
  EXPECT_EQ(scene.Section->GetNumberOfCutParts(), parts + 1);
}

TEST(Section, TakesNoBoundsOfASceneThatAreNone)
{
  const double infinite = std::numeric_limits<double>::infinity();
  const double none = std::numeric_limits<double>::quiet_NaN();
  SectionScene scene;
  const auto boundsAfter = [&](const std::array<double, 6>& b)
  {
    scene.Section->SetSceneBounds(b[0], b[1], b[2], b[3], b[4], b[5]);
    std::array<double, 6> bounds;
    std::copy_n(scene.Section->GetSceneBounds(), 6, bounds.begin());
    return bounds;
  };
  const std::array<double, 6> flat = { -0.5, 0.5, -0.5, 0.5, 0.25, 0.25 };
  EXPECT_EQ(boundsAfter(flat), flat);
  for (const std::array<double, 6>& wrong :
    { std::array<double, 6>{ none, 1.0, 0.0, 1.0, 0.0, 1.0 }, { 0.0, infinite, 0.0, 1.0, 0.0, 1.0 },
      { -infinite, 1.0, 0.0, 1.0, 0.0, 1.0 }, { 0.0, 1.0, 5.0, -5.0, 0.0, 1.0 },
      { 0.0, 1.0, 0.0, 1.0, 1.0, 0.0 }, { 0.0, 1.0, 0.0, 1.0, 0.0, none } })
  {
    TakeMessages();
    EXPECT_EQ(boundsAfter(wrong), flat);
    EXPECT_EQ(TakeMessages().size(), 1u);
  }
  const std::array<double, 6> noBounds = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  EXPECT_EQ(boundsAfter(noBounds), noBounds);
  EXPECT_TRUE(TakeMessages().empty());
}

// The window may be finalized, and the renderer may go to another window, where names of objects are others'.
TEST(SectionWindows, MayBeReleasedAndLeft)
{
  SectionScene scene;
  const Picture expected = SectionScene::Capped();
  EXPECT_TRUE(Matches(scene.Render(), expected));
  EXPECT_GT(scene.Section->GetBytes(), 0);
  scene.Window->ReleaseGraphicsResources(scene.Window);
  EXPECT_EQ(scene.Section->GetBytes(), 0);
  EXPECT_TRUE(Matches(scene.Render(), expected));
  scene.Window->Finalize();
  EXPECT_TRUE(Matches(scene.Render(), expected));

  TestScene other(SectionScene::Size, SectionScene::Size);
  other.Window->RemoveRenderer(other.Renderer);
  scene.Window->RemoveRenderer(scene.Renderer);
  other.Window->AddRenderer(scene.Renderer);
  EXPECT_TRUE(Matches(other.Render(), expected));
  scene.Section->Detach();
  EXPECT_EQ(scene.Section->GetBytes(), 0);
  scene.Section->Attach(other.Renderer); // which shows nothing
  EXPECT_EQ(scene.Section->GetNumberOfCutParts(), 0);
  scene.Section->Attach(scene.Renderer);
  EXPECT_TRUE(Matches(other.Render(), expected));
}

// Observers of a frame's beginning and its end may detach the section, which may be the end of it.
TEST(SectionWindows, MayBeDetachedWithinAFrame)
{
  for (const unsigned long event : { static_cast<unsigned long>(vtkCommand::StartEvent),
         static_cast<unsigned long>(vtkCommand::EndEvent) })
  {
    for (const float priority : { 1.0f, -2.0f }) // before and after the section
    {
      SCOPED_TRACE(
        vtkCommand::GetStringFromEventId(event) + std::string(" at ") + std::to_string(priority));
      TestScene scene(SectionScene::Size, SectionScene::Size);
      scene.AddSphere(0.0, 0.0, 0.0, 0.5, CubeColor);
      const int props = scene.Renderer->GetViewProps()->GetNumberOfItems();
      const Picture whole = scene.Render();
      vtkNew<vtkPlane> plane;
      plane->SetNormal(0.0, 0.0, -1.0); // removes what is seen
      {
        vtkNew<vtkSection> section;
        section->AddPlane(plane);
        section->Attach(scene.Renderer);
      }
      EXPECT_FALSE(scene.Render() == whole);
      vtkNew<vtkCallbackCommand> detaching;
      detaching->SetCallback(
        [](vtkObject* renderer, unsigned long, void*, void*)
        {
          vtkSection* const section = vtkSection::GetAttached(vtkRenderer::SafeDownCast(renderer));
          ASSERT_NE(section, nullptr);
          section->Detach();
        });
      const unsigned long tag = scene.Renderer->AddObserver(event, detaching, priority);
      const Picture last = scene.Render();
      scene.Renderer->RemoveObserver(tag);
      EXPECT_EQ(last == whole, event == vtkCommand::StartEvent);
      EXPECT_EQ(vtkSection::GetAttached(scene.Renderer), nullptr);
      EXPECT_EQ(scene.Renderer->GetViewProps()->GetNumberOfItems(), props);
      EXPECT_TRUE(Matches(scene.Render(), whole));
    }
  }
}

}
