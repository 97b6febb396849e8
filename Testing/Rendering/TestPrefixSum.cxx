// The prefix-sum pass: how many geometry passes and how much memory a frame takes, and that frames are exact whatever
// the last one let expect.
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/VitrineOpenGL.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPrefixSumTransparencyPass.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTruthTransparencyPass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace
{

constexpr int Width = 42; // neither is a multiple of a block's 4 pixels
constexpr int Height = 35;

class PrefixSum : public testing::TestWithParam<int>
{
protected:
  vtkSmartPointer<vtkPrefixSumTransparencyPass> MakePass(bool prediction) const
  {
    auto pass = vtkSmartPointer<vtkPrefixSumTransparencyPass>::New();
    pass->SetColorStorage(GetParam());
    pass->SetPrediction(prediction);
    return pass;
  }
  int NodeBytes() const { return GetParam() == vtkPrefixSumTransparencyPass::HALF_FLOAT ? 12 : 8; }

  // The window depth, from 1/128 on, of a node's first word.
  float Depth(std::uint32_t word) const
  {
    const std::uint32_t bits =
      GetParam() == vtkPrefixSumTransparencyPass::COMPACT ? (word >> 6) + 0x3b800000u : word;
    float depth = 0.0f;
    std::memcpy(&depth, &bits, sizeof(depth));
    return depth;
  }
};

void AddSpheres(TestScene& scene)
{
  for (int i = 0; i < 9; ++i)
  {
    scene.AddSphere(0.1 * i - 0.4, 0.05 * i, 0.0, 0.4, { 0.1 * i, 0.5, 0.9, 0.3 });
  }
}

TEST_P(PrefixSum, CountedFramesTakeTwoGeometryPassesAndNoMoreMemoryThanFragments)
{
  TestScene scene(Width, Height);
  AddSpheres(scene);
  const vtkSmartPointer<vtkPrefixSumTransparencyPass> pass = this->MakePass(false);
  ExpectTruth(scene, pass, 1.4);
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 2);
    EXPECT_EQ(pass->GetPoolBytes(), pass->GetNumberOfFragments() * this->NodeBytes());
    scene.Render();
  }
}

TEST_P(PrefixSum, PredictedFramesTakeOneGeometryPassOnceOneWasCounted)
{
  TestScene scene(Width, Height);
  AddSpheres(scene);
  const vtkSmartPointer<vtkPrefixSumTransparencyPass> pass = this->MakePass(true);
  const Picture counted = ExpectTruth(scene, pass, 1.4);
  EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 2);
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_TRUE(Matches(scene.Render(), counted));
    EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 1);
  }
}

TEST_P(PrefixSum, SmallMovesAreFollowedInOneGeometryPass)
{
  TestScene scene(Width, Height);
  AddSpheres(scene);
  const vtkSmartPointer<vtkPrefixSumTransparencyPass> pass = this->MakePass(true);
  scene.Use(pass);
  scene.Render();
  for (int frame = 0; frame < 8; ++frame)
  {
    scene.Renderer->GetActiveCamera()->Elevation(0.5);
    ExpectTruth(scene, pass, 1.4);
    EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 1) << "frame " << frame;
  }
}

// In a few pixels each frame has one layer more than the last. After the first such frame rooms have a reserve of two
// fragments.
TEST_P(PrefixSum, RoomsHaveAReserveAfterSomeWereTooSmall)
{
  TestScene scene(Width, Height);
  scene.AddPlate(-0.8, { 0.9, 0.5, 0.2, 0.3 });
  const vtkSmartPointer<vtkPrefixSumTransparencyPass> pass = this->MakePass(true);
  for (const int passes : { 2, 2, 1, 1, 1 })
  {
    const double z = 0.1 * pass->GetMaximumNumberOfLayers();
    scene.AddRectangle(-0.05, -0.05, 0.05, 0.05, z, { 0.2, 0.5, 0.9, 0.3 });
    ExpectTruth(scene, pass, 1.4);
    EXPECT_EQ(pass->GetNumberOfGeometryPasses(), passes) << pass->GetMaximumNumberOfLayers();
  }
}

