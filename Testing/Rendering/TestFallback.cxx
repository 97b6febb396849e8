// Drivers that lack what the methods need: said once, and drawn by another exact method, or as VTK does by itself.
//
// Mesa hides features where its environment variables say so, before the first context of a process. So the
// tests run this program again.
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkActor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>
#include <sys/wait.h>

namespace
{

// Run a test of this program under `environment` ("NAME=value ..."). Returns whether it passed.
bool PassesUnder(const std::string& environment, const std::string& test)
{
  const std::string command = environment + " '" + testing::internal::GetArgvs()[0] +
    "' --gtest_also_run_disabled_tests --gtest_brief=1 --gtest_filter='" + test + "'";
  const int status = std::system(command.c_str());
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

Picture RenderBy(TestScene& scene, const std::string& name)
{
  const std::vector<Method> methods = AllMethods();
  const auto method = std::find_if(
    methods.begin(), methods.end(), [&name](const Method& m) { return m.Name == name; });
  EXPECT_NE(method, methods.end());
  scene.Use(method->Make());
  return scene.Render();
}

// Expect the stages of the method that draws in place of this one, or none.
void ExpectStages(TestScene& scene, vtkTransparencyPass* pass, bool some)
{
  scene.Window->WaitForCompletion();
  std::set<std::string> stages;
  for (int stage = 0; stage < pass->GetNumberOfStages(); ++stage)
  {
    stages.insert(pass->GetStageName(stage));
    EXPECT_GT(pass->GetStageTime(stage), 0.0);
  }
  EXPECT_EQ(stages.count("fill"), some ? 1u : 0u);
  EXPECT_EQ(stages.count("resolve"), some ? 1u : 0u);
  pass->MeasureStagesOff();
  EXPECT_EQ(pass->GetNumberOfStages(), 0);
}

// Every method, several frames, on a driver of which VITRINE_TEST_LACKS says what is missing. Stencil routing draws in
// place of lists, and VTK by itself in place of truth.
TEST(DISABLED_OnALesserDriver, MethodsSaySoOnceAndAreReplaced)
{
  const char* lacks = std::getenv("VITRINE_TEST_LACKS");
  ASSERT_NE(lacks, nullptr);
  TestScene scene(40, 30);
  scene.AddParts();
  const Picture byVTK = scene.RenderAsVTK();
  const Picture routed = RenderBy(scene, "StencilRoutedHalfFloat");
  ASSERT_FALSE(Matches(routed, byVTK));
  for (const Method& method : AllMethods())
  {
    SCOPED_TRACE(method.Name);
    const vtkSmartPointer<vtkTransparencyPass> pass = method.Make();
    scene.Use(pass);
    pass->MeasureStagesOn();
    if (method.NeedsOpenGL != "4.3")
    {
      scene.Render();
      EXPECT_STREQ(pass->GetFallbackReason(), "");
      EXPECT_GT(pass->GetNumberOfFragments(), 0);
      EXPECT_EQ(pass->GetActiveSubstitute(), "");
      continue;
    }
    const bool isTruth = method.Name == "Truth";
    for (int frame = 0; frame < 3; ++frame)
    {
      EXPECT_TRUE(Matches(scene.Render(), isTruth ? byVTK : routed));
      EXPECT_EQ(pass->GetNumberOfRenderedProps(), 2);
      EXPECT_EQ(pass->GetNumberOfLostFragments(), 0);
      EXPECT_EQ(pass->GetNumberOfFragments() > 0, !isTruth);
    }
    ExpectRefusal(pass, lacks);
    const std::string reason = pass->GetFallbackReason();
    EXPECT_EQ(reason.find("; stencil-routed draws in its place") != std::string::npos, !isTruth)
      << reason;
    EXPECT_EQ(pass->GetActiveSubstitute(), isTruth ? "" : "stencil-routed");
    ExpectStages(scene, pass, !isTruth);
  }
}

TEST(Fallback, WithOpenGL32)
{
  EXPECT_TRUE(PassesUnder("MESA_GL_VERSION_OVERRIDE=3.2 MESA_GLSL_VERSION_OVERRIDE=150 "
                          "MESA_EXTENSION_OVERRIDE='-GL_ARB_texture_storage "
                          "-GL_ARB_shader_image_load_store -GL_ARB_gpu_shader5 "
                          "-GL_ARB_explicit_attrib_location -GL_ARB_shader_bit_encoding' "
                          "VITRINE_TEST_LACKS='OpenGL 4.3'",
    "DISABLED_OnALesserDriver.*"));
}

TEST(Fallback, WithOpenGL33)
{
  EXPECT_TRUE(PassesUnder(
    "MESA_GL_VERSION_OVERRIDE=3.3 VITRINE_TEST_LACKS='OpenGL 4.3'", "DISABLED_OnALesserDriver.*"));
}

TEST(Fallback, WithoutStorageBuffers)
{
  EXPECT_TRUE(PassesUnder("MESA_GL_VERSION_OVERRIDE=4.5 "
                          "MESA_EXTENSION_OVERRIDE=-GL_ARB_shader_storage_buffer_object "
                          "VITRINE_TEST_LACKS=GL_ARB_shader_storage_buffer_object",
    "DISABLED_OnALesserDriver.*"));
}

}
