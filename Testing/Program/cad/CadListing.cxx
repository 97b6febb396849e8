/**
 * What OpenCASCADE itself says of files, and files that it writes, for tests of vitrine-cad.
 *
 *   CadListing list FILE       prints a line of JSON for each node of the tree of a STEP or IGES file
 *   CadListing write FOLDER    writes box.brep, boxes.iges, in inches, and boxes.step
 */
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>
#include <Bnd_Box.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESControl_Controller.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS_Iterator.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XCAFPrs.hxx>
#include <XCAFPrs_DocumentExplorer.hxx>
#include <XCAFPrs_IndexedDataMapOfShapeStyle.hxx>
#include <nlohmann/json.hpp>

#include <iostream>
#include <set>
#include <string>

namespace
{
Handle(TDocStd_Document) NewDocument()
{
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
  return document;
}

template <class Reader>
bool Read(const std::string& file, const Handle(TDocStd_Document) & document)
{
  Reader reader;
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  Handle(TDocStd_Document) target = document;
  return reader.ReadFile(file.c_str()) == IFSelect_RetDone && reader.Transfer(target);
}

std::string NameOf(const TDF_Label& label)
{
  Handle(TDataStd_Name) name;
  return label.FindAttribute(TDataStd_Name::GetID(), name)
    ? TCollection_AsciiString(name->Get()).ToCString()
    : "";
}

nlohmann::json BoundsOf(const XCAFPrs_DocumentNode& node)
{
  const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(node.RefLabel).Located(node.Location);
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, false, false);
  double b[6];
  box.Get(b[0], b[2], b[4], b[1], b[3], b[5]);
  return { b[0], b[1], b[2], b[3], b[4], b[5] };
}

nlohmann::json ColorOf(const XCAFPrs_Style& style)
{
  if (!style.IsSetColorSurf())
  {
    return nullptr;
  }
  const Quantity_ColorRGBA& color = style.GetColorSurfRGBA();
  return { color.GetRGB().Red(), color.GetRGB().Green(), color.GetRGB().Blue(), color.Alpha() };
}

/** Collects the colours of the faces of a shape, where a shape within another goes before it. */
void CollectColors(const TopoDS_Shape& shape, XCAFPrs_Style style,
  const XCAFPrs_IndexedDataMapOfShapeStyle& styles, std::set<nlohmann::json>& colors)
{
  if (const XCAFPrs_Style* own = styles.Seek(shape))
  {
    style = *own;
  }
  if (shape.ShapeType() == TopAbs_FACE)
  {
    colors.insert(ColorOf(style));
    return;
  }
  for (TopoDS_Iterator within(shape); within.More(); within.Next())
  {
    CollectColors(within.Value(), style, styles, colors);
  }
}

/** The linear colours and opacities of a leaf's faces, each once; null is for those that have none. */
nlohmann::json ColorsOf(const XCAFPrs_DocumentNode& node)
{
  XCAFPrs_IndexedDataMapOfShapeStyle styles;
  XCAFPrs::CollectStyleSettings(node.RefLabel, TopLoc_Location(), styles);
  std::set<nlohmann::json> colors;
  CollectColors(XCAFDoc_ShapeTool::GetShape(node.RefLabel), node.Style, styles, colors);
  return colors;
}

bool List(const std::string& file)
{
  const Handle(TDocStd_Document) document = NewDocument();
  const bool isIges = file.find(".ig") != std::string::npos;
  if (!(isIges ? Read<IGESCAFControl_Reader>(file, document)
               : Read<STEPCAFControl_Reader>(file, document)))
  {
    return false;
  }
  for (XCAFPrs_DocumentExplorer explorer(document, XCAFPrs_DocumentExplorerFlags_None);
       explorer.More(); explorer.Next())
  {
    const XCAFPrs_DocumentNode& node = explorer.Current();
    nlohmann::json line = { { "depth", explorer.CurrentDepth() }, { "leaf", !node.IsAssembly },
      { "instance", NameOf(node.Label) }, { "product", NameOf(node.RefLabel) } };
    if (!node.IsAssembly)
    {
      line["bounds"] = BoundsOf(node); // millimetres
      line["colors"] = ColorsOf(node);
    }
    std::cout << line.dump() << "\n";
  }
  return true;
}

/** A box of 10 x 20 x 30 mm at 1, 2, 3, red, and a half transparent green one of 1 x 1 x 1 mm at the origin. */
Handle(TDocStd_Document) MakeBoxes()
{
  const Handle(TDocStd_Document) document = NewDocument();
  const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const auto colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
  const TDF_Label red =
    shapes->AddShape(BRepPrimAPI_MakeBox(gp_Pnt(1, 2, 3), 10, 20, 30).Shape(), false);
  const TDF_Label green = shapes->AddShape(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), false);
  TDataStd_Name::Set(red, "red box");
  TDataStd_Name::Set(green, "green box");
  colors->SetColor(red, Quantity_ColorRGBA(1.0f, 0.0f, 0.0f, 1.0f), XCAFDoc_ColorSurf);
  colors->SetColor(green, Quantity_ColorRGBA(0.0f, 1.0f, 0.0f, 0.5f), XCAFDoc_ColorSurf);
  return document;
}

bool Write(const std::string& folder)
{
  IGESControl_Controller::Init(); // which knows the setting
  Interface_Static::SetCVal("write.iges.unit", "INCH");
  IGESCAFControl_Writer iges;
  iges.SetColorMode(true);
  iges.SetNameMode(true);
  STEPCAFControl_Writer step;
  step.SetColorMode(true);
  step.SetNameMode(true);
  const Handle(TDocStd_Document) boxes = MakeBoxes();
  return BRepTools::Write(BRepPrimAPI_MakeBox(gp_Pnt(1, 2, 3), 10, 20, 30).Shape(),
           (folder + "/box.brep").c_str()) &&
    iges.Transfer(boxes) && iges.Write((folder + "/boxes.iges").c_str()) &&
    step.Transfer(boxes, STEPControl_AsIs) &&
    step.Write((folder + "/boxes.step").c_str()) == IFSelect_RetDone;
}
}

int main(int argc, char** argv)
{
  Message::DefaultMessenger()->ChangePrinters().Clear();
  const std::string task = argc == 3 ? argv[1] : "";
  const bool isDone = task == "list" ? List(argv[2]) : task == "write" && Write(argv[2]);
  return isDone ? 0 : 1;
}
