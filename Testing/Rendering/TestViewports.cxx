// Parts of a window, and windows of any size: viewports, layers, eyes, tiles, off-screen buffers.
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkSeeThroughPass.h"
#include "vtkTranslucentPass.h"
#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

// The colours of the rectangle [x0, x1) x [y0, y1), if they are all the same.
Rgba ColorOf(const Picture& picture, int x0, int y0, int x1, int y1)
{
  for (int y = y0; y < y1; ++y)
  {
    for (int x = x0; x < x1; ++x)
    {
      EXPECT_EQ(picture.At(x, y), picture.At(x0, y0)) << x << ", " << y;
    }
  }
  return picture.At(x0, y0);
}

void AddPlatesTo(vtkRenderer* renderer, const std::vector<Rgba>& plates)
{
  TestScene maker;
  renderer->AddActor(maker.AddPlates(plates, 3));
}

// VTK clears viewports alone; here, first, all of the window.
void ClearEverything(TestScene& scene)
{
  vtkNew<vtkRenderer> all;
  scene.Window->RemoveRenderer(scene.Renderer);
  scene.Window->AddRenderer(all);
  scene.Window->AddRenderer(scene.Renderer);
}

class Viewports : public testing::TestWithParam<Method>
{
};

TEST_P(Viewports, SeveralViewports)
{
  for (const int samples : GetParam().Samples())
  {
    SCOPED_TRACE(std::to_string(samples) + " samples");
    TestScene scene(80, 60, samples);
    ClearEverything(scene);
    const std::vector<Rgba> left = RandomPlates(5, 0.4, 1);
    const std::vector<Rgba> right =
      RandomPlates(GetParam().Keeps(40) ? 40 : GetParam().MaxLayers, 0.1, 2);
    scene.Renderer->SetViewport(0.1, 0.2, 0.45, 0.9);
    AddPlatesTo(scene.Renderer, left);
    scene.Renderer->SetPass(MakeSeeThrough(GetParam()));
    vtkNew<vtkRenderer> second;
    second->SetViewport(0.5, 0.0, 1.0, 0.7);
    second->SetBackground(1.0, 0.0, 1.0);
    second->SetActiveCamera(scene.Renderer->GetActiveCamera());
    AddPlatesTo(second, right);
    second->SetPass(MakeSeeThrough(GetParam()));
    scene.Window->AddRenderer(second);
    for (int frame = 0; frame < 2; ++frame)
    {
      const Picture picture = scene.Render();
      ExpectColor(ColorOf(picture, 9, 13, 35, 53), CompositePlates(left, TestBackground), 0.75);
      ExpectColor(
        ColorOf(picture, 41, 1, 79, 41), CompositePlates(right, { 1.0, 0.0, 1.0, 0.0 }), 0.75);
      ExpectColor(ColorOf(picture, 41, 43, 80, 60), { 0.0, 0.0, 0.0, 0.0 }, 0.0);
      ExpectColor(ColorOf(picture, 0, 0, 7, 60), { 0.0, 0.0, 0.0, 0.0 }, 0.0);
    }
  }
}

// A white window in four viewports, whose corner is at `x` and `y` of the window; one of them has plates and a pass.
struct FourViewports : TestScene
{
  FourViewports(double x, double y, int samples)
    : TestScene(40, 30, samples)
  {
    this->Window->RemoveRenderer(this->Renderer);
    const double places[4][4] = { { 0.0, 0.0, x, y }, { x, 0.0, 1.0, y }, { 0.0, y, x, 1.0 },
      { x, y, 1.0, 1.0 } };
    for (const auto& place : places)
    {
      const auto renderer = vtkSmartPointer<vtkRenderer>::New();
      renderer->SetViewport(place[0], place[1], place[2], place[3]);
      renderer->SetBackground(1.0, 1.0, 1.0);
      renderer->SetActiveCamera(this->Renderer->GetActiveCamera());
      this->Window->AddRenderer(renderer);
      this->Viewports.push_back(renderer);
    }
  }

  /** Whether the viewport has the pixel. */
  bool Has(int viewport, int x, int y) const
  {
    int width = 0;
    int height = 0;
    int left = 0;
    int bottom = 0;
    this->Viewports[viewport]->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
    return x >= left && x < left + width && y >= bottom && y < bottom + height;
  }

  std::vector<vtkSmartPointer<vtkRenderer>> Viewports;
};

