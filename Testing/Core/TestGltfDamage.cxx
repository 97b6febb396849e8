#include "GltfFiles.h"

#include <cctype>
#include <limits>

// Damaged and hostile glTF: each kind gives its one message, and none crashes or takes much memory.
namespace
{

using namespace gltf_files;
using vitrine::AssemblyError;

/** A kind of damage: how a good file is changed, and a part of the message that it gives. */
struct Damage
{
  const char* Name;
  const char* Message;
  void (*Change)(Gltf&);
};

/** A triangle with indices and a material in a node of a scene. */
Gltf GoodFile()
{
  Gltf gltf;
  Json triangle = gltf.Triangle();
  triangle["indices"] = gltf.AddAccessor<std::uint16_t>("SCALAR", UnsignedShort, 3, { 0, 1, 2 });
  triangle["material"] = gltf.Add("materials", { { "name", "grey" } });
  gltf.AddNode({ { "mesh", gltf.AddMesh(triangle) } });
  gltf.Add("scenes", { { "nodes", { 0 } } });
  return gltf;
}

Json& PrimitiveOf(Gltf& gltf)
{
  return gltf.Root["meshes"][0]["primitives"][0];
}

void SetUri(Gltf& gltf, const std::string& uri)
{
  gltf.Root["buffers"] = Json::array({ { { "uri", uri }, { "byteLength", 44 } } });
}

/** Makes a compressed view of what stands in view 0. */
Json& Compress(Gltf& gltf, const Json& more)
{
  Json& view = gltf.Root["bufferViews"][0];
  Json extension = { { "buffer", 0 }, { "byteOffset", 0 }, { "byteLength", 36 }, { "count", 3 },
    { "byteStride", 12 }, { "mode", "ATTRIBUTES" } };
  extension.update(more);
  view["extensions"]["EXT_meshopt_compression"] = extension;
  return view;
}

void AddSparse(Gltf& gltf, const std::vector<std::uint16_t>& places, std::size_t count)
{
  gltf.Root["accessors"][0]["sparse"] = { { "count", count },
    { "indices",
      { { "bufferView", gltf.AddView(BytesOf(places)) }, { "componentType", UnsignedShort } } },
    { "values", { { "bufferView", gltf.AddView(Bytes(12 * places.size())) } } } };
}

void AddInstances(Gltf& gltf, std::size_t translations, std::size_t scales, float value = 1.0f)
{
  gltf.Root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
    { "TRANSLATION",
      gltf.AddAccessor("VEC3", Float, translations, std::vector<float>(3 * translations, value)) },
    { "SCALE", gltf.AddAccessor("VEC3", Float, scales, std::vector<float>(3 * scales, 1.0f)) }
  };
}

void AddSkin(Gltf& gltf, std::uint8_t joint, const Json& skin)
{
  Json& attributes = PrimitiveOf(gltf)["attributes"];
  const std::vector<std::uint8_t> joints(12, joint);
  attributes["JOINTS_0"] = gltf.AddAccessor("VEC4", UnsignedByte, 3, joints);
  attributes["WEIGHTS_0"] = gltf.AddAccessor("VEC4", Float, 3, std::vector<float>(12, 0.25f));
  gltf.Root["nodes"][0]["skin"] = gltf.Add("skins", skin);
}

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();

