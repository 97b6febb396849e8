// Tests what stencil routing requires of a driver, with drivers that differ from Mesa's llvmpipe. With multisampling
// off, llvmpipe tests the stencil of one sample for all samples of a pixel.
#include "Core/lists/StencilRouting.h"
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/VitrineOpenGL.h"
#include "vtkActor.h"
#include "vtkStencilRoutedTransparencyPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

constexpr int Width = 20;
constexpr int Height = 18;

// A driver that goes on multisampling after it is switched off, and so tests the stencil of each sample. A loader has
// no pointers for OpenGL's oldest functions. So other functions, which come last before a draw, switch it on again.
// With whole pixels, what the probe draws covers the pixel if it covers its centre. With geometry that covers whole
// pixels, that equals a driver which tests the stencil of each sample with the coverage of the centre.
class MultisamplingDriver
{
public:
  explicit MultisamplingDriver(bool wholePixels)
  {
    WholePixels = wholePixels;
    Uniform = glUniform1f;
    Draw = glDrawRangeElements;
    glUniform1f = SetUniform;
    glDrawRangeElements = DrawElements;
  }
  ~MultisamplingDriver()
  {
    glUniform1f = Uniform;
    glDrawRangeElements = Draw;
  }

private:
  static void GLAPIENTRY SetUniform(GLint location, GLfloat value)
  {
    glEnable(GL_MULTISAMPLE);
    Uniform(location, WholePixels && IsEdge(location) ? std::copysign(8.0f, value) : value);
  }
  static bool IsEdge(GLint location)
  {
    GLint program = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &program);
    return glGetUniformLocation(static_cast<GLuint>(program), "edge") == location && location >= 0;
  }
  static void GLAPIENTRY DrawElements(
    GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type, const void* indices)
  {
    glEnable(GL_MULTISAMPLE);
    Draw(mode, start, end, count, type, indices);
  }
  static bool WholePixels;
  static decltype(glUniform1f) Uniform;
  static decltype(glDrawRangeElements) Draw;
};
bool MultisamplingDriver::WholePixels = false;
decltype(glUniform1f) MultisamplingDriver::Uniform = nullptr;
decltype(glDrawRangeElements) MultisamplingDriver::Draw = nullptr;

// A driver whose sample mask counts samples from another one on than shaders do.
class ShiftedSampleMask
{
public:
  ShiftedSampleMask()
  {
    Driver = glSampleMaski;
    glSampleMaski = SetMask;
  }
  ~ShiftedSampleMask() { glSampleMaski = Driver; }

private:
  static void GLAPIENTRY SetMask(GLuint word, GLbitfield mask)
  {
    const bool isOne = mask != 0 && (mask & (mask - 1)) == 0;
    Driver(word, !isOne ? mask : mask == 8u ? 1u : mask << 1);
  }
  static decltype(glSampleMaski) Driver;
};
decltype(glSampleMaski) ShiftedSampleMask::Driver = nullptr;

// A driver whose colours, unlike its stencil, have no more than so many samples, whatever it says.
class FewColorSamples
{
public:
  explicit FewColorSamples(GLsizei samples)
  {
    Most = samples;
    Driver = glTexImage3DMultisample;
    glTexImage3DMultisample = Allocate;
  }
  ~FewColorSamples() { glTexImage3DMultisample = Driver; }

private:
  static void GLAPIENTRY Allocate(GLenum target, GLsizei samples, GLenum internalFormat,
    GLsizei width, GLsizei height, GLsizei layers, GLboolean fixed)
  {
    Driver(target, samples, internalFormat, samples > Most ? -1 : width, height, layers, fixed);
  }
  static GLsizei Most;
  static decltype(glTexImage3DMultisample) Driver;
};
GLsizei FewColorSamples::Most = 0;
decltype(glTexImage3DMultisample) FewColorSamples::Driver = nullptr;

// A scene whose context is there: the loader sets its pointers with it.
struct ReadyScene : TestScene
{
  ReadyScene()
    : TestScene(Width, Height)
  {
    this->Render();
  }
};

vtkSmartPointer<vtkStencilRoutedTransparencyPass> MakePass(int samples, int storage = 0)
{
  auto pass = vtkSmartPointer<vtkStencilRoutedTransparencyPass>::New();
  pass->SetSamplesPerPass(samples);
  pass->SetColorStorage(storage);
  return pass;
}

// Plates that fill the view, drawn exactly, `perPass` of them in each pass over the geometry.
void ExpectExactStack(
  TestScene& scene, vtkStencilRoutedTransparencyPass* pass, int layers, int perPass)
{
  SCOPED_TRACE(layers);
  const std::vector<Rgba> plates = RandomPlates(layers, std::min(0.5, 3.0 / layers), 3);
  const vtkSmartPointer<vtkActor> stack = scene.AddPlates(plates, 4);
  scene.Use(pass);
  const double tolerance =
    pass->GetColorStorage() == vtkStencilRoutedTransparencyPass::HALF_FLOAT ? 0.6 : 1.4;
  for (int frame = 0; frame < 2; ++frame) // the first may draw a pass again for want of room
  {
    const Rgba color = UniformColor(scene.Render());
    ASSERT_STREQ(pass->GetFallbackReason(), "");
    ExpectColor(color, CompositePlates(plates, TestBackground), tolerance);
  }
  EXPECT_EQ(pass->GetMaximumNumberOfLayers(), layers);
  EXPECT_EQ(pass->GetNumberOfFragments(), layers * Width * Height);
  EXPECT_EQ(pass->GetNumberOfLostFragments(), 0);
  EXPECT_EQ(pass->GetNumberOfGeometryPasses(), (layers + perPass - 1) / perPass);
  scene.Renderer->RemoveActor(stack);
}

