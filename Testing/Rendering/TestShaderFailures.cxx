// Drivers that cannot compile a shader of a method: the frame is VTK's, blended once, and the reason is said once.
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/ProgramCache.h"
#include "gl/VitrineOpenGL.h"
#include "vtkActor.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkTranslucentPass.h"
#include "vtkTruthTransparencyPass.h"

#include <gtest/gtest.h>

#include <algorithm>

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
    Driver = glShaderSource;
    glShaderSource = SetSource;
  }
  ~RejectedShader() { glShaderSource = Driver; }
  static int Rejections;

private:
  static void GLAPIENTRY SetSource(
    GLuint shader, GLsizei count, const GLchar* const* strings, const GLint* lengths)
  {
    std::string text;
    for (GLsizei i = 0; i < count; ++i)
    {
      text += lengths && lengths[i] >= 0 ? std::string(strings[i], lengths[i]) : strings[i];
    }
    if (text.find(Legend) != std::string::npos)
    {
      ++Rejections;
      text += "\n#error rejected\n";
    }
    const GLchar* source = text.c_str();
    Driver(shader, 1, &source, nullptr);
  }
  static std::string Legend;
  static decltype(glShaderSource) Driver;
};
int RejectedShader::Rejections = 0;
std::string RejectedShader::Legend;
decltype(glShaderSource) RejectedShader::Driver = nullptr;

Picture RenderAsVTK(TestScene& scene)
{
  vtkNew<vtkOrderIndependentTranslucentPass> weighted;
  vtkNew<vtkTranslucentPass> translucent;
  weighted->SetTranslucentPass(translucent);
  scene.Use(weighted);
  return scene.Render();
}

// Frames in which a shader is rejected. Returns how often the first one drew the geometry.
int ExpectFallbackOnce(TestScene& scene, vtkTransparencyPass* pass, const Picture& byVTK)
{
  int geometryPasses = 0;
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_TRUE(scene.Render() == byVTK) << "frame " << frame;
    EXPECT_NE(std::string(pass->GetFallbackReason()).find("cannot compile"), std::string::npos)
      << pass->GetFallbackReason();
    const std::vector<std::string> messages = TakeMessages();
    const auto said = std::count_if(messages.begin(), messages.end(),
      [](const std::string& m) { return m.find("cannot draw here") != std::string::npos; });
    EXPECT_EQ(said, frame == 0 ? 1 : 0);
    EXPECT_EQ(messages.empty(), frame > 0); // VTK says what the driver says
    EXPECT_TRUE(frame == 0 || pass->GetGeometryPasses() == 1);
    geometryPasses = std::max(geometryPasses, pass->GetGeometryPasses());
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

// The program for the long lists is the one that fails, when that for the short ones is there already.
TEST(ShaderFailures, OfLongListsBlendNothingTwice)
{
  for (const LongLists& lists : { LongLists{ "ListResolve", 40 }, LongLists{ "ListSortRuns", 100 },
         LongLists{ "ListMergeRuns", 100 }, LongLists{ "ListResolveLong", 1100 } })
  {
    for (const bool inBands : { false, true })
    {
      SCOPED_TRACE(std::string(lists.Shader) + (inBands ? ", in bands" : ""));
      LayeredScene scene;
      vtkNew<vtkLinkedListTransparencyPass> pass;
      scene.Use(pass);
      scene.Render();
      EXPECT_STREQ(pass->GetFallbackReason(), "");

      scene.AddLongLists(lists.Layers);
      const Picture byVTK = RenderAsVTK(scene);
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

// The second frame compiles the program for the short lists, beside that for the long ones.
TEST(ShaderFailures, OfShortListsBlendNothingTwice)
{
  LayeredScene scene;
  scene.AddLongLists(100);
  const Picture byVTK = RenderAsVTK(scene);
  vtkNew<vtkLinkedListTransparencyPass> pass;
  ExpectTruth(scene, pass, 0.75);
  const RejectedShader rejected("ListResolve");
  ExpectFallbackOnce(scene, pass, byVTK);
}

TEST(ShaderFailures, OfTheTilesAreSaid)
{
  LayeredScene scene;
  const Picture byVTK = RenderAsVTK(scene);
  vtkNew<vtkLinkedListTransparencyPass> pass;
  scene.Use(pass);
  const RejectedShader rejected("TileClassify");
  ExpectFallbackOnce(scene, pass, byVTK);
}

TEST(ShaderFailures, OfTruthAreSaid)
{
  for (const char* const shader : { "TruthRead", "TruthWrite" })
  {
    SCOPED_TRACE(shader);
    LayeredScene scene;
    const Picture byVTK = RenderAsVTK(scene);
    vtkNew<vtkTruthTransparencyPass> pass;
    scene.Use(pass);
    const RejectedShader rejected(shader);
    ExpectFallbackOnce(scene, pass, byVTK);
  }
}

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
