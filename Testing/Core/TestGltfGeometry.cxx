#include "GltfFiles.h"

#include <limits>

// Meshes of glTF: types of numbers, sparse accessors, kinds of cells, skins and morph targets.
namespace
{

using namespace gltf_files;
using vitrine::Assembly;
using vitrine::AssemblyGeometry;
using vitrine::CellKind;
using Indices = std::vector<std::uint32_t>;

constexpr float Infinity = std::numeric_limits<float>::infinity();

AssemblyGeometry GeometryOf(Gltf& gltf, const Json& primitive)
{
  gltf.AddNode({ { "mesh", gltf.AddMesh(primitive) } });
  return Read(gltf).Meshes[0].Geometries[0];
}

/** The cells of five points along a line, by a mode and indices. */
Indices CellsOf(int mode, const std::vector<std::uint16_t>& indices = {})
{
  Gltf gltf;
  const std::vector<float> points = { 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0 };
  Json primitive = { { "mode", mode },
    { "attributes", { { "POSITION", gltf.AddAccessor("VEC3", Float, 5, points) } } } };
  if (!indices.empty())
  {
    primitive["indices"] = gltf.AddAccessor("SCALAR", UnsignedShort, indices.size(), indices);
  }
  return GeometryOf(gltf, primitive).Indices;
}

TEST(GltfGeometry, HasTheCellsOfItsMode)
{
  EXPECT_EQ(CellsOf(0), (Indices{ 0, 1, 2, 3, 4 }));
  EXPECT_EQ(CellsOf(1), (Indices{ 0, 1, 2, 3 })) << "lines; one point is left";
  EXPECT_EQ(CellsOf(2), (Indices{ 0, 1, 1, 2, 2, 3, 3, 4, 4, 0 })) << "a loop";
  EXPECT_EQ(CellsOf(3), (Indices{ 0, 1, 1, 2, 2, 3, 3, 4 })) << "a strip";
  EXPECT_EQ(CellsOf(4, { 4, 3, 2, 1, 0, 1 }), (Indices{ 4, 3, 2, 1, 0, 1 })) << "triangles";
  EXPECT_EQ(CellsOf(5), (Indices{ 0, 1, 2, 1, 3, 2, 2, 3, 4 })) << "a strip of triangles";
  EXPECT_EQ(CellsOf(6), (Indices{ 0, 1, 2, 0, 2, 3, 0, 3, 4 })) << "a fan";
}

TEST(GltfGeometry, LeavesOutVerticesWithoutCells)
{
  Gltf gltf;
  const std::vector<float> points = { 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0 };
  const std::vector<std::uint8_t> indices = { 4, 1, 2 };
  const AssemblyGeometry geometry = GeometryOf(gltf,
    { { "attributes",
        { { "POSITION", gltf.AddAccessor("VEC3", Float, 5, points) },
          { "NORMAL", gltf.AddAccessor("VEC3", Float, 5, points) } } },
      { "indices", gltf.AddAccessor("SCALAR", UnsignedByte, 3, indices) } });
  EXPECT_EQ(geometry.Kind, CellKind::Triangles);
  EXPECT_EQ(geometry.Positions, (std::vector<glm::vec3>{ { 1, 0, 0 }, { 2, 0, 0 }, { 4, 0, 0 } }));
  EXPECT_EQ(geometry.Normals, geometry.Positions);
  EXPECT_EQ(geometry.Indices, (Indices{ 2, 0, 1 }));
}

TEST(GltfGeometry, ReadsQuantizedNumbers)
{
  Gltf gltf;
  const std::vector<std::uint16_t> positions = { 0, 1, 2, 0, 300, 0, 0, 0, 0, 0, 40000,
    0 }; // each of 8 bytes
  const std::vector<std::int8_t> normals = { 127, -127, -128, 0, 64, 0, 0, 0, 0, 0, 127, 0 };
  const std::vector<std::uint8_t> colors = { 255, 0, 51, 0, 0, 0, 255, 255, 255 };
  const std::vector<std::uint16_t> coordinates = { 65535, 0, 13107, 0, 0, 0 };
  gltf.AddView(BytesOf(positions), { { "byteStride", 8 } });
  gltf.AddView(BytesOf(normals), { { "byteStride", 4 } });
  gltf.Add("accessors",
    { { "bufferView", 0 }, { "type", "VEC3" }, { "componentType", UnsignedShort },
      { "count", 3 } });
  gltf.Add("accessors",
    { { "bufferView", 1 }, { "type", "VEC3" }, { "componentType", Byte }, { "count", 3 },
      { "normalized", true } });
  const Json normalized = { { "normalized", true } };
  gltf.Root["extensionsRequired"] = Json::array({ "KHR_mesh_quantization" });
  const AssemblyGeometry geometry = GeometryOf(gltf,
    { { "attributes",
      { { "POSITION", 0 }, { "NORMAL", 1 },
        { "COLOR_0", gltf.AddAccessor("VEC3", UnsignedByte, 3, colors, normalized) },
        { "TEXCOORD_0",
          gltf.AddAccessor("VEC2", UnsignedShort, 3, coordinates, normalized) } } } });
  EXPECT_EQ(
    geometry.Positions, (std::vector<glm::vec3>{ { 0, 1, 2 }, { 300, 0, 0 }, { 0, 0, 40000 } }));
  EXPECT_EQ(geometry.Normals[0], glm::vec3(1, -1, -1)) << "-128 stands for -1 too";
  EXPECT_FLOAT_EQ(geometry.Normals[1].x, 64.0f / 127.0f);
  EXPECT_EQ(geometry.Colors[0].r, 1.0f);
  EXPECT_FLOAT_EQ(geometry.Colors[0].b, 0.2f);
  EXPECT_EQ(geometry.Colors[0].a, 1.0f);
  EXPECT_EQ(geometry.TexCoords[0][0], glm::vec2(1, 0));
  EXPECT_FLOAT_EQ(geometry.TexCoords[0][1].x, 0.2f);
}

Json Sparse(Gltf& gltf, const std::vector<std::uint16_t>& places, const std::vector<float>& values)
{
  return { { "count", places.size() },
    { "indices",
      { { "bufferView", gltf.AddView(BytesOf(places)) }, { "componentType", UnsignedShort } } },
    { "values", { { "bufferView", gltf.AddView(BytesOf(values)) } } } };
}

TEST(GltfGeometry, SparseElementsReplaceOthers)
{
  Gltf gltf;
  Json triangle = gltf.Triangle();
  gltf.Root["accessors"][0]["sparse"] = Sparse(gltf, { 1, 2 }, { 7, 8, 9, 4, 5, 6 });
  EXPECT_EQ(GeometryOf(gltf, triangle).Positions,
    (std::vector<glm::vec3>{ { 0, 0, 0 }, { 7, 8, 9 }, { 4, 5, 6 } }));
}

TEST(GltfGeometry, SparseElementsReplaceZerosWithoutAView)
{
  Gltf gltf;
  Json triangle = gltf.Triangle();
  gltf.Root["accessors"][0].erase("bufferView");
  EXPECT_EQ(GeometryOf(gltf, triangle).Positions, std::vector<glm::vec3>(3, glm::vec3(0)));
  gltf.Root["accessors"][0]["sparse"] = Sparse(gltf, { 1 }, { 7, 8, 9 });
  EXPECT_EQ(GeometryOf(gltf, triangle).Positions,
    (std::vector<glm::vec3>{ { 0, 0, 0 }, { 7, 8, 9 }, { 0, 0, 0 } }));
}

TEST(GltfGeometry, MorphTargetsAreAtRest)
{
  Gltf gltf;
  Json triangle = gltf.Triangle();
  const std::vector<float> moved = { 0, 0, 4, 0, 0, 4, 0, 0, 4 };
  const int target = gltf.AddAccessor("VEC3", Float, 3, moved);
  triangle["targets"] = Json::array({ { { "POSITION", target } }, { { "POSITION", target } } });
  const int mesh = gltf.AddMesh(triangle);
  gltf.Root["meshes"][0]["weights"] = { 0.5, 0.25 };
  gltf.AddNode({ { "mesh", mesh } });
  gltf.AddNode({ { "mesh", mesh }, { "weights", { 0, 1 } } });
  gltf.AddNode({ { "mesh", mesh } });
  const Assembly assembly = Read(gltf);
  ASSERT_EQ(assembly.Meshes.size(), 2u) << "nodes of equal weights share their geometry";
  EXPECT_EQ(assembly.Nodes[0].Mesh, assembly.Nodes[2].Mesh);
  EXPECT_EQ(assembly.Meshes[0].Geometries[0].Positions[1], glm::vec3(1, 0, 3));
  EXPECT_EQ(assembly.Meshes[1].Geometries[0].Positions[1], glm::vec3(1, 0, 4));
}

/** A triangle in node 1, with two joints: node 0 moves by 10 along x, and node 2 is changed as given. */
Gltf Skinned(const std::vector<float>& weights, const Json& secondJoint)
{
  Gltf gltf;
  Json triangle = gltf.Triangle();
  const std::vector<float> normals = { 0, 0, 1, 0, 0, 1, 0, 1, 0 };
  const std::vector<std::uint8_t> joints = { 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0 };
  triangle["attributes"]["NORMAL"] = gltf.AddAccessor("VEC3", Float, 3, normals);
  triangle["attributes"]["JOINTS_0"] = gltf.AddAccessor("VEC4", UnsignedByte, 3, joints);
  triangle["attributes"]["WEIGHTS_0"] = gltf.AddAccessor("VEC4", Float, 3, weights);
  gltf.AddNode({ { "translation", { 10, 0, 0 } } });
  gltf.AddNode(
    { { "mesh", gltf.AddMesh(triangle) }, { "skin", 0 }, { "translation", { 5, 5, 5 } } });
  gltf.AddNode(secondJoint);
  gltf.Add("skins", { { "joints", { 0, 2 } } });
  return gltf;
}

TEST(GltfGeometry, SkinsMoveVerticesByTheirJoints)
{
  const Gltf gltf = Skinned({ 1, 0, 0, 0, 0.5, 0.5, 0, 0, 0, 1, 0, 0 },
    { { "translation", { 0, 2, 0 } }, { "scale", { 1, 3, 1 } } });
  const Assembly assembly = Read(gltf);
  const AssemblyGeometry& geometry = assembly.Meshes[0].Geometries[0];
  EXPECT_EQ(geometry.Positions, (std::vector<glm::vec3>{ { 10, 0, 0 }, { 6, 1, 0 }, { 0, 5, 0 } }));
  // The place of the node itself does not count.
  ASSERT_EQ(assembly.Nodes[1].Instances.size(), 1u);
  EXPECT_EQ(assembly.Nodes[1].Transform * assembly.Nodes[1].Instances[0], glm::dmat4(1.0));
}

TEST(GltfGeometry, SkinsAreBoundByInverseMatrices)
{
  Gltf gltf = Skinned({ 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0 }, Json::object());
  std::vector<float> matrices = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -4, 0, 0, 1 };
  matrices.insert(matrices.end(), { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 });
  gltf.Root["skins"][0]["inverseBindMatrices"] = gltf.AddAccessor("MAT4", Float, 2, matrices);
  EXPECT_EQ(Read(gltf).Meshes[0].Geometries[0].Positions[0], glm::vec3(6, 0, 0));
}