class RoutingDrivers : public testing::TestWithParam<int>
{
};

TEST_P(RoutingDrivers, ThatTestEachSampleAreRoutedOn)
{
  ReadyScene scene;
  const MultisamplingDriver driver(true);
  const int k = GetParam();
  const auto pass = MakePass(k);
  for (const int layers :
    { 1, k - 1, k, k + 1, 2 * k + 1, 33, 65, k * vitrine::StencilRoute(k).MostPasses() })
  {
    ExpectExactStack(scene, pass, layers, k);
  }
  ExpectExactStack(scene, MakePass(k, vtkStencilRoutedTransparencyPass::EIGHT_BIT), 2 * k + 1, k);
}

// The probe sees by the edges of what it draws that coverage is the samples', not the pixel centre's.
TEST_P(RoutingDrivers, ThatGoOnMultisamplingAreRefused)
{
  ReadyScene scene;
  const MultisamplingDriver driver(false);
  scene.AddParts();
  const Picture byVTK = scene.RenderAsVTK();
  const auto pass = MakePass(GetParam());
  scene.Use(pass);
  EXPECT_TRUE(Matches(scene.Render(), byVTK));
  ExpectRefusal(pass, "goes on multisampling");
  EXPECT_TRUE(Matches(scene.Render(), byVTK));
}

TEST_P(RoutingDrivers, WhoseSamplesHaveOtherNumbersAreRefused)
{
  ReadyScene scene;
  const MultisamplingDriver driver(true);
  const ShiftedSampleMask shifted;
  scene.AddPlate(0.0, { 0.2, 0.4, 0.6, 0.5 });
  const auto pass = MakePass(GetParam());
  scene.Use(pass);
  scene.Render();
  ExpectRefusal(pass, std::to_string(GetParam()) + " samples");
}

// An application's query of samples runs: no other can begin, and none is needed.
TEST_P(RoutingDrivers, MayHaveAQueryRunning)
{
  ReadyScene scene;
  const MultisamplingDriver driver(true);
  GLuint query = 0;
  glGenQueries(1, &query);
  const auto pass = MakePass(GetParam());
  scene.AddPlate(0.0, { 0.2, 0.4, 0.6, 0.5 });
  scene.Use(pass);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  scene.Render();
  EXPECT_STREQ(pass->GetFallbackReason(), "");
  GLint running = 0;
  glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &running);
  EXPECT_EQ(running, static_cast<GLint>(query));
  glEndQuery(GL_SAMPLES_PASSED);
  glDeleteQueries(1, &query);
}

// What an application lets decide about samples decides nothing here, and is as it was.
TEST_P(RoutingDrivers, MayHaveSamplesSwitchedOff)
{
  ReadyScene scene;
  const MultisamplingDriver driver(true);
  const std::vector<Rgba> plates = RandomPlates(7, 0.4, 3);
  scene.AddPlates(plates, 4);
  const auto pass = MakePass(GetParam());
  scene.Use(pass);
  const GLenum capabilities[] = { GL_SAMPLE_MASK, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_COVERAGE };
  std::for_each(std::begin(capabilities), std::end(capabilities), glEnable);
  glSampleMaski(0, 0u);
  glSampleCoverage(0.0f, GL_FALSE);
  ExpectColor(UniformColor(scene.Render()), CompositePlates(plates, TestBackground), 0.6);
  EXPECT_STREQ(pass->GetFallbackReason(), "");
  GLint mask = -1;
  glGetIntegeri_v(GL_SAMPLE_MASK_VALUE, 0, &mask);
  EXPECT_EQ(mask, 0);
  for (const GLenum capability : capabilities)
  {
    EXPECT_TRUE(glIsEnabled(capability)) << capability;
    glDisable(capability);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Samples, RoutingDrivers, testing::Values(2, 4), testing::PrintToStringParamName());

TEST(AutomaticSamples, AreTheMostThatAreRouted)
{
  ReadyScene scene;
  const MultisamplingDriver driver(true);
  GLint most = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  ExpectExactStack(scene, MakePass(0), 24, std::min(most, 8));
}

// Fewer samples are tried where only the stencil has more.
TEST(AutomaticSamples, AreAsManyAsColoursHave)
{
  ReadyScene scene;
  const MultisamplingDriver driver(true);
  const FewColorSamples few(2);
  ExpectExactStack(scene, MakePass(0), 24, 2);
  EXPECT_FALSE(TakeMessages().empty()); // what OpenGL says of the refused images
}

TEST(AutomaticSamples, AreOneWhereMultisamplingGoesOn)
{
  ReadyScene scene;
  const MultisamplingDriver driver(false);
  ExpectExactStack(scene, MakePass(0), 24, 1);
  scene.AddParts();
  const auto pass = MakePass(0);
  ExpectTruth(scene, pass, 0.75);
}

}