const Damage DAMAGES[] = {
  // The JSON
  { "NoVersion", "is of version ''", [](Gltf& g) { g.Root.erase("asset"); } },
  { "OldVersion", "is of version '1.0'", [](Gltf& g) { g.Root["asset"]["version"] = "1.0"; } },
  { "VersionIsNumber", "of another type", [](Gltf& g) { g.Root["asset"]["version"] = 2.0; } },
  { "UnknownExtension", "requires the extension ABC x, which",
    [](Gltf& g) { g.Root["extensionsRequired"] = Json::array({ "ABC\nx" }); } },
  { "Ktx2Required", "KTX2",
    [](Gltf& g) { g.Root["extensionsRequired"] = Json::array({ "KHR_texture_basisu" }); } },
  { "ExtensionsAreNumbers", "of another type",
    [](Gltf& g) { g.Root["extensionsRequired"] = Json::array({ 7 }); } },
  { "MeshesAreNumber", "of meshes there are 0", [](Gltf& g) { g.Root["meshes"] = 5; } },
  { "MeshesAreObject", "of another type",
    [](Gltf& g) {
      g.Root["meshes"] = { { "a", g.Root["meshes"][0] } };
    } },
  { "NodesAreObject", "of another type",
    [](Gltf& g) {
      g.Root["nodes"] = { { "a", g.Root["nodes"][0] } };
    } },
  { "PrimitivesAreObject", "of another type",
    [](Gltf& g) {
      g.Root["meshes"][0]["primitives"] = { { "a", PrimitiveOf(g) } };
    } },
  { "AccessorIsText", "of another type", [](Gltf& g) { g.Root["accessors"][0] = "text"; } },
  { "MaterialIsText", "of another type", [](Gltf& g) { g.Root["materials"][0]["alphaMode"] = 3; } },
  // References and numbers
  { "MeshBeyond", "/nodes/0/mesh is 1, and of meshes there are 1",
    [](Gltf& g) { g.Root["nodes"][0]["mesh"] = 1; } },
  { "MeshNegative", "/nodes/0/mesh is -1", [](Gltf& g) { g.Root["nodes"][0]["mesh"] = -1; } },
  { "MeshFraction", "/nodes/0/mesh is 0.5", [](Gltf& g) { g.Root["nodes"][0]["mesh"] = 0.5; } },
  { "MeshHuge", "/nodes/0/mesh is 18446744073709551615",
    [](Gltf& g) { g.Root["nodes"][0]["mesh"] = 18446744073709551615u; } },
  { "MaterialBeyond", "material is 9", [](Gltf& g) { PrimitiveOf(g)["material"] = 9; } },
  { "AccessorBeyond", "POSITION is 77",
    [](Gltf& g) { PrimitiveOf(g)["attributes"]["POSITION"] = 77; } },
  { "SceneBeyond", "/scene is 3", [](Gltf& g) { g.Root["scene"] = 3; } },
  { "TextureBeyond", "emissiveTexture/index is 0",
    [](Gltf& g) { g.Root["materials"][0]["emissiveTexture"]["index"] = 0; } },
  { "TextureOfExtensionBeyond", "diffuseTexture/index is 4",
    [](Gltf& g)
    {
      g.Root["materials"][0]["extensions"]["KHR_materials_pbrSpecularGlossiness"]["diffuseTexture"]
            ["index"] = 4;
    } },
  { "CountNegative", "a count is -3", [](Gltf& g) { g.Root["accessors"][0]["count"] = -3; } },
  { "CountZero", "has no type or no elements",
    [](Gltf& g) { g.Root["accessors"][0]["count"] = 0; } },
  { "CountBeyondView", "accessor 0 reaches beyond its bufferView",
    [](Gltf& g) { g.Root["accessors"][0]["count"] = 4; } },
  { "CountOfGigabytes", "accessor 0 reaches beyond its bufferView",
    [](Gltf& g) { g.Root["accessors"][0]["count"] = 4000000000u; } },
  { "CountOfGigabytesWithoutView", "too many elements for one without a bufferView",
    [](Gltf& g)
    {
      g.Root["accessors"][0]["count"] = 4000000000u;
      g.Root["accessors"][0].erase("bufferView");
    } },
  { "CountOfGigabytesWithoutIndices", "too many elements for one without a bufferView",
    [](Gltf& g)
    {
      g.Root["accessors"][0]["count"] = 4000000000u;
      g.Root["accessors"][0].erase("bufferView");
      g.Root["meshes"][0]["primitives"][0].erase("indices");
    } },
  { "CountOfNoInteger", "a count is 18446744073709551615",
    [](Gltf& g) { g.Root["accessors"][0]["count"] = 18446744073709551615u; } },
  { "OffsetBeyondView", "accessor 0 reaches beyond",
    [](Gltf& g) { g.Root["accessors"][0]["byteOffset"] = 4294967295u; } },
  { "StrideTooSmall", "accessor 0 reaches beyond",
    [](Gltf& g) { g.Root["bufferViews"][0]["byteStride"] = 4; } },
  { "StrideHuge", "accessor 0 reaches beyond",
    [](Gltf& g) { g.Root["bufferViews"][0]["byteStride"] = 4294967295u; } },
  { "UnknownComponent", "has no type",
    [](Gltf& g) { g.Root["accessors"][0]["componentType"] = 9; } },
  { "UnknownType", "has no type", [](Gltf& g) { g.Root["accessors"][0]["type"] = "VEC5"; } },
  { "PositionsAreScalars", "has 1 numbers to an element where 3 are needed",
    [](Gltf& g) { g.Root["accessors"][0]["type"] = "SCALAR"; } },
  { "IndicesAreFloats", "no unsigned integers", [](Gltf& g) { PrimitiveOf(g)["indices"] = 0; } },
  { "IndexBeyondVertices", "has an index beyond its 3 vertices",
    [](Gltf& g) { g.Binary[36] = 3; } },
  { "LengthsDiffer", "has 3 vertices and 2 of NORMAL",
    [](Gltf& g)
    {
      PrimitiveOf(g)["attributes"]["NORMAL"] =
        g.AddAccessor("VEC3", Float, 2, std::vector<float>(6, 1.0f));
    } },
  { "UnknownMode", "is of no kind that there is", [](Gltf& g) { PrimitiveOf(g)["mode"] = 7; } },
  { "NaNInPositions", "coordinates that are not finite",
    [](Gltf& g) { std::memcpy(g.Binary.data(), &NaN, sizeof(NaN)); } },
  // Buffers
  { "ViewBeyondBuffer", "bufferView 0 reaches beyond its buffer",
    [](Gltf& g) { g.Root["bufferViews"][0]["byteLength"] = 2000000000; } },
  { "ViewOffsetBeyond", "bufferView 0 reaches beyond its buffer",
    [](Gltf& g) { g.Root["bufferViews"][0]["byteOffset"] = 4294967295u; } },
  { "BufferTooLong", "buffer 0 should have 2000000000 bytes",
    [](Gltf& g) {
      g.Root["buffers"] = Json::array({ { { "byteLength", 2000000000 } } });
    } },
  { "BufferWithoutUri", "of another type",
    [](Gltf& g) {
      g.Root["buffers"] = Json::array({ { { "byteLength", 44 } }, { { "byteLength", 1 } } });
    } },
  { "UriIsNotThere", "needs the file none.bin, which is not there",
    [](Gltf& g) { SetUri(g, "none.bin"); } },
  { "UriIsFolder", "which is not there", [](Gltf& g) { SetUri(g, "."); } },
  { "UriLeavesFolder", "outside of its folder", [](Gltf& g) { SetUri(g, "../../../etc/passwd"); } },
  { "UriLeavesFolderByCodes", "outside of its folder",
    [](Gltf& g) { SetUri(g, "a/%2e%2e/%2E%2E/passwd"); } },
  { "UriIsAbsolutePath", "outside of its folder", [](Gltf& g) { SetUri(g, "/etc/passwd"); } },
  { "UriIsOfWeb", "only files in its folder are read",
    [](Gltf& g) { SetUri(g, "https://example.org/a.bin"); } },
  { "UriIsOfFileScheme", "only files in its folder are read",
    [](Gltf& g) { SetUri(g, "file:///etc/passwd"); } },
  { "UriHasZero", "only files in its folder are read",
    [](Gltf& g) { SetUri(g, "a.bin%00/../.."); } },
  { "UriHasLines", "names 'a b'; only files", [](Gltf& g) { SetUri(g, "a%0Ab"); } },
  { "UriIsEmpty", "only files in its folder are read", [](Gltf& g) { SetUri(g, ""); } },
  { "UriIsLong", "outside of its folder",
    [](Gltf& g) { SetUri(g, "../" + std::string(900, 'a')); } },
  { "UriIsNumber", "of another type",
    [](Gltf& g) {
      g.Root["buffers"] = Json::array({ { { "uri", 5 } } });
    } },
  { "Base64HasOtherCharacters", "holds no base64",
    [](Gltf& g) { SetUri(g, "data:;base64,AA*A"); } },
  { "Base64HasPaddingWithin", "holds no base64",
    [](Gltf& g) { SetUri(g, "data:;base64,AA==AAAA"); } },
  { "Base64IsShort", "buffer 0 should have 44 bytes and has 3",
    [](Gltf& g) { SetUri(g, "data:;base64,AAAA"); } },
  { "DataUriHasNoComma", "holds no base64", [](Gltf& g) { SetUri(g, "data:;base64"); } },
  { "DataUriIsText", "holds no base64", [](Gltf& g) { SetUri(g, "data:text/plain,AAAA"); } },
  // The tree
  { "RootTwice", "nodes form no tree",
    [](Gltf& g) {
      g.Root["scenes"][0]["nodes"] = { 0, 0 };
    } },
  { "Cycle", "nodes form no tree",
    [](Gltf& g)
    {
      g.AddNode({ { "children", { 0 } } });
      g.Root["nodes"][0]["children"] = Json::array({ 1 });
    } },
  { "CycleWithoutScene", "nodes form no tree",
    [](Gltf& g)
    {
      g.Root.erase("scenes");
      g.Root["nodes"][0]["children"] = Json::array({ 0 });
    } },
  { "TwoParents", "nodes form no tree",
    [](Gltf& g)
    {
      g.AddNode({ { "children", { 0 } } });
      g.AddNode({ { "children", { 0 } } });
      g.Root["scenes"][0]["nodes"] = { 1, 2 };
    } },
  { "PlaceOverflows", "place of node 1 is not made of finite numbers",
    [](Gltf& g)
    {
      g.Root["nodes"][0]["scale"] = { 1e300, 1, 1 };
      g.Root["nodes"][0]["children"] = Json::array({ g.AddNode({ { "scale", { 1e300, 1, 1 } } }) });
    } },
  { "MatrixIsShort", "a matrix of a node has 15 numbers",
    [](Gltf& g) { g.Root["nodes"][0]["matrix"] = std::vector<int>(15, 1); } },
  { "MatrixHasText", "of another type",
    [](Gltf& g) { g.Root["nodes"][0]["matrix"] = std::vector<std::string>(16, "1"); } },
  { "FactorOverflows", "a factor of a material is 1e+300",
    [](Gltf& g) {
      g.Root["materials"][0]["emissiveFactor"] = { 1e300, 0, 0 };
    } },
  // Sparse accessors, instances, skins
  { "SparsePlaceBeyond", "replaces an element that it does not have",
    [](Gltf& g) { AddSparse(g, { 3 }, 1); } },
  { "SparseCountBeyond", "is sparse in 4 elements",
    [](Gltf& g) {
      AddSparse(g, { 0, 1, 2, 0 }, 4);
    } },
  { "SparseCountBeyondView", "accessor 0 reaches beyond", [](Gltf& g) { AddSparse(g, { 0 }, 3); } },
  { "InstancesDiffer", "attributes of instances have different lengths",
    [](Gltf& g) { AddInstances(g, 3, 2); } },
  { "InstancesAreNaN", "the place of an instance is not made of finite",
    [](Gltf& g) { AddInstances(g, 2, 2, NaN); } },
  { "JointBeyondSkin", "has a joint that its skin does not have",
    [](Gltf& g) {
      AddSkin(g, 1, { { "joints", { 0 } } });
    } },
  { "JointNotInScene", "a skin has a joint that is not in the scene",
    [](Gltf& g) {
      AddSkin(g, 0, { { "joints", { g.AddNode(Json::object()) } } });
    } },
  { "InverseBindIsNaN", "the place of a joint is not made of finite",
    [](Gltf& g)
    {
      AddSkin(g, 0,
        { { "joints", { 0 } },
          { "inverseBindMatrices",
            g.AddAccessor("MAT4", Float, 1, std::vector<float>(16, NaN)) } });
    } },
  { "InverseBindIsNoMatrix", "has 3 numbers to an element where 16 are needed",
    [](Gltf& g) {
      AddSkin(g, 0, { { "joints", { 0 } }, { "inverseBindMatrices", 0 } });
    } },
  // Compressed data
  { "MeshoptIsNoise", "a compressed bufferView cannot be decoded",
    [](Gltf& g) { Compress(g, Json::object()); } },
  { "MeshoptClaims", "a compressed bufferView cannot hold what it states",
    [](Gltf& g) {
      Compress(g, { { "count", 4000000000u } });
    } },
  { "MeshoptOfOddStride", "cannot hold what it states",
    [](Gltf& g) {
      Compress(g, { { "byteStride", 7 } });
    } },
  { "MeshoptOfUnknownMode", "cannot hold what it states",
    [](Gltf& g) {
      Compress(g, { { "mode", "X" } });
    } },
  { "MeshoptBeyondBuffer", "bufferView 0 reaches beyond its buffer",
    [](Gltf& g) {
      Compress(g, { { "byteLength", 2000000000 } });
    } },
  { "DracoIsNoise", "is no mesh of its version 2.2",
    [](Gltf& g)
    {
      PrimitiveOf(g)["extensions"]["KHR_draco_mesh_compression"] = { { "bufferView", 0 },
        { "attributes", { { "POSITION", 0 } } } };
    } },
  { "DracoWithoutView", "of another type",
    [](Gltf& g) { PrimitiveOf(g)["extensions"]["KHR_draco_mesh_compression"] = Json::object(); } },
  // Much of little
  { "ManyCopiesOfGeometry", "would take more than",
    [](Gltf& g)
    {
      const std::size_t count = 300000;
      Json triangles = { { "attributes", { { "POSITION", 0 } } } };
      triangles["indices"] =
        g.AddAccessor("SCALAR", UnsignedByte, count, std::vector<std::uint8_t>(count, 1));
      g.Root["meshes"][0]["primitives"] = std::vector<Json>(400, triangles);
    } },
  { "ManyCopiesOfPictures", "would take more than",
    [](Gltf& g)
    {
      const int view = g.AddView(Bytes(1000000));
      for (int i = 0; i < 2000; ++i)
      {
        g.Add("images", { { "bufferView", view } });
        g.Add("textures", { { "source", i } });
        g.Add("materials", { { "normalTexture", { { "index", i } } } });
      }
    } },
  { "ManyPlacesOfJoints", "would take more than",
    [](Gltf& g)
    {
      AddSkin(g, 0, { { "joints", std::vector<int>(50000, 0) } });
      const Json child = { { "mesh", 0 }, { "skin", 0 } };
      std::vector<int> children;
      for (int i = 0; i < 100; ++i)
      {
        children.push_back(g.AddNode(child));
      }
      g.Root["nodes"][0]["children"] = children;
    } },
};

