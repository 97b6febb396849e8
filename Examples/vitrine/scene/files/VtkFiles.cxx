/**
 * VTK's own files, which ParaView saves: .vtp, .vtu, .vtm, .vtpd, .vtpc, .vtk and .vtkhdf.
 */
#include "scene/files/FileReaders.h"

#include "Errors.h"
#include "VTKMessages.h"
#include "scene/files/DataParts.h"

#include "vtkGenericDataObjectReader.h"
#include "vtkNew.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLMultiBlockDataReader.h"
#include "vtkXMLPartitionedDataSetCollectionReader.h"
#include "vtkXMLPartitionedDataSetReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtkXMLUtilities.h"
#ifdef VITRINE_HAS_VTKHDF
#include "vtkHDFReader.h"
#endif

#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace program
{

namespace
{
const int MostBlocks = 1000000; // of a level; VTK's reader makes room for as many as the file says

/** VTK's readers follow these without looking: indices of blocks, and data that stand in a collection itself. */
void CheckBlocks(const std::string& path, vtkXMLDataElement* element)
{
  int index = 0;
  if (element->GetScalarAttribute("index", index) && (index < 0 || index >= MostBlocks))
  {
    throw InputError(path, "is damaged: a block has index " + std::to_string(index));
  }
  const bool isCollection = std::strcmp(element->GetName(), "vtkPartitionedDataSetCollection") == 0;
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* const nested = element->GetNestedElement(i);
    if (isCollection && std::strcmp(nested->GetName(), "DataSet") == 0)
    {
      throw InputError(path, "is damaged: a collection has data outside of its partitions");
    }
    CheckBlocks(path, nested);
  }
}

#ifdef VITRINE_HAS_VTKHDF
/** HDF5 prints whatever fails. While this lives, what is printed by C's streams on stderr is lost. */
class QuietErrors
{
public:
  QuietErrors()
    : Former(stderr)
    , Nowhere(std::fopen("/dev/null", "w"))
  {
    stderr = this->Nowhere ? this->Nowhere : this->Former;
  }
  ~QuietErrors()
  {
    stderr = this->Former;
    if (this->Nowhere)
    {
      std::fclose(this->Nowhere);
    }
  }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

private:
  std::FILE* Former;
  std::FILE* Nowhere;
};
#endif

template <class Reader>
Scene ReadData(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return MakeDataScene(path, reader->GetOutputDataObject(0));
}

/** VTK's reader of blocks crashes where they are of another type than its own. */
template <class Reader>
Scene ReadBlocks(const std::string& path, const std::string& type)
{
  vtkSmartPointer<vtkXMLDataElement> root;
  root.TakeReference(vtkXMLUtilities::ReadElementFromFile(path.c_str()));
  if (!root)
  {
    throw InputError(path, "is no XML file of VTK, or damaged");
  }
  const char* const stated = root->GetAttribute("type");
  if (!stated || type != stated)
  {
    throw InputError(path, "holds no " + type + ", as the name of the file says");
  }
  CheckBlocks(path, root);
  return ReadData<Reader>(path);
}
}

Scene ReadPolyDataFile(const std::string& path)
{
  return ReadData<vtkXMLPolyDataReader>(path);
}

Scene ReadUnstructuredGridFile(const std::string& path)
{
  return ReadData<vtkXMLUnstructuredGridReader>(path);
}

Scene ReadMultiBlockFile(const std::string& path)
{
  return ReadBlocks<vtkXMLMultiBlockDataReader>(path, "vtkMultiBlockDataSet");
}

Scene ReadPartitionedFile(const std::string& path)
{
  return ReadBlocks<vtkXMLPartitionedDataSetReader>(path, "vtkPartitionedDataSet");
}

Scene ReadCollectionFile(const std::string& path)
{
  return ReadBlocks<vtkXMLPartitionedDataSetCollectionReader>(
    path, "vtkPartitionedDataSetCollection");
}

Scene ReadLegacyFile(const std::string& path)
{
  const MessageCapture messages;
  Scene scene = ReadData<vtkGenericDataObjectReader>(path);
  // VTK warns of numbers that it cannot read, and goes on.
  std::vector<std::string> problems = messages.Errors();
  problems.insert(problems.end(), messages.Warnings().begin(), messages.Warnings().end());
  if (!problems.empty())
  {
    throw InputError(path, "cannot be read: " + problems.front());
  }
  return scene;
}

Scene ReadHdfFile(const std::string& path)
{
#ifdef VITRINE_HAS_VTKHDF
  const QuietErrors quiet;
  vtkNew<vtkHDFReader> reader;
  if (!reader->CanReadFile(path.c_str()))
  {
    throw InputError(
      path, "is no VTKHDF file, is damaged, or is of a kind that this VTK does not read");
  }
  return ReadData<vtkHDFReader>(path);
#else
  throw InputError(
    path, "cannot be read: this program was built without VTK's reader of VTKHDF files");
#endif
}

}
