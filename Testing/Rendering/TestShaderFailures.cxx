// Drivers that cannot compile a shader of a method: the frame is VTK's, blended once, and the reason is said once.
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/ProgramCache.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "gl/VitrineOpenGL.h"
#include "transparency/ranks/SamplePixels.h"
#include "vtkABufferTransparencyPass.h"
#include "vtkActor.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkStencilRoutedTransparencyPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace
{

// A driver that rejects the shader composed from `file` of Module/Shaders.
class RejectedShader
{
public:
  explicit RejectedShader(const std::string& file)
  {
    Legend = "// composed from: 1=" + file + ".glsl";
    Rejections = 0;
    SetSourceOfDriver = glShaderSource;
    CreateProgramOfDriver = glCreateShaderProgramv;
    glShaderSource = SetSource;
    glCreateShaderProgramv = CreateProgram;
  }
  ~RejectedShader()
  {
    glShaderSource = SetSourceOfDriver;
    glCreateShaderProgramv = CreateProgramOfDriver;
  }
  static int Rejections;

private:
  static std::string Spoilt(std::string text)
  {
    if (text.find(Legend) != std::string::npos)
    {
      ++Rejections;
      text += "\n#error rejected\n";
    }
    return text;
  }
  static void GLAPIENTRY SetSource(
    GLuint shader, GLsizei count, const GLchar* const* strings, const GLint* lengths)
  {
    std::string text;
    for (GLsizei i = 0; i < count; ++i)
    {
      text += lengths && lengths[i] >= 0 ? std::string(strings[i], lengths[i]) : strings[i];
    }
    text = Spoilt(text);
    const GLchar* source = text.c_str();
    SetSourceOfDriver(shader, 1, &source, nullptr);
  }
  static GLuint GLAPIENTRY CreateProgram(GLenum type, GLsizei, const GLchar* const* strings)
  {
    const std::string text = Spoilt(strings[0]);
    const GLchar* source = text.c_str();
    return CreateProgramOfDriver(type, 1, &source);
  }
  static std::string Legend;
  static decltype(glShaderSource) SetSourceOfDriver;
  static decltype(glCreateShaderProgramv) CreateProgramOfDriver;
};
int RejectedShader::Rejections = 0;
std::string RejectedShader::Legend;
decltype(glShaderSource) RejectedShader::SetSourceOfDriver = nullptr;
decltype(glCreateShaderProgramv) RejectedShader::CreateProgramOfDriver = nullptr;

// Frames in which a shader is rejected. Returns how often the first one drew the geometry.
int ExpectFallbackOnce(TestScene& scene, vtkTransparencyPass* pass, const Picture& byVTK)
{
  int geometryPasses = 0;
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_TRUE(Matches(scene.Render(), byVTK)) << "frame " << frame;
    EXPECT_NE(std::string(pass->GetFallbackReason()).find("cannot compile"), std::string::npos)
      << pass->GetFallbackReason();
    const std::vector<std::string> messages = TakeMessages();
    const auto said = std::count_if(messages.begin(), messages.end(),
      [](const std::string& m) { return m.find("cannot draw here") != std::string::npos; });
    EXPECT_EQ(said, frame == 0 ? 1 : 0);
    EXPECT_EQ(messages.empty(), frame > 0); // VTK says what the driver says
    EXPECT_TRUE(frame == 0 || pass->GetNumberOfGeometryPasses() == 1);
    geometryPasses = std::max(geometryPasses, pass->GetNumberOfGeometryPasses());
  }
  EXPECT_EQ(RejectedShader::Rejections, 1);
  return geometryPasses;
}

// Each in a window of its own: VTK tries no program again that failed in the window.
struct LayeredScene : TestScene
{
  LayeredScene()
    : TestScene(64, 48)
  {
    this->AddPlates(RandomPlates(3, 0.3, 1), 2);
  }
  // Long lists in the middle, short ones elsewhere.
  void AddLongLists(int layers)
  {
    this->AddPlates(RandomPlates(layers, 0.02, 3), 4)->SetScale(0.03, 0.03, 1.0);
  }
};

struct LongLists
{
  const char* Shader;
  int Layers;
};

// The resolve shaders are the same for all methods that store every fragment, except for reading linked or packed
// lists.
const std::vector<Method> ListMethods = MethodsThat([](const Method& method)
  { return method.Name == "LinkedListHalfFloat" || method.Name == "PrefixSumPredicted"; });

class ResolveFailures : public testing::TestWithParam<Method>
{
protected:
  const vtkSmartPointer<vtkABufferTransparencyPass> Pass = MakeABuffer(GetParam());
};

