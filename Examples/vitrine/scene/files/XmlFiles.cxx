/**
 * VTK's own files: .vtp and .vtm.
 */
#include "scene/files/FileReaders.h"

#include "Errors.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLMultiBlockDataReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUtilities.h"

namespace program
{

namespace
{
const int MostBlocks = 1000000; // of a level; VTK's reader makes room for as many as the file says

void CheckBlockIndices(const std::string& path, vtkXMLDataElement* element)
{
  int index = 0;
  if (element->GetScalarAttribute("index", index) && (index < 0 || index >= MostBlocks))
  {
    throw InputError(path, "is damaged: a block has index " + std::to_string(index));
  }
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    CheckBlockIndices(path, element->GetNestedElement(i));
  }
}

/** The name that the file gives a leaf, or its number. */
std::string LeafName(vtkDataObjectTreeIterator* leaf)
{
  if (leaf->HasCurrentMetaData() && leaf->GetCurrentMetaData()->Has(vtkCompositeDataSet::NAME()))
  {
    return leaf->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME());
  }
  return "block-" + std::to_string(leaf->GetCurrentFlatIndex());
}

void AddLeaf(Scene& scene, const std::string& name, vtkDataObject* leaf)
{
  auto* geometry = vtkPolyData::SafeDownCast(leaf);
  if (!geometry)
  {
    scene.Skipped.push_back(
      { name, std::string("is a ") + leaf->GetClassName() + ", not a surface" });
    return;
  }
  Part part;
  part.Name = name;
  part.Geometry = geometry;
  part.Material = vtkSmartPointer<vtkProperty>::New();
  scene.Parts.push_back(part);
}
}

Scene ReadPolyDataFile(const std::string& path)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return MakeSinglePartScene(path, reader->GetOutput());
}

Scene ReadMultiBlockFile(const std::string& path)
{
  vtkSmartPointer<vtkXMLDataElement> root;
  root.TakeReference(vtkXMLUtilities::ReadElementFromFile(path.c_str()));
  if (!root)
  {
    throw InputError(path, "is no VTM file, or damaged");
  }
  CheckBlockIndices(path, root);
  vtkNew<vtkXMLMultiBlockDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  if (!blocks)
  {
    throw InputError(path, "holds no blocks");
  }
  Scene scene;
  vtkSmartPointer<vtkDataObjectTreeIterator> leaf;
  leaf.TakeReference(blocks->NewTreeIterator());
  leaf->SkipEmptyNodesOff();
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    if (vtkDataObject* data = leaf->GetCurrentDataObject())
    {
      AddLeaf(scene, LeafName(leaf), data);
    }
    else
    {
      scene.Skipped.push_back({ LeafName(leaf), "is empty" });
    }
  }
  return scene;
}

}