/** Returns the message of the error that reading gives. It is "nothing" without an error. */
std::string MessageOf(const std::string& content)
{
  try
  {
    Read(content);
    return "nothing";
  }
  catch (const AssemblyError& error)
  {
    return error.what();
  }
}

void ExpectMessage(const std::string& message, const std::string& part)
{
  EXPECT_NE(message.find(part), std::string::npos) << message;
  EXPECT_LT(message.size(), 1200u);
  for (const unsigned char c : message)
  {
    EXPECT_FALSE(std::iscntrl(c)) << message;
  }
}

void PrintTo(const Damage& damage, std::ostream* stream)
{
  *stream << damage.Message;
}

class GltfDamage : public testing::TestWithParam<Damage>
{
};

TEST_P(GltfDamage, HasItsMessage)
{
  Gltf gltf = GoodFile();
  GetParam().Change(gltf);
  ExpectMessage(MessageOf(gltf.Content()), GetParam().Message);
}

INSTANTIATE_TEST_SUITE_P(Kinds, GltfDamage, testing::ValuesIn(DAMAGES),
  [](const testing::TestParamInfo<Damage>& kind) { return std::string(kind.param.Name); });

TEST(GltfDamagedBytes, GoodFileIsRead)
{
  EXPECT_EQ(MessageOf(GoodFile().Content()), "nothing");
}