TEST(GltfGeometry, WeightsOfSkinsAreShares)
{
  const Assembly assembly =
    Read(Skinned({ 2, 0, 0, 0, 0.25, 0.25, 0, 0, 0, 0, 0, 0 }, { { "translation", { 0, 2, 0 } } }));
  EXPECT_EQ(assembly.Meshes[0].Geometries[0].Positions,
    (std::vector<glm::vec3>{ { 10, 0, 0 }, { 6, 1, 0 }, { 0, 1, 0 } }))
    << "a vertex without weights stays";
}

TEST(GltfGeometry, SkinsMayHaveNoInverse)
{
  const Assembly assembly =
    Read(Skinned({ 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0 }, { { "scale", { 2, 2, 0 } } }));
  const AssemblyGeometry& geometry = assembly.Meshes[0].Geometries[0];
  EXPECT_EQ(geometry.Positions, (std::vector<glm::vec3>{ { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 } }));
  EXPECT_EQ(geometry.Normals, (std::vector<glm::vec3>{ { 0, 0, 1 }, { 0, 0, 1 }, { 0, 1, 0 } }));
}

TEST(GltfGeometry, MirroredSkinsTurnTheirNormals)
{
  const Assembly assembly =
    Read(Skinned({ 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0 }, { { "scale", { 1, -4, 1 } } }));
  EXPECT_EQ(assembly.Meshes[0].Geometries[0].Normals,
    (std::vector<glm::vec3>{ { 0, 0, 1 }, { 0, 0, 1 }, { 0, -1, 0 } }));
}

