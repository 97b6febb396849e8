// Drivers that lack what the methods need: said once, and drawn as VTK does by itself.
//
// Mesa hides features where its environment variables say so, before the first context of a process. So the
// tests run this program again.
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkActor.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkTranslucentPass.h"

#include <gtest/gtest.h>

#include <cstdlib>
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

void AddParts(TestScene& scene)
{
  scene.AddSphere(0.3, 0.1, 0.2, 0.5, { 0.9, 0.5, 0.1, 0.4 });
  scene.AddSphere(-0.2, -0.1, -0.3, 0.7, { 0.1, 0.5, 0.9, 0.6 });
}

// Every method, several frames, on a driver of which VITRINE_TEST_LACKS says what is missing.
TEST(DISABLED_OnALesserDriver, MethodsSaySoOnceAndDrawAsVTKDoes)
{
  const char* lacks = std::getenv("VITRINE_TEST_LACKS");
  ASSERT_NE(lacks, nullptr);
  TestScene scene(40, 30);
  AddParts(scene);
  vtkNew<vtkOrderIndependentTranslucentPass> weighted;
  vtkNew<vtkTranslucentPass> translucent;
  weighted->SetTranslucentPass(translucent);
  scene.Use(weighted);
  const Picture byVTK = scene.Render();
  for (const Method& method : AllMethods())
  {
    SCOPED_TRACE(method.Name);
    const vtkSmartPointer<vtkTransparencyPass> pass = method.Make();
    scene.Use(pass);
    if (method.NeedsOpenGL != "4.3")
    {
      scene.Render();
      EXPECT_STREQ(pass->GetFallbackReason(), "");
      EXPECT_GT(pass->GetFragmentCount(), 0);
      continue;
    }
    for (int frame = 0; frame < 3; ++frame)
    {
      EXPECT_TRUE(scene.Render() == byVTK);
      EXPECT_NE(std::string(pass->GetFallbackReason()).find(lacks), std::string::npos)
        << pass->GetFallbackReason();
      EXPECT_EQ(pass->GetGeometryPasses(), 1);
      EXPECT_EQ(pass->GetNumberOfRenderedProps(), 2);
    }
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find(lacks), std::string::npos) << messages[0];
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
