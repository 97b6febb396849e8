#include "Errors.h"
#include "Progress.h"
#include "scene/files/FileReaders.h"
#include "vtkAssemblyReader.h"
#include "vtkCallbackCommand.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

namespace program
{

namespace
{
/** Shows how far a conversion has got. */
struct ConversionProgress
{
  explicit ConversionProgress(const std::string& path)
    : Path(path)
  {
  }

  std::string Path;
  Progress Line;
};

void ShowProgress(vtkObject* caller, unsigned long, void* data, void*)
{
  auto* const reader = static_cast<vtkAssemblyReader*>(caller);
  auto* const progress = static_cast<ConversionProgress*>(data);
  const char* const task = reader->GetProgressText();
  progress->Line.Show(progress->Path + ": " + (task ? task : "") + ", " +
    std::to_string(static_cast<int>(100.0 * reader->GetProgress())) + " %");
}

Part MakePart(vtkAssemblyReader* reader, int number)
{
  Part part;
  part.Name = reader->GetPartName(number);
  part.Path = reader->GetPartPath(number);
  part.MaterialName = reader->GetPartMaterialName(number);
  part.Geometry = reader->GetPartGeometry(number);
  part.Material = reader->GetPartProperty(number);
  part.Transform = reader->GetPartPlace(number);
  part.Keys = reader->GetPartKeys(number);
  part.ForceTranslucent = reader->GetPartIsTranslucent(number);
  part.MayBeBlock = true;
  return part;
}
}

Scene ReadAssemblyFile(const std::string& path, const ReadingOptions& options)
{
  vtkNew<vtkAssemblyReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetTolerance(options.Tolerance);
  reader->SetUseCache(options.UseCache);
  ConversionProgress progress(path);
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&progress);
  observer->SetCallback(ShowProgress);
  reader->AddObserver(vtkCommand::ProgressEvent, observer);
  if (!reader->Open())
  {
    throw InputError(path, reader->GetErrorMessage());
  }
  Scene scene;
  scene.LengthUnit = reader->GetLengthUnit();
  for (int i = 0; i < reader->GetNumberOfParts(); ++i)
  {
    scene.Parts.push_back(MakePart(reader, i));
  }
  for (int i = 0; i < reader->GetNumberOfNotes(); ++i)
  {
    scene.Notes.push_back(reader->GetNote(i));
  }
  return scene;
}

}
