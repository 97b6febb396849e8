#include "culling/SceneForm.h"

#include "culling/MergedMesh.h"

#include "vtkCulledCompositePolyDataMapper.h"
#include "vtkCulledPolyDataMapper.h"
#include "vtkMultiBlockDataSet.h"

namespace program
{

namespace
{

MergedMesh::Color ColorOf(const Part& part)
{
  const double* color = part.Material->GetDiffuseColor();
  MergedMesh::Color bytes;
  for (std::size_t i = 0; i < 3; ++i)
  {
    bytes[i] = static_cast<unsigned char>(255.0 * color[i] + 0.5);
  }
  return bytes;
}

vtkSmartPointer<vtkMapper> MapBlocks(const Scene& scene)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(static_cast<unsigned int>(scene.Parts.size()));
  for (std::size_t i = 0; i < scene.Parts.size(); ++i)
  {
    MergedMesh mesh;
    mesh.Add(scene.Parts[i], ColorOf(scene.Parts[i]));
    blocks->SetBlock(static_cast<unsigned int>(i), mesh.Mesh());
  }
  auto mapper = vtkSmartPointer<vtkCulledCompositePolyDataMapper>::New();
  mapper->SetInputDataObject(blocks);
  return mapper;
}

vtkSmartPointer<vtkMapper> MapMesh(const Scene& scene)
{
  MergedMesh mesh;
  for (const Part& part : scene.Parts)
  {
    mesh.Add(part, ColorOf(part));
  }
  auto mapper = vtkSmartPointer<vtkCulledPolyDataMapper>::New();
  mapper->SetInputData(mesh.Mesh());
  return mapper;
}
}

const std::map<std::string, SceneForm>& NamesOfForms()
{
  static const std::map<std::string, SceneForm> names = { { "actors", SceneForm::Actors },
    { "blocks", SceneForm::Blocks }, { "mesh", SceneForm::Mesh } };
  return names;
}

vtkSmartPointer<vtkActor> MakeActorOfAll(const Scene& scene, SceneForm form)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(form == SceneForm::Blocks ? MapBlocks(scene) : MapMesh(scene));
  return actor;
}

}
