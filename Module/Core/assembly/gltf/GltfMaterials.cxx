#include "Core/assembly/gltf/GltfMaterials.h"

#include "Core/assembly/UsedImages.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace vitrine
{

namespace
{
using Json = GltfDocument::Json;

// The opacity of glass that lets all light pass. Its reflections are drawn by this share too, so it is not near 0.
constexpr float LEAST_OPACITY_OF_GLASS = 0.3f;

enum GltfFilter
{
  GLTF_NEAREST = 9728,
  GLTF_LINEAR = 9729,
  GLTF_CLAMP_TO_EDGE = 33071,
  GLTF_MIRRORED_REPEAT = 33648
};

float FactorOf(const Json& number)
{
  const float factor = number.get<float>();
  if (!std::isfinite(factor))
  {
    throw AssemblyError("is damaged: a factor of a material is " + Shown(number));
  }
  return factor;
}

float Factor(const Json& json, const char* key, float preset)
{
  const auto found = json.find(key);
  return found == json.end() ? preset : FactorOf(*found);
}

/** Returns a factor that is a share. */
float Share(const Json& json, const char* key, float preset)
{
  return std::clamp(Factor(json, key, preset), 0.0f, 1.0f);
}

template <class Vector>
Vector Factors(const Json& json, const char* key, Vector preset)
{
  const Json& values = Member(json, key);
  const auto count = static_cast<std::size_t>(preset.length());
  if (values.size() == count && values.is_array())
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      preset[static_cast<int>(i)] = FactorOf(values[i]);
    }
  }
  return preset;
}

/** Returns a colour of reflection or transmission. */
glm::vec4 Color(const Json& json, const char* key)
{
  return glm::clamp(Factors(json, key, glm::vec4(1.0f)), 0.0f, 1.0f);
}

TextureUse ReadTextureUse(const Json& material, const char* key)
{
  const Json& json = Member(material, key);
  if (!json.is_object() || !json.contains("index"))
  {
    return {};
  }
  TextureUse use;
  use.Texture = json.at("index").get<int>();
  use.Coordinates = static_cast<int>(std::min<std::size_t>(Number(json, "texCoord", 0), 2));
  if (const Json* const transform = Extension(json, "KHR_texture_transform"))
  {
    use.Offset = Factors(*transform, "offset", use.Offset);
    use.Scale = Factors(*transform, "scale", use.Scale);
    use.Rotation = Factor(*transform, "rotation", 0.0f);
    use.Coordinates = static_cast<int>(std::min<std::size_t>(
      Number(*transform, "texCoord", static_cast<std::size_t>(use.Coordinates)), 2));
  }
  return use;
}

AlphaMode ReadAlphaMode(const Json& json)
{
  const std::string mode = json.value("alphaMode", "OPAQUE");
  return mode == "BLEND" ? AlphaMode::Blend : mode == "MASK" ? AlphaMode::Mask : AlphaMode::Opaque;
}

/**
 * KHR_materials_transmission: the base colour tints what is behind, so the opacity is what the light does not pass. The
 * cutoff is reduced as alpha is, so that the same holes stay.
 */
void ApplyTransmission(const Json& json, AssemblyMaterial& material)
{
  const Json* const transmission = Extension(json, "KHR_materials_transmission");
  const float factor = transmission ? Share(*transmission, "transmissionFactor", 0.0f) : 0.0f;
  if (factor > 0.0f)
  {
    const float opacity = 1.0f - factor * (1.0f - LEAST_OPACITY_OF_GLASS);
    material.IsAlphaUniform = material.Alpha == AlphaMode::Opaque;
    material.BaseColor.a = material.IsAlphaUniform ? opacity : opacity * material.BaseColor.a;
    material.AlphaCutoff *= opacity;
    material.Alpha = AlphaMode::Blend;
  }
}

void ApplyExtensions(const Json& json, AssemblyMaterial& material)
{
  material.IsUnlit = Extension(json, "KHR_materials_unlit") != nullptr;
  if (const Json* const strength = Extension(json, "KHR_materials_emissive_strength"))
  {
    material.Emission *= std::max(Factor(*strength, "emissiveStrength", 1.0f), 0.0f);
  }
  if (const Json* const refraction = Extension(json, "KHR_materials_ior"))
  {
    material.IndexOfRefraction = Factor(*refraction, "ior", 1.5f);
  }
  if (const Json* const specular = Extension(json, "KHR_materials_specular"))
  {
    material.Specular = Share(*specular, "specularFactor", 1.0f);
  }
  // The archived predecessor of the metallic-roughness model: its diffuse colour is a dielectric's base colour.
  if (const Json* const glossiness = Extension(json, "KHR_materials_pbrSpecularGlossiness"))
  {
    material.BaseColor = Color(*glossiness, "diffuseFactor");
    material.Metallic = 0.0f;
    material.Roughness = 1.0f - Share(*glossiness, "glossinessFactor", 1.0f);
    material.BaseColorTexture = ReadTextureUse(*glossiness, "diffuseTexture");
  }
  ApplyTransmission(json, material);
}

