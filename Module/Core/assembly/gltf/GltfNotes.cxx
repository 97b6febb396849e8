#include "Core/assembly/gltf/GltfNotes.h"

#include "Core/assembly/UsedImages.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace vitrine
{

namespace
{
using Json = GltfDocument::Json;

struct Remark
{
  const char* Extension;
  const char* Factor; ///< The number without which the extension has no effect, or null.
  const char* Text;   ///< Null for an extension that is shown as it says.
};

constexpr Remark REMARKS[] = {
  { "EXT_mesh_gpu_instancing", nullptr, nullptr },
  { "EXT_texture_webp", nullptr, "textures in WebP are not read (EXT_texture_webp)" },
  { "KHR_draco_mesh_compression", nullptr, nullptr },
  { "KHR_lights_punctual", nullptr, "lights of the file are left out (KHR_lights_punctual)" },
  { "KHR_materials_anisotropy", "anisotropyStrength",
    "reflection is the same in all directions (KHR_materials_anisotropy)" },
  { "KHR_materials_clearcoat", "clearcoatFactor",
    "clear coats are left out (KHR_materials_clearcoat)" },
  { "KHR_materials_dispersion", "dispersion", "light is not dispersed (KHR_materials_dispersion)" },
  { "KHR_materials_emissive_strength", nullptr, nullptr },
  { "KHR_materials_ior", nullptr, nullptr },
  { "KHR_materials_iridescence", "iridescenceFactor",
    "thin films are left out (KHR_materials_iridescence)" },
  { "KHR_materials_pbrSpecularGlossiness", nullptr,
    "colours of reflection are left out (KHR_materials_pbrSpecularGlossiness)" },
  { "KHR_materials_sheen", nullptr, "sheen is left out (KHR_materials_sheen)" },
  { "KHR_materials_specular", nullptr, nullptr },
  { "KHR_materials_transmission", "transmissionFactor",
    "transmission is shown as opacity, without refraction (KHR_materials_transmission)" },
  { "KHR_materials_unlit", nullptr, nullptr },
  { "KHR_materials_variants", nullptr,
    "the first variant of materials is shown (KHR_materials_variants)" },
  { "KHR_materials_volume", "thicknessFactor",
    "absorption within volumes is left out (KHR_materials_volume)" },
  { "KHR_texture_basisu", nullptr,
    "textures in KTX2 are not read (KHR_texture_basisu); convert them to PNG" },
  { "KHR_texture_transform", nullptr, nullptr },
};

const Remark* FindRemark(const std::string& extension)
{
  const auto* const found = std::find_if(std::begin(REMARKS), std::end(REMARKS),
    [&extension](const Remark& remark) { return extension == remark.Extension; });
  return found == std::end(REMARKS) ? nullptr : found;
}

bool HasEffect(const Remark& remark, const Json& extension)
{
  const auto factor = remark.Factor ? extension.find(remark.Factor) : extension.end();
  return !remark.Factor ||
    (factor != extension.end() && factor->is_number() && factor->get<double>() != 0.0);
}

/** Collects notes of objects of the document. */
class Notes
{
public:
  void AddExtensions(const Json& object)
  {
    const Json& extensions = Member(object, "extensions");
    for (const auto& [name, extension] : extensions.items())
    {
      const Remark* const remark = FindRemark(name);
      if (!remark)
      {
        this->Texts.insert("the extension " + OneLine(name) + " is not read");
      }
      else if (remark->Text && HasEffect(*remark, extension))
      {
        this->Texts.insert(remark->Text);
      }
    }
  }

  /** Adds the extensions of a material, and of the uses of textures within it. */
  void AddMaterial(const Json& material)
  {
    this->AddExtensions(material);
    const Json& base = Member(material, "pbrMetallicRoughness");
    this->AddExtensions(base);
    for (const Json* const owner : { &material, &base })
    {
      for (const char* key : { "baseColorTexture", "metallicRoughnessTexture", "normalTexture",
             "occlusionTexture", "emissiveTexture" })
      {
        this->AddExtensions(Member(*owner, key));
      }
    }
  }

  /** Adds the extensions by which a texture names its picture, if it names no other. */
  void AddTexture(const Json& texture)
  {
    if (!texture.contains("source"))
    {
      this->AddExtensions(texture);
    }
  }

  void Add(const char* text) { this->Texts.insert(text); }

  const std::set<std::string>& All() const { return this->Texts; }

private:
  std::set<std::string> Texts;
};

std::set<std::size_t> UsedMaterials(const GltfDocument& document, const GltfScene& scene)
{
  std::set<std::size_t> used;
  for (const GltfPose& pose : scene.Poses)
  {
    for (const Json& primitive : Member(document.Object("meshes", pose.Mesh), "primitives"))
    {
      if (primitive.contains("material"))
      {
        used.insert(primitive.at("material").get<std::size_t>());
      }
    }
  }
  return used;
}

void AddNodesAndMeshes(const GltfDocument& document, const GltfScene& scene, Notes& notes)
{
  for (const std::size_t node : scene.Nodes)
  {
    notes.AddExtensions(document.Object("nodes", node));
  }
  for (const GltfPose& pose : scene.Poses)
  {
    const Json& mesh = document.Object("meshes", pose.Mesh);
    notes.AddExtensions(mesh);
    for (const Json& primitive : Member(mesh, "primitives"))
    {
      notes.AddExtensions(primitive);
    }
  }
}

void AddMaterials(
  const GltfDocument& document, const GltfScene& scene, const Assembly& assembly, Notes& notes)
{
  for (const std::size_t material : UsedMaterials(document, scene))
  {
    notes.AddMaterial(document.Object("materials", material));
    for (const int texture : TexturesOf(assembly.Materials[material]))
    {
      if (texture != NO_INDEX)
      {
        notes.AddTexture(document.Object("textures", static_cast<std::size_t>(texture)));
      }
    }
  }
}
}

void NoteWhatIsNotShown(const GltfDocument& document, const GltfScene& scene, Assembly& assembly)
{
  Notes notes;
  AddNodesAndMeshes(document, scene, notes);
  AddMaterials(document, scene, assembly, notes);
  if (!document.Objects("animations").empty())
  {
    notes.Add("animations are not played");
  }
  assembly.Notes.insert(assembly.Notes.end(), notes.All().begin(), notes.All().end());
}

}
