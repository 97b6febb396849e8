#include "vtkAssemblyReader.h"

#include "Core/assembly/gltf/GltfReader.h"
#include "Core/threads/ForEachInThreads.h"
#include "assembly/AssemblyContent.h"
#include "assembly/CadConversion.h"
#include "assembly/FoundParts.h"
#include "assembly/PlacedGeometry.h"

#include "vtkDataAssembly.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"

#include <algorithm>
#include <cstdint>
#include <map>

vtkStandardNewMacro(vtkAssemblyReader);

namespace
{
/** Names of vtkDataAssembly are those of XML. */
std::string XMLName(const std::string& name)
{
  const std::string valid = vtkDataAssembly::MakeValidNodeName(name.c_str());
  return valid.empty() ? "node" : valid;
}

/** Adds the nodes of a tree, and each part to its node. */
class AssemblyTree
{
public:
  AssemblyTree(const vitrine::Assembly& source, vtkDataAssembly* tree)
    : Source(source)
    , Tree(tree)
    , Numbers(source.Nodes.size(), 0)
  {
  }

  void AddNodes()
  {
    std::vector<std::pair<int, int>> open; // a node, and its parent in the tree
    const std::vector<int>& roots = this->Source.Roots;
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
    {
      open.emplace_back(*root, vtkDataAssembly::GetRootNode());
    }
    while (!open.empty())
    {
      const auto [number, parent] = open.back();
      open.pop_back();
      const vitrine::AssemblyNode& node = this->Source.Nodes[static_cast<std::size_t>(number)];
      const std::string name = NodeName(this->Source, number);
      const int added = this->Tree->AddNode(XMLName(name).c_str(), parent);
      this->Tree->SetAttribute(added, "label", name.c_str());
      this->Numbers[static_cast<std::size_t>(number)] = added;
      for (auto child = node.Children.rbegin(); child != node.Children.rend(); ++child)
      {
        open.emplace_back(*child, added);
      }
    }
  }

  void AddPart(int node, unsigned int part)
  {
    this->Tree->AddDataSetIndex(this->Numbers[static_cast<std::size_t>(node)], part);
  }

private:
  const vitrine::Assembly& Source;
  vtkDataAssembly* Tree;
  std::vector<int> Numbers;
};
}

//------------------------------------------------------------------------------
vtkAssemblyReader::vtkAssemblyReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkAssemblyReader::~vtkAssemblyReader()
{
  this->SetFileName(nullptr);
  this->SetConverter(nullptr);
  this->SetCacheFolder(nullptr);
}

//------------------------------------------------------------------------------
void vtkAssemblyReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Scene: " << this->Scene << "\n";
  os << indent << "Converter: " << (this->Converter ? this->Converter : "(none)") << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "ConversionTimeLimit: " << this->ConversionTimeLimit << "\n";
  os << indent << "UseCache: " << this->UseCache << "\n";
  os << indent << "CacheFolder: " << (this->CacheFolder ? this->CacheFolder : "(none)") << "\n";
  os << indent << "CacheLimit: " << this->CacheLimit << "\n";
  os << indent << "Number of parts: " << this->GetNumberOfParts() << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}

//------------------------------------------------------------------------------
bool vtkAssemblyReader::Open()
{
  if (this->ReadTime >= this->GetMTime())
  {
    return this->ErrorMessage.empty();
  }
  this->Read.reset();
  this->ErrorMessage.clear();
  try
  {
    if (!this->FileName)
    {
      throw vitrine::AssemblyError("a file name is needed: SetFileName()");
    }
    this->Read = std::make_unique<Content>(this->ReadFile());
  }
  catch (const vitrine::AssemblyError& error)
  {
    this->ErrorMessage = error.what();
  }
  catch (const std::bad_alloc&)
  {
    this->ErrorMessage = "is damaged, or needs more memory than there is";
  }
  this->ReadTime = this->GetMTime(); // Reports of progress have changed it.
  return this->ErrorMessage.empty();
}

//------------------------------------------------------------------------------
vitrine::Assembly vtkAssemblyReader::ReadFile()
{
  if (!vitrine::IsCadFile(this->FileName))
  {
    return vitrine::ReadGltf(this->FileName, this->Scene);
  }
  vitrine::CadSettings settings;
  settings.Converter = this->Converter ? this->Converter : "";
  settings.Tolerance = this->Tolerance;
  settings.TimeLimit = this->ConversionTimeLimit;
  settings.UseCache = this->UseCache;
  settings.CacheFolder = this->CacheFolder ? this->CacheFolder : "";
  settings.CacheLimit = static_cast<std::uint64_t>(std::max(0, this->CacheLimit)) << 20;
  this->SetAbortExecute(0);
  return vitrine::ReadCad(this->FileName, this->Scene, settings,
    [this](double fraction, const std::string& task)
    {
      this->SetProgressText(task.c_str());
      this->UpdateProgress(fraction);
      return this->GetAbortExecute() == 0;
    });
}