// Wherever they meet: all samples of all pixels of a viewport are drawn, and none of others.
TEST_P(Viewports, EndWhereOthersBegin)
{
  const std::vector<Rgba> plates = RandomPlates(3, 0.4, 1);
  const Rgba expected = CompositePlates(plates, { 1.0, 1.0, 1.0, 0.0 });
  std::vector<int> counts = GetParam().Samples();
  if (counts.size() > 1)
  {
    counts.insert(counts.end(), { 2, 8 });
  }
  for (const int samples : counts)
  {
    for (int i = 0; i < 4; ++i)
    {
      const int viewport = i % 2 == 0 ? 0 : 3;
      const bool isOdd = i > 1;
      SCOPED_TRACE(std::to_string(samples) + " samples, viewport " + std::to_string(viewport) +
        (isOdd ? " of odd size" : ""));
      FourViewports scene(isOdd ? 0.375 + 1e-9 : 0.5, isOdd ? 0.3 + 1e-9 : 0.5, samples);
      AddPlatesTo(scene.Viewports[viewport], plates);
      scene.Viewports[viewport]->SetPass(MakeSeeThrough(GetParam()));
      const Picture picture = scene.Render();
      int wrong = 0;
      for (int y = 0; y < picture.Height; ++y)
      {
        for (int x = 0; x < picture.Width; ++x)
        {
          const Rgba color = picture.At(x, y);
          const bool isInside = scene.Has(viewport, x, y);
          for (int c = 0; c < 3; ++c)
          {
            wrong += isInside
              ? std::abs(color[c] - expected[c]) * 255.0 > GetParam().Tolerance + 0.5
              : color[c] != 1.0;
          }
        }
      }
      EXPECT_EQ(wrong, 0);
    }
  }
}

// Each eye sees the picture that it sees without a pass.
TEST_P(Viewports, InStereo)
{
  const auto draw = [](bool usesPass, int eye)
  {
    TestScene scene(80, 60);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
    scene.Renderer->GetActiveCamera()->SetViewAngle(50.0);
    const vtkSmartPointer<vtkActor> sphere =
      scene.AddSphere(0.0, 0.0, 0.3, 0.5, { 0.3, 0.5, 0.9, 1.0 });
    sphere->SetForceTranslucent(usesPass);
    scene.Window->SetStereoType(eye);
    scene.Window->StereoRenderOn();
    if (usesPass)
    {
      scene.Renderer->SetPass(MakeSeeThrough(GetParam()));
    }
    return scene.Render();
  };
  const Picture left = draw(true, VTK_STEREO_LEFT);
  const Picture right = draw(true, VTK_STEREO_RIGHT);
  EXPECT_GT(LargestDifference(left, right), 50);
  EXPECT_TRUE(Matches(left, draw(false, VTK_STEREO_LEFT), 2, GetParam().EdgeShare));
  EXPECT_TRUE(Matches(right, draw(false, VTK_STEREO_RIGHT), 2, GetParam().EdgeShare));
}

// A viewport of its own shows what a window of its size shows.
TEST_P(Viewports, AViewportIsAWindow)
{
  TestScene alone(40, 30);
  alone.AddParts();
  alone.Renderer->SetPass(MakeSeeThrough(GetParam()));
  const Picture expected = alone.Render();
  TestScene scene(80, 60);
  scene.AddParts();
  scene.Renderer->SetViewport(0.25, 0.5, 0.75, 1.0);
  scene.Renderer->SetPass(MakeSeeThrough(GetParam()));
  const Picture picture = scene.Render();
  for (int y = 0; y < 30; ++y)
  {
    for (int x = 0; x < 40; ++x)
    {
      ASSERT_EQ(picture.At(20 + x, 30 + y), expected.At(x, y)) << x << ", " << y;
    }
  }
}

TEST_P(Viewports, SeveralLayers)
{
  TestScene scene(30, 20);
  const std::vector<Rgba> below = RandomPlates(5, 0.4, 4);
  const std::vector<Rgba> above = RandomPlates(9, 0.2, 5);
  AddPlatesTo(scene.Renderer, below);
  scene.Renderer->SetPass(MakeSeeThrough(GetParam()));
  vtkNew<vtkRenderer> second;
  second->SetLayer(1);
  second->SetActiveCamera(scene.Renderer->GetActiveCamera());
  AddPlatesTo(second, above);
  second->SetPass(MakeSeeThrough(GetParam()));
  scene.Window->SetNumberOfLayers(2);
  scene.Window->AddRenderer(second);
  std::vector<Rgba> all = above;
  all.insert(all.end(), below.begin(), below.end());
  // The layer below is rounded, too.
  ExpectColor(UniformColor(scene.Render()), CompositePlates(all, TestBackground), 1.2);
}

