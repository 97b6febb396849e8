// Every test runs headless and fails if VTK or OpenGL complain unexpectedly.
#include "TestMessages.h"
#include "vtkHeadlessRenderWindow.h"

#include <gtest/gtest.h>

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  vtkHeadlessRenderWindow::InstallOverride();
  InstallMessageChecks();
  return RUN_ALL_TESTS();
}
