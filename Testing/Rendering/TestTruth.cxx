// The yardstick against closed forms and against what an occlusion query counts.
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/VitrineOpenGL.h"
#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTranslucentPass.h"
#include "vtkTruthTransparencyPass.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

// Draws translucent geometry as VTK does, and counts the samples that pass.
class SampleCountingPass : public vtkTranslucentPass
{
public:
  static SampleCountingPass* New();
  vtkTypeMacro(SampleCountingPass, vtkTranslucentPass);

  void Render(const vtkRenderState* s) override
  {
    GLuint query = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_SAMPLES_PASSED, query);
    this->Superclass::Render(s);
    glEndQuery(GL_SAMPLES_PASSED);
    GLuint64 samples = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &samples);
    glDeleteQueries(1, &query);
    this->SampleCount = static_cast<vtkTypeInt64>(samples);
  }

  vtkTypeInt64 SampleCount = 0;
};
vtkStandardNewMacro(SampleCountingPass);

vtkTypeInt64 QueriedSamples(TestScene& scene)
{
  vtkNew<SampleCountingPass> counting;
  scene.Use(counting);
  scene.Render();
  return counting->SampleCount;
}

void ExpectTruthToCountWhatIsSeen(TestScene& scene)
{
  const vtkTypeInt64 seen = QueriedSamples(scene);
  vtkNew<vtkTruthTransparencyPass> truth;
  scene.Use(truth);
  scene.Render();
  EXPECT_GT(seen, 0);
  EXPECT_EQ(truth->GetNumberOfSamples(), seen);
}

class Truth : public testing::TestWithParam<int>
{
};

TEST(TruthClosedForm, PlatesInFloat)
{
  for (const int layers : { 1, 2, 3, 50, 1000 })
  {
    for (const double alpha : { 1.0 / 255, 0.2, 0.8, 1.0 })
    {
      SCOPED_TRACE(std::to_string(layers) + " layers of alpha " + std::to_string(alpha));
      TestScene scene(5, 3);
      scene.Renderer->SetBackgroundAlpha(0.2);
      const std::vector<Rgba> plates = RandomPlates(layers, alpha, 11);
      scene.AddPlates(plates, 12);
      vtkNew<vtkTruthTransparencyPass> truth;
      scene.Use(truth);
      scene.Render();
      ASSERT_STREQ(truth->GetFallbackReason(), "");
      EXPECT_EQ(truth->GetNumberOfFragments(), layers * 5 * 3);
      EXPECT_EQ(truth->GetNumberOfSamples(), layers * 5 * 3);
      EXPECT_EQ(truth->GetMaximumNumberOfLayers(), layers);
      EXPECT_DOUBLE_EQ(truth->GetMeanNumberOfLayers(), layers);
      EXPECT_EQ(truth->GetNumberOfGeometryPasses(), 1);

      const Rgba expected = CompositePlates(plates, { 0.2, 0.6, 0.4, 0.2 });
      vtkImageData* result = truth->GetResult();
      for (int y = 0; y < 3; ++y)
      {
        for (int x = 0; x < 5; ++x)
        {
          for (int c = 0; c < 4; ++c)
          {
            ASSERT_NEAR(result->GetScalarComponentAsDouble(x, y, 0, c), expected[c], 2e-6)
              << x << ", " << y << ", channel " << c;
          }
        }
      }
    }
  }
}

TEST(TruthClosedForm, FramesWithoutTranslucentGeometryHaveNoResult)
{
  TestScene scene(5, 3);
  scene.AddPlates(RandomPlates(2, 0.5, 11), 12);
  vtkNew<vtkTruthTransparencyPass> truth;
  scene.Use(truth);
  scene.Render();
  EXPECT_NE(truth->GetResult(), nullptr);
  scene.Renderer->RemoveAllViewProps();
  scene.Render();
  EXPECT_EQ(truth->GetResult(), nullptr);
  EXPECT_EQ(truth->GetNumberOfSamples(), 0);
}

// What is drawn in parts is drawn whole: each pixel once, none left out.
TEST(TruthClosedForm, MoreFragmentsThanOneBufferHolds)
{
  constexpr int width = 301;
  constexpr int height = 300;
  constexpr int layers = 50;
  TestScene scene(width, height);
  const std::vector<Rgba> plates = RandomPlates(layers, 0.1, 13);
  scene.AddPlates(plates, 14);
  vtkNew<vtkTruthTransparencyPass> truth;
  scene.Use(truth);
  const Picture picture = scene.Render();
  EXPECT_GT(truth->GetNumberOfGeometryPasses(), 2);
  EXPECT_EQ(truth->GetNumberOfFragments(), std::int64_t(layers) * width * height);
  EXPECT_EQ(truth->GetNumberOfSamples(), std::int64_t(layers) * width * height);
  const Rgba color = UniformColor(picture);
  const Rgba expected = CompositePlates(plates, TestBackground);
  for (int c = 0; c < 4; ++c)
  {
    EXPECT_NEAR(color[c], expected[c], 0.51 / 255);
  }
}

