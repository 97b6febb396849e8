// The report of a device says "works" only where something works, and survives windows without OpenGL.
#include "TestMessages.h"
#include "TestScene.h"
#include "vtkDeviceReport.h"
#include "vtkGenericOpenGLRenderWindow.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sys/wait.h>

namespace
{

std::string ReportOf(int samples)
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(samples);
  return vtkDeviceReport::Describe(window);
}

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST(DeviceReport, NamesMethodsAndLightsThatWork)
{
  const std::string report = ReportOf(0);
  for (const char* const name : { "method linked-list", "method prefix-sum",
         "method prefix-sum-predicted", "method stencil-mask-8", "method stencil-routed",
         "method truth", "lights clustered", "lights deferred" })
  {
    EXPECT_TRUE(Has(report, std::string(name) + ": works\n")) << name << "\n" << report;
  }
  const std::string multisampled = ReportOf(4);
  EXPECT_TRUE(Has(multisampled, "lights deferred: works\n")) << multisampled;
  const std::string choice =
    "method automatic: works, by prefix-sum-predicted with errors of up to ";
  EXPECT_TRUE(Has(report, choice + "0.54/255\n")) << report;
  EXPECT_TRUE(Has(multisampled, choice + "1.04/255\n")) << multisampled;
}

TEST(DISABLED_OnOpenGL33, DeviceReportNamesSubstitutes)
{
  const std::string report = ReportOf(0);
  const std::string lacks = "OpenGL 4.3 is needed, the context has 3.3";
  EXPECT_TRUE(Has(report, "method linked-list: " + lacks + "; stencil-routed draws in its place\n"))
    << report;
  EXPECT_TRUE(Has(report, "method truth: VTK's blending in its place: " + lacks + "\n")) << report;
  TakeMessages(); // The methods say the same.
}

TEST(DISABLED_OnOpenGL33, DeviceReportSaysWhyNothingIsDeferred)
{
  EXPECT_TRUE(Has(ReportOf(0), "lights deferred: works\n")) << ReportOf(0);
  const std::string report = ReportOf(4);
  EXPECT_TRUE(Has(report, "lights clustered: works\n")) << report;
  EXPECT_TRUE(Has(report, "lights deferred: forward in its place: lighting is not deferred: "))
    << report;
  EXPECT_TRUE(Has(report, "4.0")) << report;
}

// Mesa reads its variables before the first context of a process, so the tests are run in another one.
TEST(DeviceReport, SaysWhatOpenGL33Lacks)
{
  const std::string command = "MESA_GL_VERSION_OVERRIDE=3.3 MESA_GLSL_VERSION_OVERRIDE=330 '" +
    testing::internal::GetArgvs()[0] +
    "' --gtest_also_run_disabled_tests --gtest_brief=1 --gtest_filter='DISABLED_OnOpenGL33.*'";
  const int status = std::system(command.c_str());
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

TEST(DeviceReport, NeedsAWindow)
{
  EXPECT_TRUE(Has(vtkDeviceReport::Describe(nullptr), "OpenGL: none without a window\n"));
}

// The context of another window, which is current, is not described in its place.
TEST(DeviceReport, NeedsOpenGL)
{
  TestScene scene;
  scene.Render();
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetReadyForRendering(false);
  window->SetIsCurrent(false);
  const std::string report = vtkDeviceReport::Describe(window);
  EXPECT_TRUE(Has(report, "OpenGL: none in a vtkGenericOpenGLRenderWindow\n")) << report;
  EXPECT_FALSE(Has(report, "lights")) << report;
}

}
