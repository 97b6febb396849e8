/**
 * vitrine-cad: converts STEP, IGES and BREP to GLB. vtkAssemblyReader runs it.
 */
#include "CadFile.h"
#include "CadMesh.h"
#include "Errors.h"
#include "GlbFile.h"

#include <CLI/CLI.hpp>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Version.hxx>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <new>
#include <sstream>

namespace
{
const int CANNOT_BE_DONE = 2;
const char* const Version =
  "vitrine-cad " VITRINE_CAD_VERSION ", OpenCASCADE " OCC_VERSION_COMPLETE;

struct Options
{
  std::string Input;
  std::string Output;
  cad::MeshLimits Limits;
  bool ShowProgress = false;
};

std::string ToText(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

void Convert(const Options& options)
{
  // OpenCASCADE prints on stdout, by its printers and otherwise.
  Message::DefaultMessenger()->ChangePrinters().Clear();
  if (!std::freopen("/dev/null", "w", stdout))
  {
    std::fclose(stdout);
  }
  const Handle(cad::ProgressLines) progress = new cad::ProgressLines(options.ShowProgress);
  const std::filesystem::path input(options.Input);
  if (!std::filesystem::is_regular_file(input))
  {
    throw cad::CadError("there is no such file");
  }
  const cad::CadFile file = cad::ReadCadFile(input, *progress);
  const double tolerance = cad::MeshShapes(file, options.Limits, *progress);
  cad::GlbExtras extras = { { "tolerance", ToText(tolerance) },
    { "angle", ToText(options.Limits.Angle) }, { "converter", Version } };
  if (!file.LengthUnit.empty())
  {
    extras.emplace_back("lengthUnit", file.LengthUnit);
  }
  if (!file.Note.empty())
  {
    extras.emplace_back("note", file.Note);
  }
  cad::WriteGlb(file, options.Output, input.stem().string(), extras, *progress);
}

/** Returns why a conversion failed, or an empty text. */
std::string TryToConvert(const Options& options)
{
  try
  {
    Convert(options);
    return {};
  }
  catch (const std::bad_alloc&)
  {
    return "is damaged, or needs more memory than there is";
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  catch (const Standard_Failure& failure)
  {
    return std::string("is damaged: OpenCASCADE fails with ") + failure.DynamicType()->Name();
  }
}
}

int main(int argc, char** argv)
{
  CLI::App app("Convert STEP, IGES or BREP to GLB, in metres, Y upwards.", "vitrine-cad");
  Options options;
  app.add_option("INPUT", options.Input, ".step, .stp, .iges, .igs or .brep")->required();
  app.add_option("OUTPUT", options.Output, ".glb")->required();
  app
    .add_option("--tolerance", options.Limits.Tolerance,
      "metres that triangles may be from the shapes; 0 for a thousandth of the diagonal of all")
    ->check(CLI::Range(0.0, 1e6))
    ->capture_default_str();
  app.add_option("--angle", options.Limits.Angle, "radians between neighbouring normals")
    ->check(CLI::Range(0.01, 1.5))
    ->capture_default_str();
  app.add_flag("--progress", options.ShowProgress, "print lines of progress on stderr");
  app.set_version_flag("--version", Version);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::Success& asked)
  {
    return app.exit(asked);
  }
  catch (const CLI::ParseError& error)
  {
    std::cerr << "vitrine-cad: " << error.what() << "\n";
    return CANNOT_BE_DONE;
  }
  const std::string problem = TryToConvert(options);
  if (!problem.empty())
  {
    std::cerr << "vitrine-cad: " << options.Input << ": " << problem << "\n";
    return CANNOT_BE_DONE;
  }
  return 0;
}