// The program for the long lists is the one that fails, when that for the short ones is there already.
TEST_P(ResolveFailures, OfLongListsBlendNothingTwice)
{
  for (const LongLists& lists : { LongLists{ "ListResolve", 40 }, LongLists{ "ListSortRuns", 100 },
         LongLists{ "ListMergeRuns", 100 }, LongLists{ "ListSortLongRuns", 1100 } })
  {
    for (const bool inBands : { false, true })
    {
      SCOPED_TRACE(std::string(lists.Shader) + (inBands ? ", in bands" : ""));
      LayeredScene scene;
      const vtkSmartPointer<vtkABufferTransparencyPass> pass = MakeABuffer(GetParam());
      scene.Use(pass);
      scene.Render();
      EXPECT_STREQ(pass->GetFallbackReason(), "");

      scene.AddLongLists(lists.Layers);
      const Picture byVTK = scene.RenderAsVTK();
      if (inBands)
      {
        pass->SetMemoryLimit(40000); // the first band has short lists only
      }
      scene.Use(pass);
      const RejectedShader rejected(lists.Shader);
      const int geometryPasses = ExpectFallbackOnce(scene, pass, byVTK);
      EXPECT_EQ(geometryPasses > 3, inBands); // filled, filled again, and VTK's; or bands
    }
  }
}

// All lists fit at once, so the short ones are drawn before the program for the long ones fails.
TEST_P(ResolveFailures, OfListsThatFitLeaveNothingOfThoseDrawnBefore)
{
  LayeredScene scene;
  const vtkSmartPointer<vtkActor> deep = scene.AddPlates(RandomPlates(20, 0.1, 5), 6);
  scene.Use(this->Pass);
  scene.Render();
  deep->VisibilityOff();
  scene.Render();
  EXPECT_EQ(this->Pass->GetNumberOfGeometryPasses(), 1);

  scene.AddLongLists(40);
  const Picture byVTK = scene.RenderAsVTK();
  scene.Use(this->Pass);
  const RejectedShader rejected("ListResolve");
  EXPECT_GE(ExpectFallbackOnce(scene, this->Pass, byVTK), 2); // filled, and VTK's
}

// The second frame compiles the program for the short lists, beside that for the long ones.
TEST_P(ResolveFailures, OfShortListsBlendNothingTwice)
{
  LayeredScene scene;
  scene.AddLongLists(100);
  const Picture byVTK = scene.RenderAsVTK();
  ExpectTruth(scene, this->Pass, 0.75);
  const RejectedShader rejected("ListResolve");
  ExpectFallbackOnce(scene, this->Pass, byVTK);
}

INSTANTIATE_TEST_SUITE_P(Methods, ResolveFailures, testing::ValuesIn(ListMethods), MethodName());

//------------------------------------------------------------------------------
// A shader of a method's own, which it cannot do without. The first frame of prefix sums counts; the second predicts.
struct OwnShader
{
  const char* Method;
  const char* Shader;
  int FramesBefore = 0;
};

std::ostream& operator<<(std::ostream& os, const OwnShader& own)
{
  return os << own.Method << own.Shader;
}

const OwnShader OwnShaders[] = {
  { "LinkedListHalfFloat", "TileClassify" },
  { "PrefixSumPredicted", "TileClassify" },
  { "PrefixSumPredicted", "ScanCounts" },
  { "PrefixSumPredicted", "ScanUp" },
  { "PrefixSumPredicted", "ScanDown" },
  { "PrefixSumPredicted", "PlaceCounted" },
  { "PrefixSumPredicted", "ScanPrediction", 1 },
  { "PrefixSumPredicted", "PlacePredicted", 1 },
  { "StencilRoutedHalfFloat", "StencilRoutedResolve" },
  { "StencilMask9", "StencilMaskResolve" },
  { "StencilMask9", "StencilMaskMark" },
  { "StencilMask9", "StencilMaskFilter" },
  { "Truth", "SampleRead" },
  { "Truth", "SampleWrite" },
};

class ShaderFailures : public testing::TestWithParam<OwnShader>
{
protected:
  static vtkSmartPointer<vtkTransparencyPass> MakePass()
  {
    const auto method = std::find_if(AllMethods().begin(), AllMethods().end(),
      [](const Method& m) { return m.Name == GetParam().Method; });
    return method->Make();
  }
};

TEST_P(ShaderFailures, AreSaid)
{
  LayeredScene scene;
  const Picture byVTK = scene.RenderAsVTK();
  const vtkSmartPointer<vtkTransparencyPass> pass = MakePass();
  scene.Use(pass);
  for (int frame = 0; frame < GetParam().FramesBefore; ++frame)
  {
    scene.Render();
    EXPECT_STREQ(pass->GetFallbackReason(), "");
  }
  const RejectedShader rejected(GetParam().Shader);
  ExpectFallbackOnce(scene, pass, byVTK);
}

