#include "GltfFiles.h"

#include <algorithm>

// Materials of glTF, and what is noted of them.
namespace
{

using namespace gltf_files;
using vitrine::AlphaMode;
using vitrine::Assembly;
using vitrine::AssemblyMaterial;

AssemblyMaterial MaterialOf(const Json& material)
{
  Gltf gltf;
  gltf.Add("materials", material);
  return Read(gltf).Materials[0];
}

/** A triangle of a material, with red vertices of an alpha of 1/4. */
Gltf ColoredTriangle(const Json& material)
{
  Gltf gltf;
  Json triangle = gltf.Triangle();
  const std::vector<float> colors = { 1, 0, 0, 0.25f, 1, 0, 0, 0.25f, 1, 0, 0, 0.25f };
  triangle["attributes"]["COLOR_0"] = gltf.AddAccessor("VEC4", Float, 3, colors);
  triangle["material"] = gltf.Add("materials", material);
  gltf.AddNode({ { "mesh", gltf.AddMesh(triangle) } });
  return gltf;
}

float VertexAlpha(const Json& material)
{
  return Read(ColoredTriangle(material)).Meshes[0].Geometries[0].Colors[1].a;
}

std::vector<std::string> NotesOf(const Json& material)
{
  return Read(ColoredTriangle(material)).Notes;
}

TEST(GltfMaterials, HaveTheFactorsOfTheFile)
{
  const AssemblyMaterial material = MaterialOf({ { "name", "red" },
    { "pbrMetallicRoughness",
      { { "baseColorFactor", { 1, 0.5, 0, 0.25 } }, { "metallicFactor", 0.5 },
        { "roughnessFactor", 0.125 } } },
    { "emissiveFactor", { 0, 0.5, 1 } }, { "alphaMode", "BLEND" }, { "doubleSided", true } });
  EXPECT_EQ(material.Name, "red");
  EXPECT_EQ(material.BaseColor, glm::vec4(1, 0.5, 0, 0.25));
  EXPECT_EQ(material.Metallic, 0.5f);
  EXPECT_EQ(material.Roughness, 0.125f);
  EXPECT_EQ(material.Emission, glm::vec3(0, 0.5, 1));
  EXPECT_EQ(material.Alpha, AlphaMode::Blend);
  EXPECT_EQ(material.AlphaCutoff, 0.0f);
  EXPECT_TRUE(material.IsDoubleSided);
}

TEST(GltfMaterials, HaveThePresetsOfGltf)
{
  const AssemblyMaterial material = MaterialOf(Json::object());
  EXPECT_EQ(material.BaseColor, glm::vec4(1));
  EXPECT_EQ(material.Metallic, 1.0f);
  EXPECT_EQ(material.Roughness, 1.0f);
  EXPECT_EQ(material.Emission, glm::vec3(0));
  EXPECT_EQ(material.Alpha, AlphaMode::Opaque);
  EXPECT_FALSE(material.IsDoubleSided);
  EXPECT_FALSE(material.IsUnlit);
  EXPECT_EQ(material.IndexOfRefraction, 1.5f);
  EXPECT_EQ(material.Specular, 1.0f);
}

TEST(GltfMaterials, AreKeptInTheirRange)
{
  const AssemblyMaterial material = MaterialOf({ { "alphaMode", "BLEND" },
    { "pbrMetallicRoughness",
      { { "baseColorFactor", { 2, -1, 0.5, 7 } }, { "metallicFactor", 3 },
        { "roughnessFactor", -1 } } },
    { "emissiveFactor", { -1, 0, 2 } } });
  EXPECT_EQ(material.BaseColor, glm::vec4(1, 0, 0.5, 1));
  EXPECT_EQ(material.Metallic, 1.0f);
  EXPECT_EQ(material.Roughness, 0.0f);
  EXPECT_EQ(material.Emission, glm::vec3(0, 0, 2));
}

TEST(GltfMaterials, AlphaCountsWhereTheModeSaysSo)
{
  const Json base = { { "baseColorFactor", { 1, 1, 1, 0.5 } } };
  EXPECT_EQ(MaterialOf({ { "pbrMetallicRoughness", base } }).BaseColor.a, 1.0f);
  EXPECT_EQ(
    MaterialOf({ { "pbrMetallicRoughness", base }, { "alphaMode", "MASK" } }).BaseColor.a, 0.5f);
  EXPECT_EQ(
    MaterialOf({ { "pbrMetallicRoughness", base }, { "alphaMode", "BLEND" } }).BaseColor.a, 0.5f);
  EXPECT_EQ(VertexAlpha(Json::object()), 1.0f);
  EXPECT_EQ(VertexAlpha({ { "alphaMode", "MASK" } }), 0.0f);
  EXPECT_EQ(VertexAlpha({ { "alphaMode", "MASK" }, { "alphaCutoff", 0.25 } }), 1.0f);
  EXPECT_EQ(VertexAlpha({ { "alphaMode", "BLEND" } }), 0.25f);
}

TEST(GltfMaterials, AlphaOfVerticesWithoutMaterialIsIgnored)
{
  Gltf gltf = ColoredTriangle(Json::object());
  gltf.Root["meshes"][0]["primitives"][0].erase("material");
  EXPECT_EQ(Read(gltf).Meshes[0].Geometries[0].Colors[0], glm::vec4(1, 0, 0, 1));
}

TEST(GltfMaterials, MasksKeepTheirCutoff)
{
  EXPECT_EQ(MaterialOf({ { "alphaMode", "MASK" } }).AlphaCutoff, 0.5f);
  const AssemblyMaterial material =
    MaterialOf({ { "alphaMode", "MASK" }, { "alphaCutoff", 0.75 } });
  EXPECT_EQ(material.Alpha, AlphaMode::Mask);
  EXPECT_EQ(material.AlphaCutoff, 0.75f);
}

Json Transmission(double factor)
{
  return { { "KHR_materials_transmission", { { "transmissionFactor", factor } } } };
}

TEST(GltfMaterials, TransmissionIsOpacity)
{
  const AssemblyMaterial material = MaterialOf({ { "extensions", Transmission(1.0) } });
  EXPECT_EQ(material.Alpha, AlphaMode::Blend);
  EXPECT_TRUE(material.IsAlphaUniform);
  EXPECT_FLOAT_EQ(material.BaseColor.a, 0.3f);
  EXPECT_FLOAT_EQ(MaterialOf({ { "extensions", Transmission(0.5) } }).BaseColor.a, 0.65f);
  EXPECT_EQ(MaterialOf({ { "extensions", Transmission(0.0) } }).Alpha, AlphaMode::Opaque);
}

TEST(GltfMaterials, TransmissionLeavesTheMeaningOfAlpha)
{
  EXPECT_EQ(VertexAlpha({ { "extensions", Transmission(1.0) } }), 1.0f);
  EXPECT_EQ(VertexAlpha({ { "alphaMode", "BLEND" }, { "extensions", Transmission(1.0) } }), 0.25f);
  const AssemblyMaterial mask =
    MaterialOf({ { "alphaMode", "MASK" }, { "extensions", Transmission(1.0) } });
  EXPECT_FLOAT_EQ(mask.BaseColor.a, 0.3f);
  EXPECT_FLOAT_EQ(mask.AlphaCutoff, 0.15f) << "half of the alpha, as it was";
  EXPECT_FALSE(mask.IsAlphaUniform);
}

TEST(GltfMaterials, ExtensionsAreRead)
{
  const AssemblyMaterial material = MaterialOf({ { "emissiveFactor", { 0.5, 0.25, 0 } },
    { "extensions",
      { { "KHR_materials_emissive_strength", { { "emissiveStrength", 8 } } },
        { "KHR_materials_unlit", Json::object() }, { "KHR_materials_ior", { { "ior", 1.25 } } },
        { "KHR_materials_specular", { { "specularFactor", 0.5 } } } } } });
  EXPECT_EQ(material.Emission, glm::vec3(4, 2, 0));
  EXPECT_TRUE(material.IsUnlit);
  EXPECT_EQ(material.IndexOfRefraction, 1.25f);
  EXPECT_EQ(material.Specular, 0.5f);
}

TEST(GltfMaterials, SpecularGlossinessIsADielectric)
{
  const AssemblyMaterial material = MaterialOf({ { "alphaMode", "BLEND" },
    { "extensions",
      { { "KHR_materials_pbrSpecularGlossiness",
        { { "diffuseFactor", { 0.5, 0.25, 0, 0.5 } }, { "glossinessFactor", 0.75 } } } } } });
  EXPECT_EQ(material.BaseColor, glm::vec4(0.5, 0.25, 0, 0.5));
  EXPECT_EQ(material.Metallic, 0.0f);
  EXPECT_EQ(material.Roughness, 0.25f);
}

TEST(GltfMaterials, TexturesHaveTheirTransforms)
{
  Gltf gltf;
  gltf.Add("images", { { "uri", "data:image/png;base64,iVBORw==" }, { "name", "picture" } });
  gltf.Add("samplers", { { "magFilter", 9728 }, { "minFilter", 9729 }, { "wrapS", 33071 } });
  gltf.Add("textures", { { "source", 0 }, { "sampler", 0 } });
  gltf.Add("textures", { { "source", 0 } });
  const Json transform = { { "offset", { 0.5, 0.25 } }, { "scale", { 2, 3 } }, { "rotation", 1.5 },
    { "texCoord", 1 } };
  gltf.Add("materials",
    { { "pbrMetallicRoughness",
        { { "baseColorTexture",
          { { "index", 1 }, { "extensions", { { "KHR_texture_transform", transform } } } } } } },
      { "normalTexture", { { "index", 0 }, { "scale", 0.5 }, { "texCoord", 7 } } },
      { "occlusionTexture", { { "index", 0 }, { "strength", 0.25 } } } });
  const Assembly assembly = Read(gltf);
  const AssemblyMaterial& material = assembly.Materials[0];
  EXPECT_EQ(material.BaseColorTexture.Texture, 1);
  EXPECT_EQ(material.BaseColorTexture.Coordinates, 1);
  EXPECT_EQ(material.BaseColorTexture.Offset, glm::vec2(0.5, 0.25));
  EXPECT_EQ(material.BaseColorTexture.Scale, glm::vec2(2, 3));
  EXPECT_EQ(material.BaseColorTexture.Rotation, 1.5f);
  EXPECT_EQ(material.NormalTexture.Coordinates, 2);
  EXPECT_EQ(material.NormalScale, 0.5f);
  EXPECT_EQ(material.OcclusionStrength, 0.25f);
  EXPECT_EQ(material.EmissionTexture.Texture, vitrine::NO_INDEX);
  EXPECT_FALSE(assembly.Textures[0].IsSmooth);
  EXPECT_FALSE(assembly.Textures[0].HasMipmaps);
  EXPECT_FALSE(assembly.Textures[0].Repeats);
  EXPECT_TRUE(assembly.Textures[1].IsSmooth && assembly.Textures[1].HasMipmaps &&
    assembly.Textures[1].Repeats);
  EXPECT_EQ(assembly.Images[0].MimeType, "image/png");
  EXPECT_EQ(assembly.Images[0].Name, "picture");
}

TEST(GltfMaterials, NotesAreOfExtensionsWithAnEffect)
{
  EXPECT_EQ(NotesOf({ { "extensions", Transmission(0.0) } }), std::vector<std::string>{});
  EXPECT_EQ(NotesOf({ { "extensions", Transmission(0.5) } }),
    std::vector<std::string>{
      "transmission is shown as opacity, without refraction (KHR_materials_transmission)" });
  EXPECT_EQ(NotesOf({ { "extensions", { { "KHR_materials_clearcoat", Json::object() } } } }),
    std::vector<std::string>{});
  EXPECT_EQ(NotesOf({ { "extensions", { { "KHR_materials_unlit", Json::object() } } } }),
    std::vector<std::string>{});
  EXPECT_EQ(NotesOf({ { "extensions", { { "ABC_new", Json::object() } } } }),
    std::vector<std::string>{ "the extension ABC_new is not read" });
}

TEST(GltfMaterials, NotesAreOfWhatTheSceneUses)
{
  Gltf gltf = ColoredTriangle(Json::object());
  gltf.Add("materials", { { "extensions", Transmission(1.0) } });
  gltf.Root["extensionsUsed"] = { "KHR_materials_transmission", "KHR_lights_punctual" };
  EXPECT_EQ(Read(gltf).Notes, std::vector<std::string>{});
  gltf.Root["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  gltf.Root["animations"] = Json::array({ Json::object() });
  EXPECT_EQ(Read(gltf).Notes,
    (std::vector<std::string>{
      "animations are not played", "lights of the file are left out (KHR_lights_punctual)" }));
}

TEST(GltfMaterials, PicturesThatAreMissingAreNotedIfTheyAreUsed)
{
  Gltf gltf = ColoredTriangle({ { "normalTexture", { { "index", 0 } } } });
  gltf.Add("images", { { "uri", "gone.png" } });
  gltf.Add("images", { { "uri", "data:;base64,A*" }, { "name", "starred" } });
  gltf.Add("images", { { "uri", "https://example.org/unused.png" } });
  gltf.Add("textures", { { "source", 0 } });
  gltf.Add("textures", { { "source", 1 } });
  EXPECT_EQ(Read(gltf).Notes,
    std::vector<std::string>{ "picture 'gone.png' is missing: parts are shown without it" });
  EXPECT_EQ(Read(gltf).Textures[0].Image, vitrine::NO_INDEX);
  EXPECT_EQ(Read(gltf).Textures[1].Image, 1);
  gltf.Root["materials"][0]["normalTexture"]["index"] = 1;
  EXPECT_EQ(Read(gltf).Notes,
    std::vector<std::string>{ "picture 'starred' is missing: parts are shown without it" });
  gltf.Root["textures"][1]["source"] = 2;
  EXPECT_THROW(Read(gltf), vitrine::AssemblyError);
}

TEST(GltfMaterials, TexturesInKtxAreNotedUnlessThereIsAnother)
{
  Gltf gltf =
    ColoredTriangle({ { "pbrMetallicRoughness", { { "baseColorTexture", { { "index", 0 } } } } } });
  gltf.Add("images", { { "uri", "data:;base64,iVBORw==" } });
  gltf.Add("textures", { { "extensions", { { "KHR_texture_basisu", { { "source", 0 } } } } } });
  EXPECT_EQ(Read(gltf).Notes,
    std::vector<std::string>{
      "textures in KTX2 are not read (KHR_texture_basisu); convert them to PNG" });
  EXPECT_EQ(Read(gltf).Textures[0].Image, vitrine::NO_INDEX);
  gltf.Root["textures"][0]["source"] = 0;
  EXPECT_EQ(Read(gltf).Notes, std::vector<std::string>{});
}

}
