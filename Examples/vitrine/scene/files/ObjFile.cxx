#include "scene/files/FileReaders.h"

#include "Errors.h"
#include "VTKMessages.h"
#include "scene/files/FileBytes.h"
#include "scene/files/ImageCheck.h"
#include "scene/files/ObjCheck.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCleanPolyData.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkOBJImporter.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <filesystem>
#include <set>

namespace program
{

namespace
{
namespace fs = std::filesystem;

/** The material library to read: the one that the file names, or the one that is called like it. */
std::string FindMaterials(const std::string& path, const ObjContents& contents)
{
  const fs::path folder = fs::path(path).parent_path();
  for (const fs::path& candidate :
    { folder / contents.MaterialLibrary, fs::path(path).replace_extension(".mtl") })
  {
    std::error_code error;
    if (fs::is_regular_file(candidate, error))
    {
      return candidate.string();
    }
  }
  return "";
}

void CheckMaterials(const std::string& materials)
{
  for (const std::string& name : CheckMtl(materials, ReadBytes(materials)))
  {
    const fs::path texture = fs::path(materials).parent_path() / name;
    std::error_code error;
    if (fs::is_regular_file(texture, error)) // VTK tells of those that are not there
    {
      CheckImage(texture.string(), "it", ReadBytes(texture.string()));
    }
  }
}

/** VTK's parts share the points of the whole file; a part of its own has those that it uses. */
vtkSmartPointer<vtkPolyData> TakeUsedPoints(vtkPolyData* geometry)
{
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(geometry);
  clean->PointMergingOff();
  clean->ConvertLinesToPointsOff();
  clean->ConvertPolysToLinesOff();
  clean->ConvertStripsToPolysOff();
  clean->Update();
  return clean->GetOutput();
}

/** VTK makes a part of what stands before the first `usemtl`, then one for each. */
std::string PartName(const std::string& path, const ObjContents& contents, std::size_t index)
{
  return index == 0 ? fs::path(path).stem().string() : contents.PartNames[index - 1];
}

Part MakePart(vtkActor* actor, const std::string& name)
{
  Part part;
  part.Name = name;
  part.Geometry = TakeUsedPoints(vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput()));
  if (!actor->GetMapper()->GetScalarVisibility())
  {
    part.Geometry->GetPointData()->SetActiveScalars(nullptr); // the material's colour goes first
  }
  part.Material = actor->GetProperty();
  part.Texture = actor->GetTexture();
  return part;
}

/**
 * A material that is not there is drawn in VTK's default; anything else that VTK complains of is
 * an error.
 */
void TakeMessages(const std::string& path, const MessageCapture& messages, Scene& scene)
{
  std::set<std::string> missing;
  for (const std::string& error : messages.Errors())
  {
    if (error.find("appears in OBJ but not MTL file") == std::string::npos)
    {
      throw InputError(path, "cannot be read: " + error);
    }
    missing.insert(error);
  }
  scene.Notes.insert(scene.Notes.end(), missing.begin(), missing.end());
  scene.Notes.insert(scene.Notes.end(), messages.Warnings().begin(), messages.Warnings().end());
}
}

Scene ReadObjFile(const std::string& path)
{
  const ObjContents contents = CheckObj(path, ReadBytes(path));
  const std::string materials = FindMaterials(path, contents);
  const MessageCapture messages;
  vtkNew<vtkOBJImporter> importer;
  importer->SetFileName(path.c_str());
  if (!materials.empty())
  {
    CheckMaterials(materials);
    importer->SetFileNameMTL(materials.c_str());
    importer->SetTexturePath(fs::path(materials).parent_path().c_str());
  }
  vtkNew<vtkRenderWindow> window; // the importer wants one; it is never drawn
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  importer->SetRenderWindow(window);
  importer->Update();

  Scene scene;
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal();
  for (std::size_t i = 0; vtkActor* actor = actors->GetNextActor(); ++i)
  {
    const bool isEmptyBeginning = i == 0 && !contents.PartNames.empty() &&
      vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput())->GetNumberOfCells() == 0;
    if (!isEmptyBeginning)
    {
      scene.Parts.push_back(MakePart(actor, PartName(path, contents, i)));
    }
  }
  TakeMessages(path, messages, scene);
  return scene;
}

}