TEST_P(Truth, CountsSamplesAsAnOcclusionQueryDoes)
{
  TestScene scene(61, 47, GetParam());
  scene.AddSphere(0.3, 0.1, 0.2, 0.5, { 0.9, 0.5, 0.1, 0.4 });
  scene.AddSphere(-0.2, -0.1, -0.3, 0.7, { 0.1, 0.5, 0.9, 0.6 });
  scene.AddRectangle(-0.83, -0.37, 0.41, 0.59, 0.1, { 0.5, 0.9, 0.5, 0.3 });
  const vtkTypeInt64 all = QueriedSamples(scene);
  vtkNew<vtkTruthTransparencyPass> truth;
  scene.Use(truth);
  scene.Render();
  EXPECT_EQ(truth->GetNumberOfSamples(), all);

  // An opaque rectangle in front of a part of it all, with edges that cut through pixels.
  scene.AddRectangle(-0.317, -0.513, 0.711, 0.234, 0.9, { 1.0, 1.0, 1.0, 1.0 });
  const vtkTypeInt64 seen = QueriedSamples(scene);
  EXPECT_LT(seen, all);
  EXPECT_GT(seen, 0);
  scene.Use(truth);
  scene.Render();
  EXPECT_EQ(truth->GetNumberOfSamples(), seen);
  if (GetParam() == 0)
  {
    EXPECT_EQ(truth->GetNumberOfFragments(), seen);
  }
}

TEST_P(Truth, CountsWhatLiesInOpaqueGeometryAsAnOcclusionQueryDoes)
{
  for (const bool stencil : { false, true })
  {
    SCOPED_TRACE(stencil ? "24 bits of depth" : "32 bits of depth");
    TestScene scene(40, 30, GetParam());
    scene.Window->SetStencilCapable(stencil);
    scene.AddRectangle(-0.713, -0.9, 0.5, 0.9, 0.125, { 1.0, 1.0, 1.0, 1.0 });
    scene.AddRectangle(-0.9, -0.717, 0.7, 0.3, 0.125, { 0.2, 0.5, 0.9, 0.4 });
    scene.AddRectangle(-0.9, -0.717, 0.9, 0.9, 0.1, { 0.9, 0.5, 0.9, 0.4 });
    ExpectTruthToCountWhatIsSeen(scene);
  }
}

// A shader that writes gl_FragDepth is tested against the opaque depth by hand.
TEST_P(Truth, CountsWritersOfDepthAsAnOcclusionQueryDoes)
{
  for (const bool stencil : { false, true })
  {
    SCOPED_TRACE(stencil ? "24 bits of depth" : "32 bits of depth");
    TestScene scene(40, 30, GetParam());
    scene.Window->SetStencilCapable(stencil);
    scene.AddRectangle(-0.713, -0.9, 0.5, 0.9, 0.125, { 1.0, 1.0, 1.0, 1.0 });
    // What is rasterised in the opaque plane, behind it and in front, is written to either side of it.
    for (const double z : { 0.125, -0.4, 0.4 })
    {
      for (const double offset : { 0.0, 0.001, -0.001, 0.7, -0.7 })
      {
        vtkSmartPointer<vtkActor> actor =
          scene.AddRectangle(-0.9, -0.717, 0.7, 0.3, z, { 0.2, 0.5, 0.9, 0.4 });
        actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Depth::Impl", true,
          "gl_FragDepth = gl_FragCoord.z + " + std::to_string(offset) + ";\n", false);
      }
    }
    ExpectTruthToCountWhatIsSeen(scene);
  }
}

// Shaders write depths that differ by a few steps of the depth buffer. Some drivers lose one or two steps when they
// sample it. None is lost of 32 bits without samples, where depths differ by one float step.
TEST_P(Truth, CountsWritersOfDepthToAFewSteps)
{
  for (const bool stencil : { false, true })
  {
    SCOPED_TRACE(stencil ? "24 bits of depth" : "32 bits of depth");
    TestScene scene(64, 48, GetParam());
    scene.Window->SetStencilCapable(stencil);
    for (const double z : { -0.6, 0.7 })
    {
      const double y = z > 0.0 ? 0.0 : -0.9;
      const bool exact = GetParam() == 0 && !stencil;
      const int least = exact ? 1 : 4;
      const int exponent = exact && z > 0.0 ? -26 : -24; // depths of the window are 0.15 and 0.8
      scene.AddRectangle(-0.9, y, 0.9, y + 0.9, z, { 1.0, 1.0, 1.0, 1.0 });
      for (const int steps : { -2 * least, -least, 0, least, 2 * least })
      {
        scene.AddRectangle(-0.9, y, 0.9, y + 0.9, z, { 0.2, 0.5, 0.9, 0.4 })
          ->GetShaderProperty()
          ->AddFragmentShaderReplacement("//VTK::Depth::Impl", true,
            "gl_FragDepth = gl_FragCoord.z + " + std::to_string(steps) + ".0 * exp2(" +
              std::to_string(exponent) + ".0);\n",
            false);
      }
    }
    ExpectTruthToCountWhatIsSeen(scene);
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, Truth, testing::Values(0, 4), testing::PrintToStringParamName());

}