TEST_P(PrefixSum, NothingIsExpectedOfOtherWindowsAndViewports)
{
  TestScene scene(Width, Height);
  AddSpheres(scene);
  const vtkSmartPointer<vtkPrefixSumTransparencyPass> pass = this->MakePass(true);
  ExpectTruth(scene, pass, 1.4);
  const double viewports[][4] = { { 0.0, 0.0, 0.5, 1.0 }, { 0.3, 0.2, 0.9, 0.7 }, { 0, 0, 1, 1 } };
  vtkNew<vtkTruthTransparencyPass> truth;
  for (const auto& viewport : viewports)
  {
    scene.Renderer->SetViewport(viewport);
    scene.Use(truth);
    const Picture expected = scene.Render();
    scene.Use(pass);
    EXPECT_TRUE(Matches(scene.Render(), expected, 1));
    EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 2);
  }
  scene.Window->SetSize(Height, Width);
  ExpectTruth(scene, pass, 1.4);
  EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 2);
}

// A limit between what the fragments take and what is to be expected: such frames are counted.
TEST_P(PrefixSum, ExpectationsKeepTheLimit)
{
  TestScene scene(Width, Height);
  AddSpheres(scene);
  const vtkSmartPointer<vtkPrefixSumTransparencyPass> pass = this->MakePass(true);
  const Picture whole = ExpectTruth(scene, pass, 1.4);
  const vtkTypeInt64 needed = pass->GetNumberOfFragments() * this->NodeBytes();
  pass->SetMemoryLimit(needed);
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_TRUE(Matches(scene.Render(), whole));
    EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 2);
    EXPECT_EQ(pass->GetNumberOfBands(), 1);
    EXPECT_LE(pass->GetPoolBytes(), needed);
  }
}

TEST_P(PrefixSum, LimitsAreKeptInBands)
{
  TestScene scene(Width, Height);
  AddSpheres(scene);
  scene.AddPlates(RandomPlates(90, 0.02, 5), 6);
  const vtkSmartPointer<vtkPrefixSumTransparencyPass> pass = this->MakePass(true);
  const Picture whole = ExpectTruth(scene, pass, 3.0);
  const vtkTypeInt64 needed = pass->GetNumberOfFragments() * this->NodeBytes();
  for (const int part : { 2, 7, 40 })
  {
    SCOPED_TRACE(part);
    pass->SetMemoryLimit(needed / part);
    for (int frame = 0; frame < 2; ++frame)
    {
      EXPECT_TRUE(Matches(scene.Render(), whole));
      EXPECT_STREQ(pass->GetFallbackReason(), "");
      EXPECT_GE(pass->GetNumberOfBands(), part);
      EXPECT_LE(pass->GetPoolBytes(), pass->GetMemoryLimit());
      EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 1 + pass->GetNumberOfBands());
    }
  }
}

TEST_P(PrefixSum, NeedsNothingBesidesFragmentsForAPixelThatExceedsTheLimit)
{
  TestScene scene(Width, Height);
  scene.AddPlates(RandomPlates(100, 0.05, 7), 8);
  const vtkSmartPointer<vtkPrefixSumTransparencyPass> pass = this->MakePass(true);
  pass->SetMemoryLimit(50 * this->NodeBytes());
  scene.Use(pass);
  scene.Render();
  ExpectRefusal(pass, "one pixel alone needs " + std::to_string(100 * this->NodeBytes()));
}

// A pass over the geometry that makes more fragments than the one that counted: none is written outside of its pixel's
// room, and the frame says that it cannot be drawn.
class MoreEachDraw : public vtkCommand
{
public:
  static MoreEachDraw* New() { return new MoreEachDraw; }
  void Execute(vtkObject*, unsigned long, void* program) override
  {
    static_cast<vtkShaderProgram*>(program)->SetUniformf("shown", this->Shown);
    this->Shown += 3.0f;
  }
  float Shown = 2.0f;
};

void ShowMoreEachDraw(vtkActor* plate, MoreEachDraw* more)
{
  plate->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::Light::Dec", true, "//VTK::Light::Dec\nuniform float shown;\n", false);
  plate->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
    "//VTK::Light::Impl\nif (gl_FragCoord.x > shown) { discard; }\n", false);
  plate->GetMapper()->AddObserver(vtkCommand::UpdateShaderEvent, more);
}

