#include "CadFile.h"

#include "Errors.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_InterfaceModel.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <set>
#include <utility>
#include <vector>

namespace cad
{

namespace
{
const double EndOfReading = 0.5; // of the whole conversion
const double EndOfTransfer = 0.7;

std::string LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/** Returns at most `size` bytes from the begin or the end of a file. */
std::string SomeBytes(const std::filesystem::path& file, std::streamoff size, bool ofEnd)
{
  std::ifstream in(file, std::ios::binary);
  in.seekg(0, std::ios::end);
  const std::streamoff length = in.tellg();
  if (!in)
  {
    throw CadError("cannot be read");
  }
  std::string bytes(static_cast<std::size_t>(std::min(size, length)), '\0');
  in.seekg(ofEnd ? length - static_cast<std::streamoff>(bytes.size()) : 0);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

/** OpenCASCADE reads as far as it gets, and says nothing about the rest. */
void CheckWhole(const std::filesystem::path& file, const std::string& begin, const std::string& end)
{
  const std::streamoff near = 4096; // bytes for comments before the begin and after the end
  if (SomeBytes(file, near, false).find(begin) == std::string::npos)
  {
    throw CadError("is not STEP: it does not begin with " + begin);
  }
  if (SomeBytes(file, near, true).find(end) == std::string::npos)
  {
    throw CadError("is cut off: " + end + " is missing at its end");
  }
}

/** OpenCASCADE goes on after an error of grammar. Throws CadError if there was one. */
void CheckGrammar(const Handle(XSControl_WorkSession) & session)
{
  const auto check = session->Model()->GlobalCheck(true);
  for (int i = 1; i <= check->NbFails(); ++i)
  {
    const std::string problem = check->CFail(i, true);
    const std::size_t line = problem.find("Line ");
    if (line != std::string::npos)
    {
      throw CadError("is damaged: l" + problem.substr(line + 1));
    }
  }
}

/** Returns what of a file could not be made into shapes, or an empty text. */
std::string DescribeLosses(const Handle(XSControl_WorkSession) & session)
{
  Interface_CheckIterator checks = session->TransferReader()->LastCheckList();
  int count = session->Model()->GlobalCheck(true)->NbFails(); // references that lead nowhere
  for (checks.Start(); checks.More(); checks.Next())
  {
    count += checks.Value()->HasFailed();
  }
  return count == 0
    ? std::string()
    : "is shown in part: OpenCASCADE could not read " + std::to_string(count) + " of its entities";
}

Handle(TDocStd_Document) NewDocument()
{
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
  XCAFDoc_ShapeTool::SetAutoNaming(false); // "SOLID" is no name
  return document;
}

/** Joins the units of a file, of which a file nearly always has one. */
std::string JoinUnits(const TColStd_SequenceOfAsciiString& names)
{
  std::set<std::string> units;
  for (const TCollection_AsciiString& name : names)
  {
    units.insert(LowerCase(name.ToCString()));
  }
  std::string joined;
  for (const std::string& unit : units)
  {
    joined += (joined.empty() ? "" : " and ") + unit;
  }
  return joined;
}

CadFile ReadStep(const std::filesystem::path& file, ProgressLines& progress)
{
  CheckWhole(file, "ISO-10303-21", "END-ISO-10303-21");
  STEPCAFControl_Reader reader;
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  reader.SetLayerMode(true);
  reader.SetMatMode(true);
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone)
  {
    throw CadError("is damaged: it is not what STEP's grammar says");
  }
  CheckGrammar(reader.Reader().WS());
  CadFile read{ NewDocument(), {}, {} };
  if (!reader.Transfer(read.Document, progress.Begin("reading shapes", EndOfTransfer)))
  {
    throw CadError("has no shapes that OpenCASCADE can read");
  }
  TColStd_SequenceOfAsciiString lengths;
  TColStd_SequenceOfAsciiString angles;
  TColStd_SequenceOfAsciiString solidAngles;
  reader.ChangeReader().FileUnits(lengths, angles, solidAngles);
  read.LengthUnit = JoinUnits(lengths);
  read.Note = DescribeLosses(reader.Reader().WS());
  return read;
}

/** The names of IGES's units (IGES 5.3, table 4). */
std::string NameOfIgesUnit(const std::string& name)
{
  static const std::vector<std::pair<std::string, std::string>> names = { { "IN", "inch" },
    { "INCH", "inch" }, { "MM", "millimetre" }, { "FT", "foot" }, { "MI", "mile" },
    { "M", "metre" }, { "KM", "kilometre" }, { "MIL", "mil" }, { "UM", "micron" },
    { "CM", "centimetre" }, { "UIN", "microinch" } };
  for (const auto& [shortName, longName] : names)
  {
    if (name == shortName)
    {
      return longName;
    }
  }
  return LowerCase(name);
}

CadFile ReadIges(const std::filesystem::path& file, ProgressLines& progress)
{
  IGESCAFControl_Reader reader;
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  reader.SetLayerMode(true);
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone)
  {
    throw CadError("is damaged: it is not what IGES says");
  }
  CadFile read{ NewDocument(), {}, {} };
  if (!reader.Transfer(read.Document, progress.Begin("reading shapes", EndOfTransfer)))
  {
    throw CadError("has no shapes that OpenCASCADE can read");
  }
  const auto name = reader.IGESModel()->GlobalSection().UnitName();
  read.LengthUnit = name.IsNull() ? "" : NameOfIgesUnit(name->ToCString());
  read.Note = DescribeLosses(reader.WS());
  return read;
}

CadFile ReadBrep(const std::filesystem::path& file, ProgressLines& progress)
{
  TopoDS_Shape shape;
  if (!BRepTools::Read(
        shape, file.c_str(), BRep_Builder(), progress.Begin("reading shapes", EndOfTransfer)) ||
    shape.IsNull())
  {
    throw CadError("is damaged, or is not a BREP of OpenCASCADE");
  }
  CadFile read{ NewDocument(), "millimetre", {} }; // as OpenCASCADE means a BREP, which has no unit
  const auto shapes = XCAFDoc_DocumentTool::ShapeTool(read.Document->Main());
  shapes->AddShape(shape, shape.ShapeType() == TopAbs_COMPOUND);
  return read;
}
}

CadFile ReadCadFile(const std::filesystem::path& file, ProgressLines& progress)
{
  const std::string extension = LowerCase(file.extension().string());
  progress.Begin("reading the file", EndOfReading);
  if (extension == ".step" || extension == ".stp")
  {
    return ReadStep(file, progress);
  }
  if (extension == ".iges" || extension == ".igs")
  {
    return ReadIges(file, progress);
  }
  if (extension == ".brep")
  {
    return ReadBrep(file, progress);
  }
  throw CadError("is not of a kind that is converted: .step, .stp, .iges, .igs, .brep");
}

}
