#include "GltfFiles.h"

#include <cstdlib>
#include <limits>

// Trees of glTF: nodes, names, places, instances and scenes.
namespace
{

using namespace gltf_files;
using vitrine::Assembly;
using vitrine::AssemblyError;
using vitrine::AssemblyNode;
using vitrine::NO_INDEX;

glm::dvec3 Moved(const glm::dmat4& place, const glm::dvec3& point)
{
  return glm::dvec3(place * glm::dvec4(point, 1.0));
}

void ExpectNear(const glm::dvec3& found, const glm::dvec3& expected)
{
  EXPECT_NEAR(glm::distance(found, expected), 0.0, 1e-6)
    << found.x << ", " << found.y << ", " << found.z;
}

TEST(GltfTree, HasNamesAndEachNodeBeforeItsChildren)
{
  Gltf gltf;
  gltf.AddNode({ { "name", "leaf" }, { "mesh", gltf.AddMesh(gltf.Triangle()) } });
  gltf.AddNode({ { "name", "left" }, { "children", { 0 } } });
  gltf.AddNode({ { "name", "root" }, { "children", { 1, 3 } } });
  gltf.AddNode({ { "name", "right\nside" } });
  const Assembly assembly = Read(gltf);
  ASSERT_EQ(assembly.Roots.size(), 1u);
  const AssemblyNode& root = assembly.Nodes[static_cast<std::size_t>(assembly.Roots[0])];
  EXPECT_EQ(root.Name, "root");
  ASSERT_EQ(root.Children.size(), 2u);
  const AssemblyNode& left = assembly.Nodes[static_cast<std::size_t>(root.Children[0])];
  EXPECT_EQ(left.Name, "left");
  EXPECT_EQ(assembly.Nodes[static_cast<std::size_t>(root.Children[1])].Name, "right side");
  ASSERT_EQ(left.Children.size(), 1u);
  EXPECT_EQ(assembly.Nodes[static_cast<std::size_t>(left.Children[0])].Name, "leaf");
  EXPECT_EQ(assembly.Nodes[static_cast<std::size_t>(left.Children[0])].Mesh, 0);
  EXPECT_EQ(left.Mesh, NO_INDEX);
  for (std::size_t i = 0; i < assembly.Nodes.size(); ++i)
  {
    for (const int child : assembly.Nodes[i].Children)
    {
      EXPECT_GT(child, static_cast<int>(i));
    }
  }
}

TEST(GltfTree, LongNamesEndBetweenCharacters)
{
  Gltf gltf = OneTriangle();
  std::string name(999, 'a');
  gltf.Root["nodes"][0]["name"] = name + "\xc3\xa4";
  EXPECT_EQ(Read(gltf).Nodes[0].Name, name);
}

TEST(GltfTree, MayBeDeep)
{
  Gltf gltf = OneTriangle();
  for (int i = 0; i < 999; ++i)
  {
    gltf.AddNode({ { "children", Json::array({ i }) } });
  }
  EXPECT_EQ(Read(gltf).Nodes.size(), 1000u);
}

TEST(GltfTree, PlacesAreProductsOfTranslationRotationAndScale)
{
  Gltf gltf;
  const double half = std::sqrt(0.5);
  gltf.AddNode({ { "translation", { 1, 2, 3 } }, { "rotation", { 0, 0, half, half } },
    { "scale", { 2, 3, 4 } } });
  // x (2) turns to y, y (3) to -x
  ExpectNear(Moved(Read(gltf).Nodes[0].Transform, { 1, 1, 1 }), { -2, 4, 7 });
}

TEST(GltfTree, RotationsAreOfUnitLength)
{
  Gltf gltf;
  gltf.AddNode({ { "rotation", { 0, 0, 2, 2 } } });
  gltf.AddNode({ { "rotation", { 0, 0, 0, 0 } } });
  const Assembly assembly = Read(gltf);
  ExpectNear(Moved(assembly.Nodes[0].Transform, { 1, 0, 0 }), { 0, 1, 0 });
  ExpectNear(Moved(assembly.Nodes[1].Transform, { 1, 2, 3 }), { 1, 2, 3 });
}

TEST(GltfTree, MatricesAreColumnByColumn)
{
  Gltf gltf;
  gltf.AddNode({ { "matrix", { 0, 2, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1 } } });
  ExpectNear(Moved(Read(gltf).Nodes[0].Transform, { 1, 10, 100 }), { 15, 8, 107 });
}

TEST(GltfTree, NegativeScalesStay)
{
  Gltf gltf;
  gltf.AddNode({ { "scale", { -1, 1, 1 } } });
  gltf.AddNode({ { "scale", { -2, -2, -2 } } });
  const Assembly assembly = Read(gltf);
  EXPECT_EQ(glm::determinant(assembly.Nodes[0].Transform), -1.0);
  EXPECT_EQ(glm::determinant(assembly.Nodes[1].Transform), -8.0);
}

TEST(GltfTree, NodesShareGeometry)
{
  Gltf gltf;
  const int mesh = gltf.AddMesh(gltf.Triangle());
  for (int i = 0; i < 5; ++i)
  {
    gltf.AddNode({ { "mesh", mesh } });
  }
  const Assembly assembly = Read(gltf);
  EXPECT_EQ(assembly.Meshes.size(), 1u);
  EXPECT_EQ(assembly.Nodes.size(), 5u);
}

TEST(GltfTree, GpuInstancesArePlacesOfOneMesh)
{
  Gltf gltf = OneTriangle();
  // normalized bytes are never of unit length exactly
  const std::vector<std::int8_t> turns = { 0, 0, 0, 127, 0, 0, 90, 90 };
  gltf.Root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
    { "TRANSLATION", gltf.AddAccessor<float>("VEC3", Float, 2, { 0, 0, 0, 10, 0, 0 }) },
    { "ROTATION", gltf.AddAccessor("VEC4", Byte, 2, turns, { { "normalized", true } }) },
    { "SCALE", gltf.AddAccessor<float>("VEC3", Float, 2, { 1, 1, 1, 2, 2, -2 }) }
  };
  const Assembly assembly = Read(gltf);
  EXPECT_EQ(assembly.Meshes.size(), 1u);
  const std::vector<glm::dmat4>& places = assembly.Nodes[0].Instances;
  ASSERT_EQ(places.size(), 2u);
  ExpectNear(Moved(places[0], { 1, 2, 3 }), { 1, 2, 3 });
  ExpectNear(Moved(places[1], { 1, 2, 3 }), { 6, 2, -6 });
}