TEST(GltfDamagedBytes, CutFilesAreRefused)
{
  const std::string content = GoodFile().Content();
  for (std::size_t length = 0; length < content.size(); length += 5)
  {
    ExpectMessage(MessageOf(content.substr(0, length)), "is ");
  }
}

TEST(GltfDamagedBytes, CutTextIsRefused)
{
  const std::string text = GoodFile().Root.dump();
  for (std::size_t length = 0; length < text.size(); length += 3)
  {
    ExpectMessage(MessageOf(text.substr(0, length)), "its JSON is damaged or not there");
  }
}

TEST(GltfDamagedBytes, HeadersAreChecked)
{
  const std::string text = Chunk("JSON", R"({"asset":{"version":"2.0"}})");
  ExpectMessage(MessageOf("glTF"), "ends within its header");
  ExpectMessage(MessageOf("glTF" + Word(1) + Word(12)), "is of version 1 of glTF");
  ExpectMessage(
    MessageOf("glTF" + Word(2) + Word(0xffffffff) + text), "it states 4294967295 bytes");
  ExpectMessage(MessageOf(Glb("")), "its JSON is damaged or not there");
  ExpectMessage(MessageOf(Glb(text + Word(0xffffffff) + "BIN")), "a chunk is longer than the file");
  ExpectMessage(MessageOf(Glb(text + Word(0xfffffff0) + std::string("BIN\0abcd", 8))),
    "a chunk is longer than the file");
}

