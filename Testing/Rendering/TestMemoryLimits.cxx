// Memory limits of the methods that store every fragment: kept in bands of the screen, with the same picture; and how
// what they hold follows the scene.
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkABufferTransparencyPass.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkShaderProperty.h"

#include <gtest/gtest.h>

namespace
{

constexpr int Width = 16;
constexpr int Height = 16;

class MemoryLimits : public testing::TestWithParam<Method>
{
protected:
  /** Expect the picture and statistics of one whole with limits of parts of the bytes that it takes. */
  void ExpectWholeInBands(TestScene& scene, const Picture& whole, std::vector<int> parts)
  {
    const vtkTypeInt64 bytes = this->Pass->GetPoolBytes();
    const vtkTypeInt64 fragments = this->Pass->GetNumberOfFragments();
    const vtkTypeInt64 layers = this->Pass->GetMaximumNumberOfLayers();
    for (const int part : parts)
    {
      SCOPED_TRACE("a limit of 1/" + std::to_string(part));
      this->Pass->SetMemoryLimit(bytes / part);
      for (int frame = 0; frame < 2; ++frame)
      {
        EXPECT_TRUE(Matches(scene.Render(), whole));
        EXPECT_STREQ(this->Pass->GetFallbackReason(), "");
        EXPECT_GT(this->Pass->GetNumberOfBands(), 1);
        // The second frame knows its bands, for which packed lists are counted.
        const bool counts = frame == 0 || this->Pass->IsA("vtkPrefixSumTransparencyPass");
        EXPECT_EQ(this->Pass->GetNumberOfGeometryPasses() > this->Pass->GetNumberOfBands(), counts);
        EXPECT_TRUE(frame == 0 ||
          this->Pass->GetNumberOfGeometryPasses() <= this->Pass->GetNumberOfBands() + 1);
        EXPECT_LE(this->Pass->GetPoolBytes(), bytes / part);
      }
      this->Pass->SetMemoryLimit(0);
      EXPECT_TRUE(Matches(scene.Render(), whole));
      EXPECT_EQ(this->Pass->GetNumberOfBands(), 1);
      EXPECT_EQ(this->Pass->GetNumberOfFragments(), fragments);
      EXPECT_EQ(this->Pass->GetMaximumNumberOfLayers(), layers);
    }
  }

  const vtkSmartPointer<vtkABufferTransparencyPass> Pass = MakeABuffer(GetParam());
};

TEST_P(MemoryLimits, AreKeptWithThePicture)
{
  TestScene scene(42, 35);
  for (int i = 0; i < 9; ++i)
  {
    scene.AddSphere(0.1 * i - 0.4, 0.05 * i, 0.0, 0.4, { 0.1 * i, 0.5, 0.9, 0.3 });
  }
  scene.AddPlates(RandomPlates(60, 0.02, 5), 6);
  const Picture whole = ExpectTruth(scene, this->Pass, 3.0); // alpha rounds in many layers
  this->ExpectWholeInBands(scene, whole, { 2, 7, 40 });
}

TEST_P(MemoryLimits, AreKeptWithLongLists)
{
  TestScene scene(Width, Height);
  scene.AddPlates(RandomPlates(1100, 0.004, 19), 20);
  scene.Use(this->Pass);
  const Picture whole = scene.Render();
  this->ExpectWholeInBands(scene, whole, { 7 });
}

// What they hide behind opaque geometry takes no room that nobody counts.
TEST_P(MemoryLimits, AreKeptWithWritersOfDepth)
{
  TestScene scene(Width, Height);
  scene.AddRectangle(-0.7, -1.0, 0.9, 0.8, -0.5, { 0.9, 0.9, 0.8, 1.0 });
  for (int i = 0; i < 9; ++i)
  {
    scene.AddRectangle(-1.0, -1.0, 1.0, 1.0, -0.5, { 0.1 * i, 0.5, 1.0 - 0.1 * i, 0.3 })
      ->GetShaderProperty()
      ->AddFragmentShaderReplacement("//VTK::Depth::Impl", true,
        "gl_FragDepth = gl_FragCoord.z + (" + std::to_string(i - 4) +
          ".0 + gl_FragCoord.x / 8.0) * exp2(-24.0);\n",
        false);
  }
  const Picture whole = ExpectTruth(scene, this->Pass, 1.4);
  this->ExpectWholeInBands(scene, whole, { 2, 3, 10 });
}

TEST_P(MemoryLimits, ThatOnePixelAloneExceedsAreSaid)
{
  TestScene scene(Width, Height);
  scene.AddPlates(RandomPlates(100, 0.05, 7), 8);
  const Picture byVTK = scene.RenderAsVTK();
  this->Pass->SetMemoryLimit(400);
  scene.Use(this->Pass);
  EXPECT_TRUE(Matches(scene.Render(), byVTK));
  ExpectRefusal(this->Pass, "one pixel alone needs");
  const std::string reason = this->Pass->GetFallbackReason();
  EXPECT_NE(reason.find("its limit is 400 bytes"), std::string::npos) << reason;

  // The next frame says nothing new, and a higher limit is as good as ever.
  scene.Render();
  EXPECT_EQ(this->Pass->GetFallbackReason(), reason);
  this->Pass->SetMemoryLimit(0);
  ExpectTruth(scene, this->Pass, 3.0);
}

class Memory : public MemoryLimits
{
};

TEST_P(Memory, FollowsAZoomInTheSameFrame)
{
  TestScene scene(64, 64);
  for (int i = 0; i < 10; ++i)
  {
    scene.AddSphere(0.1 * i - 0.5, 0.0, 0.0, 0.4, { 0.1 * i, 0.5, 0.9, 0.3 });
  }
  const bool counts = std::string(this->Pass->GetMethodName()) == "prefix-sum";
  for (const double scale : { 20.0, 5.0, 1.0, 0.3, 20.0, 0.1, 1.0 })
  {
    SCOPED_TRACE(scale);
    scene.Renderer->GetActiveCamera()->SetParallelScale(scale);
    ExpectTruth(scene, this->Pass, 2.5);
    // Prefix sums that count first store at once, as the last frame had room. If there is none, they store again.
    EXPECT_LE(this->Pass->GetNumberOfGeometryPasses(), counts ? 3 : 2);
  }
}

TEST_P(Memory, IsGivenBackAfterAWhileAndNotBefore)
{
  TestScene scene(48, 36);
  const vtkSmartPointer<vtkActor> deep = scene.AddPlates(RandomPlates(60, 0.05, 11), 12);
  scene.AddPlates(RandomPlates(30, 0.05, 13), 14);
  scene.Use(this->Pass);
  for (int frame = 0; frame < 3; ++frame)
  {
    scene.Render();
  }
  const vtkTypeInt64 large = this->Pass->GetPoolBytes();
  scene.Renderer->RemoveActor(deep);
  for (int frame = 0; frame < 10; ++frame)
  {
    scene.Render();
    EXPECT_EQ(this->Pass->GetPoolBytes(), large) << "frame " << frame;
  }
  for (int frame = 10; frame < 40; ++frame)
  {
    scene.Render();
  }
  EXPECT_LT(this->Pass->GetPoolBytes(), large / 2);
  EXPECT_GE(this->Pass->GetPoolBytes(), this->Pass->GetNumberOfFragments() * 8);
  ExpectTruth(scene, this->Pass, 3.0);
}

INSTANTIATE_TEST_SUITE_P(Methods, MemoryLimits, testing::ValuesIn(ABufferMethods()), MethodName());
INSTANTIATE_TEST_SUITE_P(Methods, Memory, testing::ValuesIn(ABufferMethods()), MethodName());

}
