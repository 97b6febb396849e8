#include "Version.h"
#include "commands/Commands.h"
#include "commands/Options.h"
#include "vtkDeviceReport.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"

#include <optional>
#include <string>

namespace program
{

namespace
{

void Report()
{
  vtkHeadlessRenderWindow::InstallOverride();
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  PrintText(
    std::nullopt, std::string("Vitrine: ") + Version + "\n" + vtkDeviceReport::Describe(window));
}
}

void AddReportCommand(CLI::App& app)
{
  app
    .add_subcommand(
      "report", "Tell what OpenGL and VTK are here, and what each method does with them")
    ->callback(Report);
}

}
