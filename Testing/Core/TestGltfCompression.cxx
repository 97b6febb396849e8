#include "GltfFiles.h"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include <algorithm>

// Geometry that meshoptimizer and Draco compressed comes out as it went in.
namespace
{

using namespace gltf_files;
using vitrine::Assembly;
using vitrine::AssemblyError;
using vitrine::AssemblyGeometry;

constexpr std::size_t Side = 20;

/** The vertices of a wavy square. */
std::vector<float> WavyPoints()
{
  std::vector<float> points;
  for (std::size_t i = 0; i < Side * Side; ++i)
  {
    const auto x = static_cast<float>(i % Side);
    const auto y = static_cast<float>(i / Side);
    points.insert(points.end(), { x, y, std::sin(x) + std::cos(y) });
  }
  return points;
}

std::vector<std::uint32_t> WavyCorners()
{
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < Side * (Side - 1); ++i)
  {
    if (i % Side != Side - 1)
    {
      const std::uint32_t up = i + static_cast<std::uint32_t>(Side);
      corners.insert(corners.end(), { i, i + 1, up, up, i + 1, up + 1 });
    }
  }
  return corners;
}

/** Adds a view of compressed data. */
int AddCompressed(Gltf& gltf, Bytes bytes, std::size_t size, std::size_t count, std::size_t stride,
  const char* mode, const char* filter = "NONE")
{
  bytes.resize(size);
  const int data = gltf.AddView(bytes);
  Json view = gltf.Root["bufferViews"][static_cast<std::size_t>(data)];
  Json extension = view;
  extension.update(
    { { "count", count }, { "byteStride", stride }, { "mode", mode }, { "filter", filter } });
  gltf.Root["bufferViews"][static_cast<std::size_t>(data)] = { { "buffer", 1 },
    { "byteLength", count * stride },
    { "extensions", { { "EXT_meshopt_compression", extension } } } };
  return data;
}

int AddVertices(Gltf& gltf, const void* vertices, std::size_t count, std::size_t stride,
  const char* filter = "NONE")
{
  Bytes bytes(meshopt_encodeVertexBufferBound(count, stride));
  const std::size_t size =
    meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), vertices, count, stride);
  return AddCompressed(gltf, bytes, size, count, stride, "ATTRIBUTES", filter);
}

int AddAccessorOf(Gltf& gltf, int view, const char* type, int component, std::size_t count)
{
  return gltf.Add("accessors",
    { { "bufferView", view }, { "type", type }, { "componentType", component },
      { "count", count } });
}

/** The wavy square, with its triangles in meshopt's mode TRIANGLES or INDICES. */
Gltf WavyByMeshopt(bool asTriangles)
{
  Gltf gltf;
  const std::vector<float> points = WavyPoints();
  const std::vector<std::uint32_t> corners = WavyCorners();
  const std::size_t count = points.size() / 3;
  const int positions =
    AddAccessorOf(gltf, AddVertices(gltf, points.data(), count, 12), "VEC3", Float, count);
  Bytes bytes(asTriangles ? meshopt_encodeIndexBufferBound(corners.size(), count)
                          : meshopt_encodeIndexSequenceBound(corners.size(), count));
  const std::size_t size = asTriangles
    ? meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), corners.data(), corners.size())
    : meshopt_encodeIndexSequence(bytes.data(), bytes.size(), corners.data(), corners.size());
  const int view =
    AddCompressed(gltf, bytes, size, corners.size(), 4, asTriangles ? "TRIANGLES" : "INDICES");
  const int indices = AddAccessorOf(gltf, view, "SCALAR", UnsignedInt, corners.size());
  gltf.AddNode({ { "mesh",
    gltf.AddMesh({ { "attributes", { { "POSITION", positions } } }, { "indices", indices } }) } });
  gltf.Root["extensionsRequired"] = Json::array({ "EXT_meshopt_compression" });
  gltf.Root["buffers"] = Json::array({ { { "byteLength", gltf.Binary.size() } },
    { { "byteLength", 1 },
      { "extensions", { { "EXT_meshopt_compression", { { "fallback", true } } } } } } });
  return gltf;
}

