#include "scene/files/GltfCheck.h"

#include "Errors.h"
#include "scene/files/GltfAccessors.h"
#include "scene/files/GltfReferences.h"
#include "scene/files/ImageCheck.h"

#include <map>
#include <set>

namespace program
{

namespace
{
using Json = nlohmann::json;

const int DeepestNode = 1000; // VTK's importer goes down by recursion
const int LastPrimitiveMode = 6;
const int TriangleFan = 6;

const Json& Items(const Json& json, const char* key)
{
  static const Json none = Json::array();
  const auto found = json.find(key);
  return found == json.end() ? none : *found;
}

/** The types in which glTF allows the attributes that VTK draws from. */
bool HasRightType(const std::string& attribute, const GltfAccessor& accessor)
{
  static const std::map<std::string, std::set<std::string>> types = { { "POSITION", { "VEC3" } },
    { "NORMAL", { "VEC3" } }, { "TANGENT", { "VEC4" } }, { "TEXCOORD_0", { "VEC2" } },
    { "TEXCOORD_1", { "VEC2" } }, { "COLOR_0", { "VEC3", "VEC4" } }, { "JOINTS_0", { "VEC4" } },
    { "WEIGHTS_0", { "VEC4" } } };
  const auto found = types.find(attribute);
  if (found == types.end())
  {
    return true;
  }
  const bool isReal = accessor.Component == GLTF_FLOAT || accessor.IsNormalized;
  return found->second.count(accessor.Type) == 1 && (isReal || attribute == "JOINTS_0") &&
    (attribute != "POSITION" || accessor.Component == GLTF_FLOAT);
}

void CheckAttributes(
  const GltfDocument& document, const std::string& name, const Json& attributes, std::size_t count)
{
  for (const auto& [attribute, index] : attributes.items())
  {
    const GltfAccessor accessor = DescribeGltfAccessor(document, index.get<std::size_t>());
    if (accessor.Count != count)
    {
      throw InputError(document.Path,
        "is damaged: " + name + " has " + std::to_string(count) + " vertices and " +
          std::to_string(accessor.Count) + " of " + attribute);
    }
  }
}

void CheckIndices(
  const GltfDocument& document, const std::string& name, std::size_t index, std::size_t count)
{
  const GltfAccessor accessor = DescribeGltfAccessor(document, index);
  const bool isUnsigned = accessor.Component == GLTF_UNSIGNED_BYTE ||
    accessor.Component == GLTF_UNSIGNED_SHORT || accessor.Component == GLTF_UNSIGNED_INT;
  if (accessor.Type != "SCALAR" || !isUnsigned || accessor.IsSparse)
  {
    throw InputError(document.Path, name + " has indices that VTK's importer cannot read");
  }
  if (LargestGltfIndex(document, index) >= count)
  {
    throw InputError(document.Path,
      "is damaged: " + name + " has an index beyond its " + std::to_string(count) + " vertices");
  }
}

void CheckPrimitive(const GltfDocument& document, const std::string& name, const Json& primitive)
{
  const Json& attributes = primitive.at("attributes");
  if (!attributes.contains("POSITION"))
  {
    throw InputError(document.Path, name + " has no positions");
  }
  for (const auto& [attribute, index] : attributes.items())
  {
    if (!HasRightType(attribute, DescribeGltfAccessor(document, index.get<std::size_t>())))
    {
      throw InputError(
        document.Path, name + " has a " + attribute + " of a type that VTK's importer cannot read");
    }
  }
  const std::size_t vertices =
    DescribeGltfAccessor(document, attributes.at("POSITION").get<std::size_t>()).Count;
  CheckAttributes(document, name, attributes, vertices);
  for (const Json& target : Items(primitive, "targets"))
  {
    CheckAttributes(document, name, target, vertices);
  }
  std::size_t corners = vertices;
  if (primitive.contains("indices"))
  {
    const std::size_t indices = primitive.at("indices").get<std::size_t>();
    CheckIndices(document, name, indices, vertices);
    corners = DescribeGltfAccessor(document, indices).Count;
  }
  const int mode = primitive.value("mode", 4);
  if (mode < 0 || mode > LastPrimitiveMode || (mode == TriangleFan && corners < 3))
  {
    throw InputError(document.Path, "is damaged: " + name + " is of no kind that there is");
  }
}

void CheckMeshes(const GltfDocument& document)
{
  const Json& meshes = Items(document.Json, "meshes");
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh)
  {
    const Json& primitives = meshes[mesh].at("primitives");
    for (std::size_t i = 0; i < primitives.size(); ++i)
    {
      CheckPrimitive(document,
        "primitive " + std::to_string(i) + " of mesh " + std::to_string(mesh), primitives[i]);
    }
  }
}

/** Follow a node down; `reached` holds all nodes met so far, none of which may be met again. */
void CheckNode(
  const GltfDocument& document, std::size_t node, int depth, std::set<std::size_t>& reached)
{
  if (depth > DeepestNode || !reached.insert(node).second)
  {
    throw InputError(document.Path, "is damaged: its nodes form no tree");
  }
  for (const Json& child : Items(Items(document.Json, "nodes")[node], "children"))
  {
    CheckNode(document, child.get<std::size_t>(), depth + 1, reached);
  }
}

void CheckScenes(const GltfDocument& document)
{
  const Json& scenes = Items(document.Json, "scenes");
  if (scenes.empty())
  {
    throw InputError(document.Path, "has no scene");
  }
  std::set<std::size_t> reached;
  for (const Json& scene : scenes)
  {
    std::set<std::size_t> reachedHere;
    for (const Json& node : Items(scene, "nodes"))
    {
      CheckNode(document, node.get<std::size_t>(), 0, reachedHere);
    }
    reached.insert(reachedHere.begin(), reachedHere.end());
  }
  for (const Json& skin : Items(document.Json, "skins"))
  {
    for (const Json& joint : Items(skin, "joints"))
    {
      if (reached.count(joint.get<std::size_t>()) == 0)
      {
        throw InputError(document.Path, "is damaged: a skin has a joint that is in no scene");
      }
    }
  }
}

/**
 * VTK's importer gives its decoders all that follows an image in its buffer, so an image must end
 * where it says.
 */
void CheckGltfImage(const GltfDocument& document, std::size_t index)
{
  const Json& image = document.Json.at("images").at(index);
  const std::string bytes = image.contains("bufferView")
    ? GltfViewBytes(document, image.at("bufferView").get<std::size_t>())
    : ReadGltfUri(document, image.at("uri").get<std::string>());
  const std::string name = "image " + std::to_string(index);
  const ImageFormat format = CheckImage(document.Path, name, bytes);
  const char* const type = format == ImageFormat::PNG ? "image/png" : "image/jpeg";
  if (image.value("mimeType", type) != type)
  {
    throw InputError(document.Path, "is damaged: " + name + " is not of the type that it states");
  }
}

void CheckTextures(const GltfDocument& document)
{
  for (const Json& texture : Items(document.Json, "textures"))
  {
    if (!texture.contains("source"))
    {
      throw InputError(document.Path, "has a texture without an image that VTK could read");
    }
  }
  for (std::size_t i = 0; i < Items(document.Json, "images").size(); ++i)
  {
    CheckGltfImage(document, i);
  }
}
}

void CheckGltf(const GltfDocument& document)
{
  CheckGltfReferences(document);
  CheckGltfAccessors(document);
  CheckMeshes(document);
  CheckScenes(document);
  CheckTextures(document);
}

}