TEST(GltfTree, SharedFileHasItsInstances)
{
  const char* const data = std::getenv("VITRINE_SHARED_DATA");
  const std::filesystem::path file =
    std::filesystem::path(data ? data : VITRINE_TEST_SHARED_DATA) / "wild" / "SimpleInstancing.glb";
  if (!std::filesystem::exists(file))
  {
    GTEST_SKIP() << file << " is not there";
  }
  const Assembly assembly = vitrine::ReadGltf(file);
  ASSERT_EQ(assembly.Nodes.size(), 1u);
  EXPECT_EQ(assembly.Nodes[0].Instances.size(), 125u);
  EXPECT_EQ(assembly.Meshes.size(), 1u);
  EXPECT_EQ(assembly.Meshes[0].Geometries[0].CellCount(), 12u);
  EXPECT_TRUE(assembly.Notes.empty());
}

TEST(GltfTree, ScenesShowTheirOwnNodes)
{
  Gltf gltf;
  gltf.AddNode({ { "name", "a" } });
  gltf.AddNode({ { "name", "b" } });
  gltf.Root["scenes"] = { { { "name", "first" }, { "nodes", { 0 } } },
    { { "name", "second" }, { "nodes", { 1 } } } };
  gltf.Root["scene"] = 1;
  const Assembly assembly = Read(gltf);
  EXPECT_EQ(assembly.Name, "second");
  ASSERT_EQ(assembly.Nodes.size(), 1u);
  EXPECT_EQ(assembly.Nodes[0].Name, "b");
  EXPECT_EQ(assembly.Notes, std::vector<std::string>{ "has 2 scenes; scene 1 is shown" });
  const Assembly chosen = Read(gltf, 0);
  EXPECT_EQ(chosen.Nodes[0].Name, "a");
  EXPECT_TRUE(chosen.Notes.empty());
  EXPECT_THROW(Read(gltf, 2), AssemblyError);
  EXPECT_THROW(Read(gltf, -2), AssemblyError);
}

TEST(GltfTree, WithoutSceneAllNodesWithoutParentAreShown)
{
  Gltf gltf;
  gltf.AddNode({ { "children", { 2 } } });
  gltf.AddNode(Json::object());
  gltf.AddNode(Json::object());
  EXPECT_EQ(Read(gltf).Roots.size(), 2u);
}

TEST(GltfTree, MeshesThatAreTheSameAreReadOnce)
{
  Gltf gltf;
  const Json triangle = gltf.Triangle();
  for (const char* name : { "bolt", "bolt", "nut" })
  {
    const int mesh = gltf.AddMesh(triangle);
    gltf.Root["meshes"][static_cast<std::size_t>(mesh)]["name"] = name;
    gltf.AddNode({ { "mesh", mesh } });
  }
  const Assembly assembly = Read(gltf);
  ASSERT_EQ(assembly.Nodes.size(), 3u);
  EXPECT_EQ(assembly.Nodes[0].Mesh, assembly.Nodes[1].Mesh);
  EXPECT_NE(assembly.Nodes[0].Mesh, assembly.Nodes[2].Mesh);
  ASSERT_EQ(assembly.Meshes.size(), 2u);
  EXPECT_EQ(assembly.Meshes[static_cast<std::size_t>(assembly.Nodes[2].Mesh)].Name, "nut");
}

TEST(GltfTree, ConvertersTellOfTheirFileInExtras)
{
  Gltf gltf = OneTriangle();
  EXPECT_EQ(Read(gltf).LengthUnit, "");
  gltf.Root["asset"]["extras"] = { { "lengthUnit", "in\nch" }, { "note", "is shown in part" } };
  const Assembly assembly = Read(gltf);
  EXPECT_EQ(assembly.LengthUnit, "in ch");
  EXPECT_EQ(assembly.Notes, std::vector<std::string>{ "is shown in part" });
  for (const Json& extras : { Json(7), Json::array({ 1 }), Json{ { "lengthUnit", 7 } } })
  {
    gltf.Root["asset"]["extras"] = extras;
    EXPECT_EQ(Read(gltf).LengthUnit, "");
  }
}
}