//------------------------------------------------------------------------------
int vtkAssemblyReader::GetNumberOfParts() const
{
  return this->Read ? static_cast<int>(this->Read->Parts.size()) : 0;
}

//------------------------------------------------------------------------------
bool vtkAssemblyReader::IsPart(int part)
{
  if (part >= 0 && part < this->GetNumberOfParts())
  {
    return true;
  }
  vtkErrorMacro("There is no part " << part << "; there are " << this->GetNumberOfParts() << ".");
  return false;
}

//------------------------------------------------------------------------------
std::string vtkAssemblyReader::GetPartName(int part)
{
  return this->IsPart(part) ? this->Read->Part(part).Name : std::string();
}

//------------------------------------------------------------------------------
std::string vtkAssemblyReader::GetPartPath(int part)
{
  return this->IsPart(part) ? this->Read->Part(part).Path : std::string();
}

//------------------------------------------------------------------------------
std::string vtkAssemblyReader::GetPartMaterialName(int part)
{
  return this->IsPart(part) ? this->Read->LookOf(part).Name : std::string();
}

//------------------------------------------------------------------------------
std::string vtkAssemblyReader::FindParts(const std::string& pattern, vtkIdList* parts)
{
  const std::vector<vitrine::PartNames> none;
  return vitrine::FindParts(this->Read ? this->Read->Names : none, pattern, parts);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkAssemblyReader::GetPartGeometry(int part)
{
  return this->IsPart(part) ? this->Read->Part(part).Geometry.Get() : nullptr;
}

//------------------------------------------------------------------------------
vtkMatrix4x4* vtkAssemblyReader::GetPartPlace(int part)
{
  return this->IsPart(part) ? this->Read->Part(part).Place.Get() : nullptr;
}

//------------------------------------------------------------------------------
vtkProperty* vtkAssemblyReader::GetPartProperty(int part)
{
  return this->IsPart(part) ? this->Read->LookOf(part).Property.Get() : nullptr;
}

//------------------------------------------------------------------------------
vtkInformation* vtkAssemblyReader::GetPartKeys(int part)
{
  return this->IsPart(part) ? this->Read->LookOf(part).Keys.Get() : nullptr;
}

//------------------------------------------------------------------------------
bool vtkAssemblyReader::GetPartIsTranslucent(int part)
{
  return this->IsPart(part) && this->Read->LookOf(part).IsTranslucent;
}

//------------------------------------------------------------------------------
std::string vtkAssemblyReader::GetLengthUnit() const
{
  return this->Read ? this->Read->Source.LengthUnit : std::string();
}

//------------------------------------------------------------------------------
int vtkAssemblyReader::GetNumberOfNotes() const
{
  return this->Read ? static_cast<int>(this->Read->Source.Notes.size()) : 0;
}

//------------------------------------------------------------------------------
std::string vtkAssemblyReader::GetNote(int note)
{
  if (note < 0 || note >= this->GetNumberOfNotes())
  {
    vtkErrorMacro("There is no note " << note << "; there are " << this->GetNumberOfNotes() << ".");
    return {};
  }
  return this->Read->Source.Notes[static_cast<std::size_t>(note)];
}

//------------------------------------------------------------------------------
int vtkAssemblyReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  if (!this->Open())
  {
    vtkErrorMacro(<< (this->FileName ? this->FileName : "") << " " << this->ErrorMessage);
    return 0;
  }
  const std::vector<AssemblyPart>& parts = this->Read->Parts;
  std::vector<vtkSmartPointer<vtkPolyData>> placed(parts.size());
  vitrine::ForEachInThreads(parts.size(),
    [&](std::size_t i) { placed[i] = vitrine::PlaceGeometry(parts[i].Geometry, parts[i].Place); });

  vtkPartitionedDataSetCollection* const output =
    vtkPartitionedDataSetCollection::GetData(outputs, 0);
  output->SetNumberOfPartitionedDataSets(static_cast<unsigned int>(parts.size()));
  vtkNew<vtkDataAssembly> assembly;
  assembly->SetRootNodeName("Assembly");
  AssemblyTree tree(this->Read->Source, assembly);
  tree.AddNodes();
  for (unsigned int i = 0; i < parts.size(); ++i)
  {
    output->SetPartition(i, 0, placed[i]);
    output->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), parts[i].Name.c_str());
    tree.AddPart(parts[i].Node, i);
  }
  output->SetDataAssembly(assembly);
  return 1;
}
