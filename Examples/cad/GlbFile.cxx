#include "GlbFile.h"

#include "Errors.h"

#include <RWGltf_CafWriter.hxx>
#include <TDataStd_Name.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XCAFDoc_VisMaterial.hxx>

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <system_error>

namespace cad
{

namespace
{
std::string NameOf(const TDF_Label& label)
{
  Handle(TDataStd_Name) name;
  if (label.IsNull() || !label.FindAttribute(TDataStd_Name::GetID(), name))
  {
    return {};
  }
  std::string text = TCollection_AsciiString(name->Get()).ToCString();
  const auto isSpace = [](unsigned char c) { return std::isspace(c) != 0; };
  text.erase(text.begin(), std::find_if_not(text.begin(), text.end(), isSpace));
  text.erase(std::find_if_not(text.rbegin(), text.rend(), isSpace).base(), text.end());
  return text;
}

/** Whether a name is a number that a program gave: "NAUO12", "12" or OpenCASCADE's "=>[0:1:1:2]". */
bool IsNumbered(const std::string& name)
{
  const std::size_t begin = name.rfind("NAUO", 0) == 0 ? 4 : 0;
  return name.rfind("=>[", 0) == 0 ||
    std::all_of(name.begin() + static_cast<std::ptrdiff_t>(begin), name.end(),
      [](unsigned char c) { return std::isdigit(c) != 0; });
}

/** How surfaces look that have a colour and no material: glTF's own default is bare metal. */
XCAFPrs_Style PlainStyle()
{
  XCAFDoc_VisMaterialPBR look;
  look.IsDefined = true;
  look.Metallic = 0.0f;
  look.Roughness = 0.5f;
  const Handle(XCAFDoc_VisMaterial) material = new XCAFDoc_VisMaterial();
  material->SetPbrMaterial(look);
  XCAFPrs_Style style;
  style.SetMaterial(material);
  return style;
}

/** Gives the roots a colour, which those of their shapes have that have none of their own. */
void ColorRoots(const Handle(TDocStd_Document) & document)
{
  const auto colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
  TDF_LabelSequence roots;
  XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetFreeShapes(roots);
  for (const TDF_Label& root : roots)
  {
    if (!colors->IsSet(root, XCAFDoc_ColorSurf) && !colors->IsSet(root, XCAFDoc_ColorGen))
    {
      colors->SetColor(root, Quantity_Color(0.8, 0.8, 0.8, Quantity_TOC_sRGB), XCAFDoc_ColorGen);
    }
  }
}

class NamingWriter : public RWGltf_CafWriter
{
public:
  NamingWriter(const std::filesystem::path& output, const std::string& unnamed)
    : RWGltf_CafWriter(output.c_str(), true)
    , Unnamed(unnamed)
  {
    this->SetNodeNameFormat(RWMesh_NameFormat_InstanceOrProduct);
    this->SetMeshNameFormat(RWMesh_NameFormat_Product);
    this->SetMergeFaces(true);
    this->SetDefaultStyle(PlainStyle());
    this->ChangeCoordinateSystemConverter().SetInputLengthUnit(METERS_OF_DOCUMENT);
    this->ChangeCoordinateSystemConverter().SetInputCoordinateSystem(RWMesh_CoordinateSystem_Zup);
  }

protected:
  TCollection_AsciiString formatName(
    RWMesh_NameFormat format, const TDF_Label& label, const TDF_Label& refLabel) const override
  {
    const std::string instance = NameOf(label);
    const std::string product = NameOf(refLabel);
    const bool isInstanceTold =
      format == RWMesh_NameFormat_InstanceOrProduct && !IsNumbered(instance);
    std::string name = isInstanceTold || IsNumbered(product) ? instance : product;
    if (IsNumbered(name))
    {
      name = !product.empty() ? product : !instance.empty() ? instance : this->Unnamed;
    }
    return name.c_str();
  }

private:
  std::string Unnamed;
};
}

void WriteGlb(const CadFile& file, const std::filesystem::path& output, const std::string& unnamed,
  const GlbExtras& extras, ProgressLines& progress)
{
  std::filesystem::path unfinished = output;
  unfinished += ".part" + std::to_string(getpid()) + ".glb";
  TColStd_IndexedDataMapOfStringString told;
  for (const auto& [name, value] : extras)
  {
    told.Add(name.c_str(), value.c_str());
  }
  ColorRoots(file.Document);
  std::error_code problem;
  const Handle(NamingWriter) writer = new NamingWriter(unfinished, unnamed);
  if (writer->Perform(file.Document, told, progress.Begin("writing GLB", 1.0)))
  {
    std::filesystem::rename(unfinished, output, problem);
    if (!problem)
    {
      return;
    }
  }
  std::filesystem::remove(unfinished, problem);
  std::filesystem::remove(unfinished.string() + ".bin.tmp", problem);
  throw CadError("cannot be written");
}

}
