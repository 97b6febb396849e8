// Tests drivers that announce an extension and do not compile a shader that requires it.
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestRefusedTexts.h"
#include "TestScene.h"
#include "gl/DeviceTraits.h"
#include "vtkTransparencyPass.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace
{

// The GLSL 1.50 text of all methods that store fragments in buffers.
const char* const StorageExtension = "GL_ARB_shader_storage_buffer_object";
// Other text that all fills of such methods have, in every version.
const char* const Storage = "vitrineCoverage";

std::vector<Method> StoringMethods()
{
  std::vector<Method> methods;
  for (const Method& method : AllMethods())
  {
    if (method.NeedsOpenGL == "4.3")
    {
      methods.push_back(method);
    }
  }
  return methods;
}

Picture DrawFirst(const Method& method, int samples)
{
  TestScene scene(40, 30, samples);
  scene.AddParts();
  scene.Use(method.Make());
  return scene.Render();
}

/**
 * Draws a scene by all storing methods as a driver that refuses `texts`, into a target of `samples` samples a pixel.
 * Expects the pictures of `draw`, no messages, and shaders of `variant` where any were refused. Returns the number of
 * methods of which some were.
 */
std::size_t ExpectExactWithout(const std::vector<std::string>& texts, const std::string& variant,
  int samples = 0, Picture (*draw)(const Method&, int) = DrawFirst)
{
  std::size_t refusals = 0;
  for (const Method& method : StoringMethods())
  {
    SCOPED_TRACE(method.Name);
    const Picture expected = draw(method, samples);
    TestScene scene(40, 30, samples);
    scene.AddParts();
    scene.RenderAsVTK(); // A new context loads the entry points anew.
    const RefusedTexts refused(texts);
    const vtkSmartPointer<vtkTransparencyPass> pass = method.Make();
    scene.Use(pass);
    for (int frame = 0; frame < 3; ++frame)
    {
      EXPECT_TRUE(Matches(scene.Render(), expected));
      EXPECT_STREQ(pass->GetFallbackReason(), "");
      EXPECT_GT(pass->GetNumberOfFragments(), 0);
    }
    const std::string told = pass->GetRefusedShaders();
    if (!told.empty())
    {
      ++refusals;
      EXPECT_NE(told.find("refused by the test"), std::string::npos) << told;
      EXPECT_EQ(pass->GetShaderVariant(), variant);
    }
  }
  return refusals;
}

vitrine::DeviceTraits TraitsOfDevice()
{
  TestScene scene(4, 4);
  scene.Render();
  return vitrine::FindDeviceTraits();
}

TEST(RefusedShaders, OfFramebufferFetchGiveWayToAtomics)
{
  if (!TraitsOfDevice().FramebufferFetch)
  {
    GTEST_SKIP() << "the driver has no framebuffer fetch";
  }
  EXPECT_GE(ExpectExactWithout({ vitrine::FramebufferFetchExtension }, "GLSL 1.50"), 2u);
}

// The picture is that of a device without the extension, where the shader compares depths itself.
TEST(RefusedShaders, OfPostDepthCoverageGiveWayToTheirOwnTest)
{
  if (!TraitsOfDevice().PostDepthCoverage)
  {
    GTEST_SKIP() << "the driver has no post-depth coverage";
  }
  const auto draw = [](const Method& method, int samples)
  {
    setenv("VITRINE_DEVICE", "no-post-depth-coverage", 1);
    const Picture picture = DrawFirst(method, samples);
    unsetenv("VITRINE_DEVICE");
    return picture;
  };
  EXPECT_EQ(ExpectExactWithout({ vitrine::PostDepthCoverageExtension }, "GLSL 1.50", 4, draw),
    StoringMethods().size());
}

TEST(RefusedShaders, OfVersion150GiveWayToVersion430)
{
  EXPECT_EQ(ExpectExactWithout({ StorageExtension }, "GLSL 4.30"), StoringMethods().size());
  const bool covers = TraitsOfDevice().PostDepthCoverage;
  const std::string withSamples =
    std::string("GLSL 4.30") + (covers ? ", GL_ARB_post_depth_coverage" : "");
  EXPECT_EQ(ExpectExactWithout({ StorageExtension }, withSamples, 4), StoringMethods().size());
}

// A window where the driver refuses nothing has the first variant again.
TEST(RefusedShaders, AreThoseOfOneWindow)
{
  const vtkSmartPointer<vtkTransparencyPass> pass = StoringMethods().front().Make();
  std::string first;
  {
    TestScene scene(40, 30);
    scene.AddParts();
    scene.Use(pass);
    EXPECT_EQ(pass->GetShaderVariant(), "");
    scene.Render();
    first = pass->GetShaderVariant();
    EXPECT_EQ(first.find("GLSL 1.50"), 0u) << first;
    EXPECT_EQ(pass->GetRefusedShaders(), "");
  }
  {
    TestScene scene(40, 30);
    scene.AddParts();
    scene.RenderAsVTK();
    const RefusedTexts refused({ StorageExtension });
    scene.Use(pass);
    scene.Render();
    EXPECT_EQ(pass->GetShaderVariant(), "GLSL 4.30");
  }
  TestScene scene(40, 30);
  scene.AddParts();
  scene.Use(pass);
  scene.Render();
  EXPECT_EQ(pass->GetShaderVariant(), first);
  EXPECT_EQ(pass->GetRefusedShaders(), "");
}

// GLSL has no continued lines before 4.20.
TEST(RefusedShaders, HaveNoContinuedLines)
{
  for (const Method& method : AllMethods())
  {
    SCOPED_TRACE(method.Name);
    TestScene scene(40, 30);
    scene.AddParts();
    scene.RenderAsVTK();
    const RefusedTexts refused({ "\\\n" });
    const vtkSmartPointer<vtkTransparencyPass> pass = method.Make();
    scene.Use(pass);
    scene.Render();
    EXPECT_STREQ(pass->GetFallbackReason(), "");
    EXPECT_EQ(pass->GetRefusedShaders(), "");
  }
}

TEST(RefusedShaders, AllOfThemAreSaidOnceAndDrawnAsVTKDoes)
{
  for (const Method& method : StoringMethods())
  {
    SCOPED_TRACE(method.Name);
    TestScene scene(40, 30);
    scene.AddParts();
    const Picture byVTK = scene.RenderAsVTK();
    const RefusedTexts refused({ Storage });
    const vtkSmartPointer<vtkTransparencyPass> pass = method.Make();
    scene.Use(pass);
    for (int frame = 0; frame < 3; ++frame)
    {
      EXPECT_TRUE(Matches(scene.Render(), byVTK));
    }
    EXPECT_EQ(pass->GetShaderVariant(), "");
    ExpectRefusal(pass, "the driver cannot compile a shader of the method: ");
    EXPECT_NE(
      std::string(pass->GetFallbackReason()).find("refused by the test"), std::string::npos);
  }
}

}