TEST(GltfDamagedBytes, TextThatIsNoJsonIsRefused)
{
  for (const char* text :
    { "", "[]", "null", "{\"a\":\xff}", "{\"asset\":1e999}", "{\"asset\":\"\xc3\"}" })
  {
    ExpectMessage(MessageOf(text), "its JSON is damaged or not there");
  }
}

TEST(GltfDamagedBytes, JsonHasBoundedDepth)
{
  const std::string begin = R"({"asset":{"version":"2.0"},"extras":)";
  const auto lists = [](std::size_t depth)
  { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_EQ(MessageOf(begin + lists(499) + "}"), "nothing");
  ExpectMessage(MessageOf(begin + lists(500) + "}"), "more than 500 levels");
  const std::string meshes = R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[],"extras":)";
  ExpectMessage(MessageOf(meshes + lists(300000) + "}]}"), "more than 500 levels");
  const std::string inText(1000, '[');
  EXPECT_EQ(MessageOf(begin + R"("\"\\)" + inText + R"("})"), "nothing");
}

TEST(GltfDamagedBytes, LinksOutOfTheFolderAreNotFollowed)
{
  const Folder outside, folder;
  std::filesystem::create_symlink(
    outside.Write("secret.bin", std::string(44, '\0')), folder.Path / "link.bin");
  Gltf gltf = GoodFile();
  SetUri(gltf, "link.bin");
  try
  {
    vitrine::ReadGltf(folder.Write("a.gltf", gltf.Root.dump()));
    FAIL() << "the link was followed";
  }
  catch (const AssemblyError& error)
  {
    ExpectMessage(error.what(), "outside of its folder");
  }
}

TEST(GltfDamagedBytes, FilesThatAreNotThereAreSaid)
{
  const Folder folder;
  EXPECT_THROW(vitrine::ReadGltf(folder.Path / "none.glb"), AssemblyError);
  EXPECT_THROW(vitrine::ReadGltf(folder.Path), AssemblyError);
  EXPECT_THROW(vitrine::ReadGltf(folder.Path / std::string(5000, 'a')), AssemblyError);
}

/** Changes single bytes by a fixed seed. Whatever comes, an error is an AssemblyError. */
TEST(GltfDamagedBytes, ChangedBytesDoNoHarm)
{
  const std::string good = GoodFile().Content();
  std::mt19937 random(20);
  for (int i = 0; i < 1000; ++i)
  {
    std::string content = good;
    for (int changes = 0; changes < 3; ++changes)
    {
      content[random() % content.size()] = static_cast<char>(random());
    }
    MessageOf(content);
  }
}

}
