#include "assembly/AssemblyLooks.h"

#include "assembly/AssemblyTextures.h"
#include "assembly/ColorTextures.h"
#include "vtkAssemblyActors.h"

#include "vtkInformationDoubleKey.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkProp.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

using namespace vitrine;

namespace
{
void Note(Assembly& assembly, const std::string& text)
{
  if (std::find(assembly.Notes.begin(), assembly.Notes.end(), text) == assembly.Notes.end())
  {
    assembly.Notes.push_back(text);
  }
}

bool IsSame(const TextureUse& a, const TextureUse& b)
{
  return a.Coordinates == b.Coordinates && a.Offset == b.Offset && a.Scale == b.Scale &&
    a.Rotation == b.Rotation;
}

/** KHR_texture_transform, and then upside down, as VTK's images begin at the bottom. Row by row. */
vtkSmartPointer<vtkInformation> MakeTextureTransform(const TextureUse& use)
{
  const double c = std::cos(use.Rotation);
  const double s = std::sin(use.Rotation);
  const double rows[16] = { c * use.Scale.x, s * use.Scale.y, 0, use.Offset.x, //
    s * use.Scale.x, -c * use.Scale.y, 0, 1.0 - use.Offset.y,                  //
    0, 0, 1, 0,                                                                //
    0, 0, 0, 1 };
  auto keys = vtkSmartPointer<vtkInformation>::New();
  keys->Set(vtkProp::GeneralTextureTransform(), rows, 16);
  return keys;
}

/** The texture whose coordinates VTK uses for all textures of a material. */
const TextureUse* FirstTexture(const AssemblyMaterial& material)
{
  for (const TextureUse* use : { &material.BaseColorTexture, &material.MetallicRoughnessTexture,
         &material.NormalTexture, &material.EmissionTexture, &material.OcclusionTexture })
  {
    if (use->Texture != NO_INDEX)
    {
      return use;
    }
  }
  return nullptr;
}

/** Leaves out textures whose coordinates are not those of the first. */
AssemblyMaterial KeepFirstCoordinates(const AssemblyMaterial& material, Assembly& assembly)
{
  AssemblyMaterial kept = material;
  const TextureUse* const first = FirstTexture(material);
  for (TextureUse* use : { &kept.BaseColorTexture, &kept.MetallicRoughnessTexture,
         &kept.NormalTexture, &kept.EmissionTexture, &kept.OcclusionTexture })
  {
    if (use->Texture != NO_INDEX && (!IsSame(*use, *first) || use->Coordinates != 0))
    {
      Note(assembly,
        "textures with coordinates of their own, beside others or of TEXCOORD_1, are left out");
      use->Texture = NO_INDEX;
    }
  }
  return kept;
}

/** KHR_materials_specular as an index of refraction that reflects as much at right angles. */
double IndexOfRefraction(const AssemblyMaterial& material)
{
  const double ior = std::max(1.0, static_cast<double>(material.IndexOfRefraction));
  const double amplitude =
    (ior - 1.0) / (ior + 1.0) * std::sqrt(std::clamp(material.Specular, 0.0f, 1.0f));
  return (1.0 + amplitude) / (1.0 - amplitude);
}

/** Alpha of a mask is a hole or opaque. Its texture makes the holes, where there is one. */
double OpacityOf(const AssemblyMaterial& material)
{
  if (material.Alpha != AlphaMode::Mask)
  {
    return std::clamp(material.BaseColor.a, 0.0f, 1.0f);
  }
  const bool hasTexture = material.BaseColorTexture.Texture != NO_INDEX;
  return hasTexture || material.BaseColor.a >= material.AlphaCutoff ? 1.0 : 0.0;
}

/** The cutoff of a texture's alpha, which is multiplied by that of the material. */
double CutoffOf(const AssemblyMaterial& material)
{
  return material.AlphaCutoff / std::max(material.BaseColor.a, 1e-6f);
}

/** Adds how the alpha of the colour's texture counts. */
void SetAlphaKey(const AssemblyMaterial& material, vtkInformation* keys)
{
  if (material.AlphaCutoff > 0.0f)
  {
    keys->Set(vtkAssemblyActors::ALPHA_CUTOFF(), CutoffOf(material));
  }
  else if (material.Alpha != AlphaMode::Blend || material.IsAlphaUniform)
  {
    keys->Set(vtkAssemblyActors::ALPHA_CUTOFF(), 0.0);
  }
}

void SetFactors(const AssemblyMaterial& material, vtkProperty* property)
{
  property->SetInterpolationToPBR();
  double color[3] = { material.BaseColor.r, material.BaseColor.g, material.BaseColor.b };
  if (material.IsUnlit)
  {
    // Mappers do not convert colours of unlit parts to sRGB.
    std::transform(
      color, color + 3, color, [](double value) { return std::pow(value, 1.0 / GAMMA); });
  }
  property->SetLighting(!material.IsUnlit);
  if (material.IsUnlit)
  {
    property->SetInterpolationToGouraud(); // VTK 9.6 has no textures of one's own names in PBR.
  }
  property->SetColor(color);
  property->SetOpacity(OpacityOf(material));
  property->SetMetallic(material.Metallic);
  property->SetRoughness(material.Roughness);
  property->SetEmissiveFactor(material.Emission.r, material.Emission.g, material.Emission.b);
  property->SetBackfaceCulling(!material.IsDoubleSided);
  if (material.IndexOfRefraction != 1.5f || material.Specular != 1.0f)
  {
    property->SetBaseIOR(IndexOfRefraction(material));
  }
}

/** VTK reads the base colour's texture for lit parts alone. All textures of names of one's own are multiplied in. */
void SetUnlitTexture(
  const AssemblyMaterial& material, AssemblyTextures& textures, vtkProperty* property)
{
  const AlphaMode mode = material.IsAlphaUniform ? AlphaMode::Opaque : material.Alpha;
  if (vtkSmartPointer<vtkTexture> color =
        textures.ShownColors(material.BaseColorTexture, mode, CutoffOf(material)))
  {
    property->SetTexture(UNLIT_COLOR_TEXTURE, color);
  }
}

void SetTextures(
  const AssemblyMaterial& material, AssemblyTextures& textures, vtkProperty* property)
{
  if (material.IsUnlit)
  {
    SetUnlitTexture(material, textures, property);
    return;
  }
  if (vtkSmartPointer<vtkTexture> color = textures.Colors(material.BaseColorTexture))
  {
    property->SetBaseColorTexture(color);
  }
  if (vtkSmartPointer<vtkTexture> merged = textures.OcclusionRoughnessMetalness(
        material.MetallicRoughnessTexture, material.OcclusionTexture))
  {
    property->SetORMTexture(merged);
    property->SetOcclusionStrength(material.OcclusionStrength);
  }
  if (vtkSmartPointer<vtkTexture> emission = textures.Colors(material.EmissionTexture))
  {
    property->SetEmissiveTexture(emission);
  }
  if (vtkSmartPointer<vtkTexture> normals = textures.Numbers(material.NormalTexture))
  {
    property->SetNormalTexture(normals);
    property->SetNormalScale(material.NormalScale);
  }
}

void NoteWhatIsLost(const AssemblyMaterial& material, vtkProperty* property, Assembly& assembly)
{
  const bool glows = material.Emission != glm::vec3(0.0f);
  if (glows && material.EmissionTexture.Texture == NO_INDEX && !material.IsUnlit)
  {
    Note(assembly, "emission of materials without a texture of it is not shown");
  }
  const bool hasNumbers = material.OcclusionTexture.Texture != NO_INDEX ||
    material.MetallicRoughnessTexture.Texture != NO_INDEX;
  if (hasNumbers && !material.IsUnlit && !property->GetTexture("materialTex"))
  {
    Note(assembly,
      "textures of occlusion without one of roughness, and those of roughness in grey, are left "
      "out");
  }
}

AssemblyLook MakeLook(
  const AssemblyMaterial& source, AssemblyTextures& textures, Assembly& assembly)
{
  const AssemblyMaterial material = KeepFirstCoordinates(source, assembly);
  AssemblyLook look;
  look.Name = material.Name;
  look.Property = vtkSmartPointer<vtkProperty>::New();
  look.Property->SetMaterialName(material.Name.c_str());
  SetFactors(material, look.Property);
  SetTextures(material, textures, look.Property);
  if (const TextureUse* const first = FirstTexture(material))
  {
    look.Keys = MakeTextureTransform(*first);
    SetAlphaKey(material, look.Keys);
  }
  NoteWhatIsLost(material, look.Property, assembly);
  look.IsTranslucent = material.Alpha == AlphaMode::Blend ||
    (material.IsUnlit && material.Alpha == AlphaMode::Mask &&
      material.BaseColorTexture.Texture != NO_INDEX);
  return look;
}
}

std::vector<AssemblyLook> MakeAssemblyLooks(Assembly& assembly)
{
  AssemblyTextures textures(assembly);
  std::vector<AssemblyLook> looks;
  for (const AssemblyMaterial& material : assembly.Materials)
  {
    looks.push_back(MakeLook(material, textures, assembly));
  }
  AssemblyLook standard;
  standard.Property = vtkSmartPointer<vtkProperty>::New();
  looks.push_back(standard);
  return looks;
}