INSTANTIATE_TEST_SUITE_P(
  Shaders, ShaderFailures, testing::ValuesIn(OwnShaders), testing::PrintToStringParamName());

//------------------------------------------------------------------------------
TEST(RoutedShaderFailures, OfLongListsBlendNothingTwice)
{
  LayeredScene scene;
  vtkNew<vtkStencilRoutedTransparencyPass> pass;
  scene.Use(pass);
  scene.Render();
  EXPECT_STREQ(pass->GetFallbackReason(), "");
  scene.AddLongLists(40);
  const Picture byVTK = scene.RenderAsVTK();
  scene.Use(pass);
  const RejectedShader rejected("StencilRoutedResolveLong");
  ExpectFallbackOnce(scene, pass, byVTK);
}

// Shaders that only several samples a pass take.
class SamplesShaderFailures : public testing::TestWithParam<const char*>
{
};

TEST_P(SamplesShaderFailures, AreSaid)
{
  LayeredScene scene;
  const Picture byVTK = scene.RenderAsVTK();
  vtkNew<vtkStencilRoutedTransparencyPass> pass;
  pass->SetSamplesPerPass(4);
  scene.Use(pass);
  const RejectedShader rejected(GetParam());
  ExpectFallbackOnce(scene, pass, byVTK);
}

TEST_P(SamplesShaderFailures, LeaveOneSampleToBeChosen)
{
  LayeredScene scene;
  scene.RenderAsVTK(); // the context, with which the loader sets its pointers
  vtkNew<vtkStencilRoutedTransparencyPass> pass;
  scene.Use(pass);
  const RejectedShader rejected(GetParam());
  scene.Render();
  EXPECT_GT(RejectedShader::Rejections, 0);
  EXPECT_FALSE(TakeMessages().empty()); // VTK says what the driver says
  ExpectTruth(scene, pass, 0.75);
}

INSTANTIATE_TEST_SUITE_P(Shaders, SamplesShaderFailures,
  testing::Values(
    "StencilOnly", "StencilRoutedProbe", "StencilRoutedProbeVertex", "StencilRoutedVerdict"),
  [](const auto& info) { return std::string(info.param); });

//------------------------------------------------------------------------------
// Ranks read the samples of their targets, and tell each other the reason.
TEST(SamplePixelsShaderFailures, AreSaid)
{
  for (const char* const shader : { "SampleRead", "SampleWrite", "SampleDepth" })
  {
    SCOPED_TRACE(shader);
    TestScene scene(8, 8, 4);
    scene.Render();
    auto* const window = vtkOpenGLRenderWindow::SafeDownCast(scene.Window);
    const vitrine::ScopedTrackedState trackedState(window->GetState());
    const vitrine::ScopedShaderProgram program(window);
    window->GetRenderFramebuffer()->Bind();
    vitrine::RenderTarget target;
    ASSERT_EQ(target.Probe(window, {}), "");
    ASSERT_EQ(target.Samples, 4);
    const RejectedShader rejected(shader);
    vitrine::SamplePixels samples;
    std::vector<std::uint32_t> words;
    EXPECT_EQ(samples.ReadDepths(window, target, words), vitrine::ProgramFailure);
    EXPECT_EQ(RejectedShader::Rejections, 1);
    EXPECT_FALSE(TakeMessages().empty()); // VTK says what the driver says
    samples.Release();
  }
}

//------------------------------------------------------------------------------
TEST(ProgramCache, CompilesABrokenProgramOnce)
{
  TestScene scene(4, 4);
  scene.Render();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(scene.Window);
  const char* const vertex = "void main() { gl_Position = vec4(0.0); }\n";
  vitrine::ProgramCache programs;
  int asked = 0;
  std::string fragment = "void main() { missing(); }\n";
  const auto ready = [&]
  {
    return programs.Ready(window, "colours", { "VITRINE_TEST" }, vertex,
      [&]
      {
        ++asked;
        return fragment;
      });
  };
  EXPECT_FALSE(programs.HasFailed());
  EXPECT_EQ(ready(), nullptr);
  EXPECT_FALSE(TakeMessages().empty());
  EXPECT_TRUE(programs.HasFailed());
  EXPECT_EQ(ready(), nullptr);
  EXPECT_TRUE(TakeMessages().empty());
  EXPECT_EQ(asked, 1);

  programs.Release();
  EXPECT_FALSE(programs.HasFailed());
  fragment = "out vec4 color; void main() { color = vec4(1.0); }\n";
  EXPECT_NE(ready(), nullptr);
  EXPECT_FALSE(programs.HasFailed());
  EXPECT_EQ(asked, 2);
}

}