TEST_P(Viewports, AnySizeOneAfterTheOther)
{
  TestScene scene;
  scene.AddParts();
  scene.Renderer->SetPass(MakeSeeThrough(GetParam()));
  const int sizes[][2] = { { 1, 1 }, { 301, 300 }, { 1, 77 }, { 64, 48 }, { 33, 1 }, { 301, 300 },
    { 16, 16 }, { 17, 15 } };
  for (const auto& size : sizes)
  {
    SCOPED_TRACE(std::to_string(size[0]) + " x " + std::to_string(size[1]));
    scene.Window->SetSize(size[0], size[1]);
    const Picture resized = scene.Render();
    ASSERT_EQ(resized.Width, size[0]);
    ASSERT_EQ(resized.Height, size[1]);
    TestScene fresh(size[0], size[1]);
    fresh.AddParts();
    fresh.Renderer->SetPass(MakeSeeThrough(GetParam()));
    EXPECT_TRUE(Matches(fresh.Render(), resized));
  }
}

Picture Screenshot(vtkRenderWindow* window, int scale)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->SetScale(scale);
  filter->SetInputBufferTypeToRGBA();
  filter->ReadFrontBufferOff();
  filter->Update();
  return ToPicture(filter->GetOutput());
}

TEST_P(Viewports, ATiledScreenshotIsTheUntiledPicture)
{
  TestScene large(120, 90);
  large.AddParts();
  large.Renderer->SetPass(MakeSeeThrough(GetParam()));
  const Picture expected = large.Render();
  TestScene scene(40, 30);
  scene.AddParts();
  scene.Renderer->SetPass(MakeSeeThrough(GetParam()));
  const Picture before = scene.Render();
  EXPECT_TRUE(Matches(Screenshot(scene.Window, 1), before));
  const Picture tiled = Screenshot(scene.Window, 3);
  EXPECT_EQ(tiled.Width, 120);
  EXPECT_TRUE(Matches(tiled, expected, GetParam().EdgeShare > 0.0 ? 1 : 0, GetParam().EdgeShare));
  EXPECT_TRUE(Matches(scene.Render(), before));
}

// One layer needs no sorting: VTK's own blending of it is right, but for its rounding.
TEST_P(Viewports, ATileOfAWallOfDisplays)
{
  TestScene scene(40, 30);
  scene.AddSphere(-0.4, 0.3, 0.3, 0.4, { 0.9, 0.5, 0.9, 1.0 });
  scene.AddRectangle(-0.7, -0.4, 0.8, 0.5, 0.0, { 0.2, 0.9, 0.2, 0.6 });
  scene.Renderer->SetViewport(0.1, 0.2, 0.9, 0.7);
  scene.Window->SetTileScale(2, 2);
  scene.Window->SetTileViewport(0.5, 0.0, 1.0, 0.5);
  vtkNew<vtkTranslucentPass> blending;
  scene.Use(blending);
  const Picture expected = scene.Render();
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  scene.Use(pass);
  const Picture picture = scene.Render();
  int wrong = 0;
  for (int y = 12; y < 30; ++y) // the part of the wall's viewport that lies in the tile
  {
    for (int x = 0; x < 32; ++x)
    {
      for (int c = 0; c < 4; ++c)
      {
        wrong += std::abs(picture.At(x, y)[c] - expected.At(x, y)[c]) > 1.01 / 255;
      }
    }
  }
  EXPECT_LE(wrong, GetParam().EdgeShare * 4 * 32 * 18);
  EXPECT_GT(pass->GetNumberOfFragments(), 0);
  EXPECT_LE(pass->GetNumberOfFragments(), 32 * 18);
}

TEST_P(Viewports, OffScreenBuffers)
{
  TestScene scene(40, 30);
  scene.AddParts();
  scene.Renderer->SetPass(MakeSeeThrough(GetParam()));
  const Picture expected = scene.Render();
  scene.Window->SetUseOffScreenBuffers(true);
  EXPECT_TRUE(Matches(scene.Render(), expected));
}

INSTANTIATE_TEST_SUITE_P(Methods, Viewports, testing::ValuesIn(AllMethods()), MethodName());

}
