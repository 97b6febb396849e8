#include "scene/files/FileReaders.h"

#include "Errors.h"
#include "scene/files/GltfCheck.h"
#include "scene/files/GltfDocument.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkGLTFImporter.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <map>

namespace program
{

namespace
{
using Json = nlohmann::json;

/** A primitive of a mesh at a node. */
struct Placed
{
  std::string Name;
  int Material; ///< -1 for glTF's default
};

std::string PrimitiveName(
  const Json& node, std::size_t nodeIndex, const Json& mesh, std::size_t primitive)
{
  std::string name = node.value("name", mesh.value("name", ""));
  if (name.empty())
  {
    name = "node-" + std::to_string(nodeIndex);
  }
  return mesh.at("primitives").size() > 1 ? name + "/" + std::to_string(primitive) : name;
}

/** What VTK's importer makes an actor of, in its order: depth first, the last child first. */
std::vector<Placed> ListPrimitives(const Json& document)
{
  std::vector<std::size_t> stack;
  const Json& scene = document.at("scenes").at(document.value("scene", 0));
  for (const Json& node : scene.value("nodes", Json::array()))
  {
    stack.push_back(node.get<std::size_t>());
  }
  std::vector<Placed> placed;
  while (!stack.empty())
  {
    const std::size_t index = stack.back();
    stack.pop_back();
    const Json& node = document.at("nodes").at(index);
    if (node.contains("mesh"))
    {
      const Json& mesh = document.at("meshes").at(node.at("mesh").get<std::size_t>());
      for (std::size_t i = 0; i < mesh.at("primitives").size(); ++i)
      {
        placed.push_back(
          { PrimitiveName(node, index, mesh, i), mesh.at("primitives")[i].value("material", -1) });
      }
    }
    for (const Json& child : node.value("children", Json::array()))
    {
      stack.push_back(child.get<std::size_t>());
    }
  }
  return placed;
}

/**
 * The alpha of a material's colour, which the importer of VTK 9.1 drops. glTF ignores it unless
 * alphaMode is BLEND or MASK; VTK has no cutoff for MASK and draws it as BLEND.
 */
double MaterialAlpha(const Json& document, int material)
{
  if (material < 0)
  {
    return 1.0;
  }
  const Json& json = document.at("materials").at(static_cast<std::size_t>(material));
  if (json.value("alphaMode", "OPAQUE") == "OPAQUE" || !json.contains("pbrMetallicRoughness"))
  {
    return 1.0;
  }
  const Json& color = json.at("pbrMetallicRoughness").value("baseColorFactor", Json::array());
  return color.size() == 4 ? color[3].get<double>() : 1.0;
}

void NoteWhatIsLost(const Json& document, Scene& scene)
{
  for (const Json& material : document.value("materials", Json::array()))
  {
    if (material.value("alphaMode", "OPAQUE") == "MASK")
    {
      scene.Notes.push_back("material '" + material.value("name", "") +
        "' has a cutoff of alpha (alphaMode MASK); it is blended, as VTK does");
    }
  }
  if (!document.value("skins", Json::array()).empty())
  {
    scene.Notes.push_back("skins are not applied: meshes are shown as they are stored");
  }
}

/** Parts of the same material share one, so that `info` can count them. */
class Materials
{
public:
  explicit Materials(const Json& document)
    : Document(document)
  {
  }

  vtkSmartPointer<vtkProperty> Share(int material, vtkActor* actor)
  {
    vtkSmartPointer<vtkProperty>& shared = this->Shared[material];
    if (!shared)
    {
      shared = actor->GetProperty();
      shared->SetOpacity(MaterialAlpha(this->Document, material));
    }
    return shared;
  }

private:
  const Json& Document;
  std::map<int, vtkSmartPointer<vtkProperty>> Shared;
};

Part MakePart(vtkActor* actor, const Placed& placed, Materials& materials)
{
  Part part;
  part.Name = placed.Name;
  part.Geometry = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput());
  part.Material = materials.Share(placed.Material, actor);
  part.Transform = actor->GetUserMatrix();
  part.Keys = actor->GetPropertyKeys();
  part.ForceTranslucent = actor->GetForceTranslucent();
  return part;
}
}

Scene ReadGltfFile(const std::string& path)
{
  const GltfDocument document = ReadGltfDocument(path);
  CheckGltf(document);
  vtkNew<vtkRenderWindow> window; // the importer wants one; it is never drawn
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<vtkGLTFImporter> importer;
  importer->SetFileName(path.c_str());
  importer->SetRenderWindow(window);
  importer->Update();

  const std::vector<Placed> placed = ListPrimitives(document.Json);
  vtkActorCollection* actors = renderer->GetActors();
  if (actors->GetNumberOfItems() != static_cast<int>(placed.size()))
  {
    throw InputError(path, "cannot be read: VTK's importer found other parts than its nodes have");
  }
  Scene scene;
  Materials materials(document.Json);
  actors->InitTraversal();
  for (const Placed& primitive : placed)
  {
    scene.Parts.push_back(MakePart(actors->GetNextActor(), primitive, materials));
  }
  NoteWhatIsLost(document.Json, scene);
  return scene;
}

}
