#include "scene/files/GltfReferences.h"

#include "Errors.h"

#include <vector>

namespace program
{

namespace
{
using Json = nlohmann::json;

struct Reference
{
  std::vector<std::string> Place; ///< keys from the top; "*" is every item or member
  std::string Target;             ///< the array that is pointed into
};

const std::vector<Reference>& References()
{
  static const std::vector<Reference> references = {
    { { "scene" }, "scenes" },
    { { "scenes", "*", "nodes", "*" }, "nodes" },
    { { "nodes", "*", "children", "*" }, "nodes" },
    { { "nodes", "*", "mesh" }, "meshes" },
    { { "nodes", "*", "skin" }, "skins" },
    { { "nodes", "*", "camera" }, "cameras" },
    { { "skins", "*", "joints", "*" }, "nodes" },
    { { "skins", "*", "skeleton" }, "nodes" },
    { { "skins", "*", "inverseBindMatrices" }, "accessors" },
    { { "animations", "*", "samplers", "*", "input" }, "accessors" },
    { { "animations", "*", "samplers", "*", "output" }, "accessors" },
    { { "animations", "*", "channels", "*", "target", "node" }, "nodes" },
    { { "meshes", "*", "primitives", "*", "attributes", "*" }, "accessors" },
    { { "meshes", "*", "primitives", "*", "targets", "*", "*" }, "accessors" },
    { { "meshes", "*", "primitives", "*", "indices" }, "accessors" },
    { { "meshes", "*", "primitives", "*", "material" }, "materials" },
    { { "accessors", "*", "bufferView" }, "bufferViews" },
    { { "accessors", "*", "sparse", "indices", "bufferView" }, "bufferViews" },
    { { "accessors", "*", "sparse", "values", "bufferView" }, "bufferViews" },
    { { "bufferViews", "*", "buffer" }, "buffers" },
    { { "images", "*", "bufferView" }, "bufferViews" },
    { { "textures", "*", "source" }, "images" },
    { { "textures", "*", "sampler" }, "samplers" },
    { { "materials", "*", "pbrMetallicRoughness", "baseColorTexture", "index" }, "textures" },
    { { "materials", "*", "pbrMetallicRoughness", "metallicRoughnessTexture", "index" },
      "textures" },
    { { "materials", "*", "normalTexture", "index" }, "textures" },
    { { "materials", "*", "occlusionTexture", "index" }, "textures" },
    { { "materials", "*", "emissiveTexture", "index" }, "textures" },
  };
  return references;
}

std::size_t CountItems(const Json& document, const std::string& array)
{
  const auto found = document.find(array);
  return found != document.end() && found->is_array() ? found->size() : 0;
}

/** Check all that `reference` finds below `json`, which stands at depth `depth` of its place. */
void CheckBelow(const GltfDocument& document, const Reference& reference, std::size_t depth,
  const Json& json, const std::string& name)
{
  if (depth == reference.Place.size())
  {
    if (!json.is_number_unsigned() ||
      json.get<std::size_t>() >= CountItems(document.Json, reference.Target))
    {
      throw InputError(document.Path,
        "is damaged: " + name + " is " + json.dump(-1, ' ', true, Json::error_handler_t::replace) +
          ", and of " + reference.Target + " there are " +
          std::to_string(CountItems(document.Json, reference.Target)));
    }
    return;
  }
  const std::string& key = reference.Place[depth];
  if (key == "*" && json.is_structured())
  {
    for (const auto& [itemKey, item] : json.items())
    {
      CheckBelow(document, reference, depth + 1, item, name + "/" + itemKey);
    }
  }
  else if (json.is_object() && json.contains(key))
  {
    CheckBelow(document, reference, depth + 1, json.at(key), name + "/" + key);
  }
}
}

void CheckGltfReferences(const GltfDocument& document)
{
  for (const Reference& reference : References())
  {
    CheckBelow(document, reference, 0, document.Json, "");
  }
}

}