// The words of the buffer that is so large.
std::vector<std::uint32_t> ReadBuffer(vtkTypeInt64 bytes)
{
  for (GLuint name = 1; name < 3000; ++name)
  {
    GLint64 size = 0;
    glBindBuffer(GL_COPY_READ_BUFFER, glIsBuffer(name) ? name : 0);
    if (glIsBuffer(name))
    {
      glGetBufferParameteri64v(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &size);
    }
    if (size == bytes)
    {
      std::vector<std::uint32_t> words(static_cast<std::size_t>(bytes) / sizeof(std::uint32_t));
      glGetBufferSubData(GL_COPY_READ_BUFFER, 0, bytes, words.data());
      glBindBuffer(GL_COPY_READ_BUFFER, 0);
      return words;
    }
  }
  ADD_FAILURE() << "there is no buffer of " << bytes << " bytes";
  return {};
}

TEST_P(PrefixSum, SaysSoWhereItsPassesDoNotAgreeAndWritesNothingOutsideOfRooms)
{
  TestScene scene(Width, Height);
  const vtkSmartPointer<vtkPrefixSumTransparencyPass> pass = this->MakePass(false);
  scene.Use(pass);
  const vtkSmartPointer<vtkActor> deep = scene.AddPlates(RandomPlates(30, 0.1, 3), 4);
  scene.Render(); // so that the buffer is large enough for all that comes, and stays
  deep->VisibilityOff();
  scene.AddPlates(RandomPlates(8, 0.3, 1), 2);
  const vtkSmartPointer<vtkActor> plate = scene.AddPlate(0.95, { 0.9, 0.2, 0.1, 0.5 });
  vtkNew<MoreEachDraw> more;
  ShowMoreEachDraw(plate, more);
  scene.Render();
  ExpectRefusal(pass, "more fragments each time");

  // The first of four attempts counts and stores. So the last of five passes had room for the 11 columns of the plate
  // that the fourth counted.
  const int texelBytes =
    this->NodeBytes() == 12 ? 8 : this->NodeBytes(); // The third word is elsewhere.
  const std::vector<std::uint32_t> words =
    ReadBuffer(pass->GetPoolBytes() / this->NodeBytes() * texelBytes);
  int ofPlate = 0;
  for (std::size_t i = 0; i < words.size(); i += texelBytes / sizeof(std::uint32_t))
  {
    ofPlate += std::abs(this->Depth(words[i]) - 0.025f) < 0.01f;
  }
  EXPECT_EQ(ofPlate, 11 * Height);
}

TEST_P(PrefixSum, FewerFragmentsThanCountedAreNoMatter)
{
  TestScene scene(Width, Height);
  const vtkSmartPointer<vtkActor> plate = scene.AddPlate(0.0, { 0.9, 0.2, 0.1, 0.5 });
  AddSpheres(scene);
  const vtkSmartPointer<vtkPrefixSumTransparencyPass> pass = this->MakePass(true);
  scene.Use(pass);
  scene.Render();
  plate->VisibilityOff();
  ExpectTruth(scene, pass, 1.4);
  EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 1);
}

TEST_P(PrefixSum, RefusesMoreFragmentsInAPixelThanHeadsCount)
{
  TestScene scene(3, 2);
  scene.AddPlates(RandomPlates(65535, 0.01, 1), 2);
  for (const bool prediction : { false, true })
  {
    const vtkSmartPointer<vtkPrefixSumTransparencyPass> pass = this->MakePass(prediction);
    scene.Use(pass);
    scene.Render();
    ExpectRefusal(pass, "65535 fragments or more");
  }
}

INSTANTIATE_TEST_SUITE_P(Storage, PrefixSum,
  testing::Values(vtkPrefixSumTransparencyPass::HALF_FLOAT, vtkPrefixSumTransparencyPass::EIGHT_BIT,
    vtkPrefixSumTransparencyPass::COMPACT),
  StorageName());

}
