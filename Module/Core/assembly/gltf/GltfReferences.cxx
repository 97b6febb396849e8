#include "Core/assembly/gltf/GltfReferences.h"

#include "Core/assembly/Assembly.h"

#include <string>
#include <vector>

namespace vitrine
{

namespace
{
using Json = GltfDocument::Json;

struct Reference
{
  std::vector<std::string> Place; ///< Keys from the top. "*" is each item or member.
  const char* Target;             ///< The array that is pointed into.
};

const std::vector<Reference>& References()
{
  const std::string any = "*";
  static const std::vector<Reference> references = {
    { { "scene" }, "scenes" },
    { { "scenes", any, "nodes", any }, "nodes" },
    { { "nodes", any, "children", any }, "nodes" },
    { { "nodes", any, "mesh" }, "meshes" },
    { { "nodes", any, "skin" }, "skins" },
    { { "nodes", any, "extensions", "EXT_mesh_gpu_instancing", "attributes", any }, "accessors" },
    { { "skins", any, "joints", any }, "nodes" },
    { { "skins", any, "inverseBindMatrices" }, "accessors" },
    { { "meshes", any, "primitives", any, "attributes", any }, "accessors" },
    { { "meshes", any, "primitives", any, "targets", any, any }, "accessors" },
    { { "meshes", any, "primitives", any, "indices" }, "accessors" },
    { { "meshes", any, "primitives", any, "material" }, "materials" },
    { { "meshes", any, "primitives", any, "extensions", "KHR_draco_mesh_compression",
        "bufferView" },
      "bufferViews" },
    { { "accessors", any, "bufferView" }, "bufferViews" },
    { { "accessors", any, "sparse", "indices", "bufferView" }, "bufferViews" },
    { { "accessors", any, "sparse", "values", "bufferView" }, "bufferViews" },
    { { "bufferViews", any, "buffer" }, "buffers" },
    { { "bufferViews", any, "extensions", "EXT_meshopt_compression", "buffer" }, "buffers" },
    { { "images", any, "bufferView" }, "bufferViews" },
    { { "textures", any, "source" }, "images" },
    { { "textures", any, "sampler" }, "samplers" },
    { { "materials", any, "pbrMetallicRoughness", "baseColorTexture", "index" }, "textures" },
    { { "materials", any, "pbrMetallicRoughness", "metallicRoughnessTexture", "index" },
      "textures" },
    { { "materials", any, "normalTexture", "index" }, "textures" },
    { { "materials", any, "occlusionTexture", "index" }, "textures" },
    { { "materials", any, "emissiveTexture", "index" }, "textures" },
    { { "materials", any, "extensions", "KHR_materials_pbrSpecularGlossiness", "diffuseTexture",
        "index" },
      "textures" },
  };
  return references;
}

void CheckReference(
  const Json& root, const char* target, const Json& number, const std::string& name)
{
  const std::size_t count = Member(root, target).size();
  if (!number.is_number_unsigned() || number.get<std::uint64_t>() >= count)
  {
    throw AssemblyError("is damaged: " + OneLine(name) + " is " + Shown(number) + ", and of " +
      target + " there are " + std::to_string(count));
  }
}

/** Checks all that a reference finds below `json`, which stands at `depth` of its place. */
void CheckBelow(const Json& root, const Reference& reference, std::size_t depth, const Json& json,
  const std::string& name)
{
  if (depth == reference.Place.size())
  {
    CheckReference(root, reference.Target, json, name);
    return;
  }
  const std::string& key = reference.Place[depth];
  if (key == "*" && !json.is_structured())
  {
    throw AssemblyError("is damaged: " + OneLine(name) + " is " + Shown(json) + ", and no list");
  }
  if (key == "*")
  {
    for (const auto& [itemKey, item] : json.items())
    {
      CheckBelow(root, reference, depth + 1, item, name + "/" + itemKey);
    }
  }
  else if (json.is_object() && json.contains(key))
  {
    CheckBelow(root, reference, depth + 1, json.at(key), name + "/" + key);
  }
}

void CheckRange(const GltfDocument& document, const Json& range, const std::string& name)
{
  const ByteView buffer = document.Buffer(range.at("buffer").get<std::size_t>());
  if (Number(range, "byteOffset", 0) + Number(range, "byteLength", 0) > buffer.Size)
  {
    throw AssemblyError("is damaged: " + name + " reaches beyond its buffer");
  }
}
}

void CheckGltfReferences(const Json& root)
{
  for (const Reference& reference : References())
  {
    CheckBelow(root, reference, 0, root, "");
  }
}

void CheckGltfViews(const GltfDocument& document)
{
  const Json& views = document.Objects("bufferViews");
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    const Json* const compressed = Extension(views[i], "EXT_meshopt_compression");
    CheckRange(document, compressed ? *compressed : views[i], "bufferView " + std::to_string(i));
  }
}

}
