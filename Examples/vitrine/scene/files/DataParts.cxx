#include "scene/files/DataParts.h"

#include "Core/assembly/UniqueNames.h"
#include "Errors.h"
#include "scene/files/FileReaders.h"
#include "scene/files/GeometryCheck.h"
#include "scene/files/GridCheck.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataAssembly.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <vector>

namespace program
{

namespace
{
const char* const VolumeNote = "volume meshes are shown by their surfaces";

/** Only bytes are colours. Other scalars, such as stresses, are not shown unless they are asked for. */
void ForgetScalarsThatAreNoColors(vtkDataSetAttributes* data)
{
  vtkDataArray* const scalars = data->GetScalars();
  const bool isColor = scalars && scalars->GetDataType() == VTK_UNSIGNED_CHAR &&
    (scalars->GetNumberOfComponents() == 3 || scalars->GetNumberOfComponents() == 4);
  if (!isColor)
  {
    data->SetActiveScalars(nullptr);
  }
}

vtkSmartPointer<vtkPolyData> MakeSurface(vtkDataSet* data)
{
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(data);
  surface->Update();
  auto geometry = vtkSmartPointer<vtkPolyData>::New();
  geometry->ShallowCopy(surface->GetOutput());
  ForgetScalarsThatAreNoColors(geometry->GetPointData());
  ForgetScalarsThatAreNoColors(geometry->GetCellData());
  return geometry;
}

std::string NameOr(vtkInformation* about, const std::string& otherwise)
{
  const char* const name = about && about->Has(vtkCompositeDataSet::NAME())
    ? about->Get(vtkCompositeDataSet::NAME())
    : nullptr;
  return name && *name ? name : otherwise;
}

/** Goes through a tree of data and makes a part of each leaf. */
class PartCollector
{
public:
  explicit PartCollector(const std::string& path)
    : File(path)
  {
  }