TEST(GltfGeometry, SkinsOfNodesWithoutSizeAreNoted)
{
  Gltf gltf = Skinned({ 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0 }, Json::object());
  gltf.Root["nodes"][1]["scale"] = { 1, 0, 1 };
  const Assembly assembly = Read(gltf);
  EXPECT_EQ(assembly.Nodes[1].Mesh, vitrine::NO_INDEX);
  ASSERT_EQ(assembly.Notes.size(), 1u);
  EXPECT_NE(assembly.Notes[0].find("is scaled to 0"), std::string::npos);
}

TEST(GltfGeometry, LeavesOutDirectionsThatAreNotFinite)
{
  Gltf gltf;
  Json triangle = gltf.Triangle();
  const std::vector<float> normals = { 0, 0, 1, 0, 0, Infinity, 0, 0, 1 };
  const std::vector<float> coordinates = { 0, 1, Infinity, 0, 1, 1 };
  const std::vector<float> colors = { 2, -1, -Infinity, 0, std::nanf(""), Infinity, 0, 0, 1 };
  triangle["attributes"]["NORMAL"] = gltf.AddAccessor("VEC3", Float, 3, normals);
  triangle["attributes"]["TEXCOORD_1"] = gltf.AddAccessor("VEC2", Float, 3, coordinates);
  triangle["attributes"]["COLOR_0"] = gltf.AddAccessor("VEC3", Float, 3, colors);
  const AssemblyGeometry geometry = GeometryOf(gltf, triangle);
  EXPECT_TRUE(geometry.Normals.empty());
  EXPECT_EQ(geometry.TexCoords[1], (std::vector<glm::vec2>{ { 0, 1 }, { 0, 0 }, { 1, 1 } }));
  EXPECT_EQ(
    geometry.Colors, (std::vector<glm::vec4>{ { 1, 0, 0, 1 }, { 0, 0, 1, 1 }, { 0, 0, 1, 1 } }));
}

TEST(GltfGeometry, BuffersMayBeFilesAndDataUris)
{
  Gltf gltf = OneTriangle();
  const Folder folder;
  folder.Write("bytes of it.bin", { gltf.Binary.begin(), gltf.Binary.end() });
  gltf.Root["buffers"] =
    Json::array({ { { "uri", "bytes%20of%20it.bin" }, { "byteLength", gltf.Binary.size() } } });
  const Assembly beside = vitrine::ReadGltf(folder.Write("a.gltf", gltf.Root.dump()));
  EXPECT_EQ(beside.Meshes[0].Geometries[0].Positions[2], glm::vec3(0, 1, 0));
  // 36 bytes: zeros, but for 1 as the fourth and the eighth float
  gltf.Root["buffers"][0]["uri"] =
    "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
  const Assembly within = Read(gltf.Root.dump());
  EXPECT_EQ(within.Meshes[0].Geometries[0].Positions, beside.Meshes[0].Geometries[0].Positions);
}

TEST(GltfGeometry, TextMayEndInZeros)
{
  EXPECT_TRUE(
    Read(Glb(Chunk("JSON", std::string(R"({"asset":{"version":"2.0"}})") + '\0'))).Nodes.empty());
}

}