AssemblyMaterial ReadMaterial(const Json& json)
{
  AssemblyMaterial material;
  material.Name = NameOf(json);
  const Json& base = Member(json, "pbrMetallicRoughness");
  material.BaseColor = Color(base, "baseColorFactor");
  if (base.is_object())
  {
    material.Metallic = Share(base, "metallicFactor", 1.0f);
    material.Roughness = Share(base, "roughnessFactor", 1.0f);
  }
  material.Emission = glm::max(Factors(json, "emissiveFactor", material.Emission), 0.0f);
  material.Alpha = ReadAlphaMode(json);
  material.AlphaCutoff =
    material.Alpha == AlphaMode::Mask ? Factor(json, "alphaCutoff", 0.5f) : 0.0f;
  material.IsDoubleSided = json.value("doubleSided", false);
  material.BaseColorTexture = ReadTextureUse(base, "baseColorTexture");
  material.MetallicRoughnessTexture = ReadTextureUse(base, "metallicRoughnessTexture");
  material.NormalTexture = ReadTextureUse(json, "normalTexture");
  material.OcclusionTexture = ReadTextureUse(json, "occlusionTexture");
  material.EmissionTexture = ReadTextureUse(json, "emissiveTexture");
  if (material.NormalTexture.Texture != NO_INDEX)
  {
    material.NormalScale = Factor(json.at("normalTexture"), "scale", 1.0f);
  }
  if (material.OcclusionTexture.Texture != NO_INDEX)
  {
    material.OcclusionStrength = Factor(json.at("occlusionTexture"), "strength", 1.0f);
  }
  ApplyExtensions(json, material);
  return material;
}

AssemblyTexture ReadTexture(const GltfDocument& document, const Json& json)
{
  AssemblyTexture texture;
  texture.Image = json.contains("source") ? json.at("source").get<int>() : NO_INDEX;
  if (!json.contains("sampler"))
  {
    return texture;
  }
  const Json& sampler = document.Object("samplers", json.at("sampler").get<std::size_t>());
  const int smaller = sampler.value("minFilter", -1);
  texture.HasMipmaps = smaller != GLTF_NEAREST && smaller != GLTF_LINEAR;
  texture.IsSmooth = sampler.value("magFilter", static_cast<int>(GLTF_LINEAR)) != GLTF_NEAREST;
  texture.Repeats = sampler.value("wrapS", 0) != GLTF_CLAMP_TO_EDGE &&
    sampler.value("wrapT", 0) != GLTF_CLAMP_TO_EDGE;
  return texture;
}

bool BeginsWith(const std::vector<std::uint8_t>& bytes, std::initializer_list<std::uint8_t> first)
{
  return bytes.size() >= first.size() && std::equal(first.begin(), first.end(), bytes.begin());
}

std::string MimeTypeOf(const std::vector<std::uint8_t>& bytes)
{
  if (BeginsWith(bytes, { 0x89, 'P', 'N', 'G' }))
  {
    return "image/png";
  }
  return BeginsWith(bytes, { 0xff, 0xd8, 0xff }) ? "image/jpeg" : "";
}

/** Returns how notes call a picture: by its name, else by its file, else by its number. */
std::string CalledImage(const Json& json, std::size_t number)
{
  const std::string name = NameOf(json);
  const auto uri = json.find("uri");
  const bool hasFile = uri != json.end() && uri->is_string() &&
    uri->get_ref<const std::string&>().compare(0, 5, "data:") != 0;
  return !name.empty() ? name : hasFile ? OneLine(uri->get<std::string>()) : std::to_string(number);
}

void ReadBytes(const GltfDocument& document, const Json& json, AssemblyImage& image)
{
  if (json.contains("bufferView"))
  {
    const ByteView view = document.View(json.at("bufferView").get<std::size_t>());
    document.Spend(view.Size);
    image.Bytes.assign(view.Data, view.Data + view.Size);
  }
  else
  {
    image.Bytes = document.ReadUri(json.at("uri").get<std::string>());
  }
  image.MimeType = MimeTypeOf(image.Bytes);
}

/** Has textures of a picture that is not there have none. */
void LeaveOut(std::size_t image, Assembly& assembly)
{
  for (AssemblyTexture& texture : assembly.Textures)
  {
    texture.Image = texture.Image == static_cast<int>(image) ? NO_INDEX : texture.Image;
  }
  assembly.Notes.push_back(
    "picture '" + assembly.Images[image].Name + "' is missing: parts are shown without it");
}

/** Reads the pictures that materials use. Of others, which may be missing, there is but the name. */
void ReadImages(const GltfDocument& document, Assembly& assembly)
{
  const std::set<int> used = UsedImages(assembly);
  const Json& images = document.Objects("images");
  assembly.Images.resize(images.size());
  for (std::size_t i = 0; i < images.size(); ++i)
  {
    assembly.Images[i].Name = CalledImage(images[i], i);
    if (used.count(static_cast<int>(i)) == 0)
    {
      continue;
    }
    try
    {
      ReadBytes(document, images[i], assembly.Images[i]);
    }
    catch (const UriError&)
    {
      LeaveOut(i, assembly);
    }
  }
}
}

void ReadGltfMaterials(const GltfDocument& document, Assembly& assembly)
{
  for (const Json& texture : document.Objects("textures"))
  {
    assembly.Textures.push_back(ReadTexture(document, texture));
  }
  for (const Json& material : document.Objects("materials"))
  {
    assembly.Materials.push_back(ReadMaterial(material));
  }
  ReadImages(document, assembly);
}

}
