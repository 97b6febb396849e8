#include "scene/files/FileReaders.h"

#include "scene/files/FileBytes.h"
#include "scene/files/PlyCheck.h"

#include "vtkNew.h"
#include "vtkPLYReader.h"

namespace program
{

Scene ReadPlyFile(const std::string& path)
{
  CheckPly(path, ReadBytes(path));
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return MakeSinglePartScene(path, reader->GetOutput());
}

}