/** The corners of each triangle, which begins with its least and turns as it did, in ascending order. */
std::vector<std::vector<std::uint32_t>> Triangles(const std::vector<std::uint32_t>& indices)
{
  std::vector<std::vector<std::uint32_t>> triangles;
  for (std::size_t i = 0; i < indices.size(); i += 3)
  {
    std::vector<std::uint32_t> triangle = { indices[i], indices[i + 1], indices[i + 2] };
    std::rotate(
      triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    triangles.push_back(triangle);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

TEST(GltfCompression, MeshoptGivesBackVerticesAndTriangles)
{
  meshopt_encodeIndexVersion(1);
  const std::vector<float> points = WavyPoints();
  for (const bool asTriangles : { true, false })
  {
    const Assembly assembly = Read(WavyByMeshopt(asTriangles));
    const AssemblyGeometry& geometry = assembly.Meshes[0].Geometries[0];
    EXPECT_EQ(BytesOf(geometry.Positions), BytesOf(points));
    EXPECT_EQ(Triangles(geometry.Indices), Triangles(WavyCorners()));
    EXPECT_TRUE(assembly.Notes.empty());
  }
}

TEST(GltfCompression, MeshoptUndoesItsFilters)
{
  Gltf gltf;
  const std::vector<float> normals = { 1, 0, 0, 0, 0, -1, 0, 0, 0, 0.6f, 0.8f, 0 };
  const std::vector<float> points = { 1, 2, 3, -4, 0.5f, 0, 100, 0, 0.25f };
  std::vector<std::int8_t> encodedNormals(12);
  meshopt_encodeFilterOct(encodedNormals.data(), 3, 4, 8, normals.data());
  std::vector<std::uint32_t> encodedPoints(9);
  meshopt_encodeFilterExp(encodedPoints.data(), 3, 12, 15, points.data());
  const int positionView = AddVertices(gltf, encodedPoints.data(), 3, 12, "EXPONENTIAL");
  const int normalView = AddVertices(gltf, encodedNormals.data(), 3, 4, "OCTAHEDRAL");
  const int positionAccessor = AddAccessorOf(gltf, positionView, "VEC3", Float, 3);
  const int normalAccessor = AddAccessorOf(gltf, normalView, "VEC3", Byte, 3);
  gltf.Root["accessors"][1]["normalized"] = true;
  gltf.Root["bufferViews"][1]["byteStride"] = 4;
  gltf.AddNode({ { "mesh",
    gltf.AddMesh({ { "attributes",
      { { "POSITION", positionAccessor }, { "NORMAL", normalAccessor } } } }) } });
  gltf.Root["buffers"] = Json::array({ { { "byteLength", gltf.Binary.size() } },
    { { "byteLength", 1 }, { "extensions", { { "EXT_meshopt_compression", Json::object() } } } } });
  const Assembly assembly = Read(gltf);
  const AssemblyGeometry& geometry = assembly.Meshes[0].Geometries[0];
  for (std::size_t i = 0; i < 3; ++i)
  {
    const glm::vec3 point(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
    const glm::vec3 normal(normals[4 * i], normals[4 * i + 1], normals[4 * i + 2]);
    EXPECT_NEAR(glm::distance(geometry.Positions[i], point), 0.0f, 0.01f) << i << ", at 15 bits";
    EXPECT_NEAR(glm::distance(geometry.Normals[i], normal), 0.0f, 0.02f) << i << ", at 8 bits";
  }
}

TEST(GltfCompression, MeshoptMayBeCutAnywhere)
{
  Gltf gltf = WavyByMeshopt(true);
  Json& extension = gltf.Root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"];
  const std::size_t whole = extension["byteLength"].get<std::size_t>();
  for (std::size_t length = 0; length < whole; length += 23)
  {
    extension["byteLength"] = length;
    EXPECT_THROW(Read(gltf), AssemblyError) << length << " of " << whole;
  }
}

/** The wavy square by Draco. A speed of 10 makes it store triangles one by one. */
Bytes EncodeByDraco(int speed)
{
  const std::vector<float> points = WavyPoints();
  const std::vector<std::uint32_t> corners = WavyCorners();
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(static_cast<int>(corners.size() / 3));
  const int position =
    builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  for (std::uint32_t face = 0; face < corners.size() / 3; ++face)
  {
    builder.SetAttributeValuesForFace(position, draco::FaceIndex(face),
      &points[3 * corners[3 * face]], &points[3 * corners[3 * face + 1]],
      &points[3 * corners[3 * face + 2]]);
  }
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetSpeedOptions(speed, speed);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  return { buffer.data(), buffer.data() + buffer.size() };
}

Gltf WavyByDraco(const Bytes& bytes)
{
  Gltf gltf;
  const std::size_t count = Side * Side;
  gltf.Add("accessors", { { "type", "VEC3" }, { "componentType", Float }, { "count", count } });
  gltf.Add("accessors",
    { { "type", "SCALAR" }, { "componentType", UnsignedInt }, { "count", WavyCorners().size() } });
  const Json extension = { { "bufferView", gltf.AddView(bytes) },
    { "attributes", { { "POSITION", 0 } } } };
  gltf.AddNode({ { "mesh",
    gltf.AddMesh({ { "attributes", { { "POSITION", 0 } } }, { "indices", 1 },
      { "extensions", { { "KHR_draco_mesh_compression", extension } } } }) } });
  gltf.Root["extensionsRequired"] = Json::array({ "KHR_draco_mesh_compression" });
  return gltf;
}

/** The number of the vertex of the wavy square at a point. */
std::uint32_t VertexAt(const glm::vec3& point)
{
  return static_cast<std::uint32_t>(std::lround(point.y)) * static_cast<std::uint32_t>(Side) +
    static_cast<std::uint32_t>(std::lround(point.x));
}

TEST(GltfCompression, DracoGivesBackVerticesAndTriangles)
{
  const std::vector<float> points = WavyPoints();
  const float step = static_cast<float>(Side - 1) / 16383.0f; // of a quantization by 14 bits
  for (const int speed : { 0, 5, 10 })
  {
    const Assembly assembly = Read(WavyByDraco(EncodeByDraco(speed)));
    const AssemblyGeometry& geometry = assembly.Meshes[0].Geometries[0];
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t index : geometry.Indices)
    {
      const glm::vec3& point = geometry.Positions[index];
      corners.push_back(VertexAt(point));
      ASSERT_LT(corners.back(), Side * Side);
      EXPECT_NEAR(point.z, points[3 * corners.back() + 2], step) << "speed " << speed;
    }
    EXPECT_EQ(Triangles(corners), Triangles(WavyCorners())) << "speed " << speed;
    EXPECT_TRUE(assembly.Notes.empty());
  }
}

TEST(GltfCompression, DracoMayBeCutAnywhere)
{
  for (const int speed : { 0, 10 })
  {
    const Bytes whole = EncodeByDraco(speed);
    for (std::size_t length = 0; length + 1 < whole.size(); length += 23)
    {
      const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
      EXPECT_THROW(Read(WavyByDraco(cut)), AssemblyError) << length << " of " << whole.size();
    }
  }
}

TEST(GltfCompression, DracoClaimsAreRefusedBeforeTheyAreFollowed)
{
  // 11 bytes of header, and for speed 10 two numbers of up to five bytes: 0xfffffff0 faces and vertices
  const Bytes whole = EncodeByDraco(10);
  Bytes claim(whole.begin(), whole.begin() + 11);
  for (int i = 0; i < 2; ++i)
  {
    claim.insert(claim.end(), { 0xf0, 0xff, 0xff, 0xff, 0x0f });
  }
  try
  {
    Read(WavyByDraco(claim));
    FAIL() << "the claim was followed";
  }
  catch (const AssemblyError& error)
  {
    EXPECT_NE(std::string(error.what()).find("would take more than"), std::string::npos)
      << error.what();
  }
}

TEST(GltfCompression, DracoHasTheVerticesOfItsAccessors)
{
  Gltf gltf = WavyByDraco(EncodeByDraco(5));
  gltf.Root["accessors"][0]["count"] = Side * Side - 1;
  EXPECT_THROW(Read(gltf), AssemblyError);
  gltf.Root["accessors"][0]["count"] = 4294967295u;
  EXPECT_THROW(Read(gltf), AssemblyError);
}

}