  Scene Collect(vtkDataObject* root)
  {
    this->AddChildren(root, "");
    DrawManyPartsAsBlocks(this->Result);
    return std::move(this->Result);
  }

private:
  /** Adds what is below a node of the tree, whose own path is `path`. */
  void AddChildren(vtkDataObject* node, const std::string& path)
  {
    if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(node))
    {
      this->AddCollection(collection, path);
    }
    else if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(node))
    {
      this->AddPartitions(partitions, path);
    }
    else if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(node))
    {
      for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
      {
        const std::string number = "block-" + std::to_string(++this->FlatIndex);
        this->Add(blocks->GetBlock(i),
          NameOr(blocks->HasMetaData(i) ? blocks->GetMetaData(i) : nullptr, number), path);
      }
    }
  }

  /** Adds a child called `name` of the node at `path`. */
  void Add(vtkDataObject* child, const std::string& name, const std::string& path)
  {
    if (!child)
    {
      this->Result.Skipped.push_back({ name, "is empty" });
    }
    else if (child->IsA("vtkDataObjectTree"))
    {
      this->AddChildren(child, path + PathStep(name));
    }
    else
    {
      this->AddLeaf(child, name, path + PathStep(name));
    }
  }

  void AddLeaf(vtkDataObject* leaf, const std::string& name, const std::string& path)
  {
    auto* const data = vtkDataSet::SafeDownCast(leaf);
    if (!data)
    {
      this->Result.Skipped.push_back(
        { name, std::string("is a ") + leaf->GetClassName() + ", not a data set" });
      return;
    }
    Part part;
    part.Name = name;
    part.Path = this->Paths.Make(path);
    part.Geometry = this->GeometryOf(data, name);
    part.Material = this->Material;
    this->Result.Parts.push_back(part);
  }

  vtkSmartPointer<vtkPolyData> GeometryOf(vtkDataSet* data, const std::string& name)
  {
    if (auto* geometry = vtkPolyData::SafeDownCast(data))
    {
      return geometry;
    }
    const std::string problem = FindGridProblem(data);
    if (!problem.empty())
    {
      throw InputError(this->File, "is damaged: '" + name + "' " + problem);
    }
    if (HasVolumeCells(data))
    {
      this->Result.Notes = { VolumeNote };
    }
    return MakeSurface(data);
  }

  /** One partition is the data set itself. Of several, each is a part. */
  void AddPartitions(vtkPartitionedDataSet* partitions, const std::string& path)
  {
    const std::string name = path.substr(path.rfind('/') + 1);
    const unsigned int count = partitions->GetNumberOfPartitions();
    if (count == 0)
    {
      this->Result.Skipped.push_back({ name, "is empty" });
    }
    for (unsigned int i = 0; i < count; ++i)
    {
      ++this->FlatIndex;
      vtkDataObject* const partition = partitions->GetPartitionAsDataObject(i);
      if (count == 1 && partition && !path.empty())
      {
        this->AddLeaf(partition, name, path);
        continue;
      }
      vtkInformation* const about =
        partitions->HasMetaData(i) ? partitions->GetMetaData(i) : nullptr;
      this->Add(partition, NameOr(about, "partition-" + std::to_string(i)), path);
    }
  }

  void AddCollection(vtkPartitionedDataSetCollection* collection, const std::string& path)
  {
    std::set<unsigned int> isPlaced;
    if (vtkDataAssembly* const assembly = collection->GetDataAssembly())
    {
      this->AddNode(*collection, *assembly, vtkDataAssembly::GetRootNode(), path, isPlaced);
    }
    for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
    {
      if (isPlaced.count(i) == 0)
      {
        this->AddDataSet(*collection, i, path + PathStep(NameIn(*collection, i)));
      }
    }
  }

  /** Adds what stands below a node of a collection's hierarchy. A data set that stands there again is added once. */
  void AddNode(vtkPartitionedDataSetCollection& collection, vtkDataAssembly& assembly, int node,
    const std::string& path, std::set<unsigned int>& isPlaced)
  {
    const std::vector<int> children = assembly.GetChildNodes(node, /* traverse_subtree= */ false);
    const std::vector<unsigned int> own =
      assembly.GetDataSetIndices(node, /* traverse_subtree= */ false);
    const bool isLeaf =
      node != vtkDataAssembly::GetRootNode() && children.empty() && own.size() == 1;
    for (const unsigned int index : own)
    {
      if (index < collection.GetNumberOfPartitionedDataSets() && isPlaced.insert(index).second)
      {
        this->AddDataSet(
          collection, index, isLeaf ? path : path + PathStep(NameIn(collection, index)));
      }
    }
    for (const int child : children)
    {
      const char* const label = assembly.GetAttributeOrDefault(child, "label", "");
      const std::string name = *label ? label : assembly.GetNodeName(child);
      this->AddNode(collection, assembly, child, path + PathStep(name), isPlaced);
    }
  }

  void AddDataSet(
    vtkPartitionedDataSetCollection& collection, unsigned int index, const std::string& path)
  {
    if (vtkPartitionedDataSet* const partitions = collection.GetPartitionedDataSet(index))
    {
      this->AddPartitions(partitions, path);
    }
    else
    {
      this->Result.Skipped.push_back({ NameIn(collection, index), "is empty" });
    }
  }

  static std::string NameIn(vtkPartitionedDataSetCollection& collection, unsigned int index)
  {
    return NameOr(collection.HasMetaData(index) ? collection.GetMetaData(index) : nullptr,
      "block-" + std::to_string(index));
  }

  const std::string& File;
  Scene Result;
  vtkSmartPointer<vtkProperty> Material = vtkSmartPointer<vtkProperty>::New(); ///< of all parts
  vitrine::UniqueNames Paths;
  int FlatIndex = 0; ///< as VTK counts blocks
};
}

Scene MakeDataScene(const std::string& path, vtkDataObject* data)
{
  if (!data)
  {
    throw InputError(path, "holds nothing that VTK could read");
  }
  if (auto* geometry = vtkPolyData::SafeDownCast(data))
  {
    return MakeSinglePartScene(path, geometry);
  }
  PartCollector collector(path);
  if (data->IsA("vtkDataObjectTree"))
  {
    return collector.Collect(data);
  }
  vtkNew<vtkMultiBlockDataSet> single;
  single->SetBlock(0, data);
  single->GetMetaData(0u)->Set(
    vtkCompositeDataSet::NAME(), std::filesystem::path(path).stem().string().c_str());
  Scene scene = collector.Collect(single);
  if (!scene.Parts.empty())
  {
    Scene whole = MakeSinglePartScene(path, scene.Parts.front().Geometry);
    whole.Notes = scene.Notes;
    return whole;
  }
  return scene;
}

}
