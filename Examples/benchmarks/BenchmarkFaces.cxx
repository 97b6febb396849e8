// Convex faces in an s-buffer at full resolution, by the statements on their order: what each saves, and what it takes.
// VITRINE_BENCHMARK_MESH names a file of a mesh that OpenMesh reads (STL, PLY, OBJ), which is measured then as well.

#include <OpenMesh/Core/IO/MeshIO.hh> // before the type of the mesh, or no format is known
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "study/faces/FaceNeighbours.h"
#include "study/faces/FaceScan.h"
#include "study/faces/ScreenFaces.h"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace vitrine;

constexpr int ScreenColumns = 960;
constexpr int ScreenLines = 540;

// With neighbours, in view.
ScreenFaces OnScreen(ScreenFaces faces)
{
  faces.Project(ScreenColumns, ScreenLines);
  faces.Neighbours = FindFaceNeighbours(faces.Points.size(), faces.Corners, faces.Ends());
  return faces;
}

ScreenFaces Boxes()
{
  return OnScreen(TurnedBoxes());
}

ScreenFaces Spheres()
{
  return OnScreen(CrossingSpheres());
}

ScreenFaces Model(const std::string& file)
{
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
  Mesh mesh;
  ScreenFaces faces;
  if (!OpenMesh::IO::read_mesh(mesh, file))
  {
    return faces;
  }
  for (const Mesh::VertexHandle vertex : mesh.vertices())
  {
    const Mesh::Point& point = mesh.point(vertex);
    faces.Points.emplace_back(point[0], point[1], point[2]);
  }
  for (const Mesh::FaceHandle face : mesh.faces())
  {
    for (const Mesh::VertexHandle vertex : mesh.fv_range(face))
    {
      faces.Corners.push_back(static_cast<std::uint32_t>(vertex.idx()));
    }
  }
  return OnScreen(std::move(faces));
}

using Source = std::function<ScreenFaces()>;

// Without anything that knows an order, as the culler inserts.
void InsertFaces(benchmark::State& state, const Source& source)
{
  const ScreenFaces faces = source();
  SBuffer buffer(ScreenColumns, ScreenLines, {}, 1u << 22);
  for (auto _ : state)
  {
    buffer.Clear();
    for (const std::uint32_t face : faces.Sequence)
    {
      InsertFace(buffer, faces.Face(face));
    }
  }
  state.counters["faces"] = static_cast<double>(faces.Sequence.size());
  state.counters["comparisons"] = static_cast<double>(buffer.Counts().Comparisons);
}

void InsertFacesInOrder(
  benchmark::State& state, const Source& source, const FaceOrderStatements& statements)
{
  const ScreenFaces faces = source();
  SBuffer buffer(ScreenColumns, ScreenLines, {}, 1u << 22);
  FaceOrder order(statements);
  for (auto _ : state)
  {
    buffer.Clear();
    order.Forget();
    for (const std::uint32_t face : faces.Sequence)
    {
      InsertFace(buffer, faces.Face(face), order);
    }
  }
  state.counters["comparisons"] = static_cast<double>(buffer.Counts().Comparisons);
  state.counters["lookups"] = static_cast<double>(order.Counts().Lookups);
  state.counters["end_checks"] = static_cast<double>(order.Counts().EndChecks);
  state.counters["by_1"] = static_cast<double>(order.Counts().ByOneOrder);
  state.counters["by_2"] = static_cast<double>(order.Counts().BySharedEnds);
  state.counters["by_3"] = static_cast<double>(order.Counts().ByNeighbours);
}

void RegisterSequence(const std::string& scene, const Source& source)
{
  const auto add = [&](const std::string& name, const auto&... arguments)
  {
    benchmark::RegisterBenchmark(("InsertFaces/" + scene + "/" + name).c_str(), arguments...)
      ->Unit(benchmark::kMillisecond);
  };
  add("compared", InsertFaces, source);
  const auto addInOrder = [&](const std::string& name, const FaceOrderStatements& statements)
  { add(name, InsertFacesInOrder, source, statements); };
  addInOrder("no_statement", { false, false, false });
  addInOrder("statement_1", { true, false, false });
  addInOrder("statement_2", { false, true, false });
  addInOrder("statement_3", { false, false, true });
  addInOrder("all", {});
}

void RegisterScene(const std::string& scene, const Source& source)
{
  RegisterSequence(scene + "/as_stored", source);
  RegisterSequence(scene + "/front_to_back",
    [source]
    {
      ScreenFaces faces = source();
      faces.SortFrontToBack();
      return faces;
    });
}

const bool AreRegistered = []
{
  RegisterScene("boxes", Boxes);
  RegisterScene("spheres", Spheres);
  if (const char* file = std::getenv("VITRINE_BENCHMARK_MESH"))
  {
    RegisterScene("model", [file = std::string(file)] { return Model(file); });
  }
  return true;
}();

// Each of 4096 faces of the boxes again, when all are there.
void TestFaces(benchmark::State& state)
{
  const ScreenFaces faces = Boxes();
  SBuffer buffer(ScreenColumns, ScreenLines, {}, 1u << 22);
  for (const std::uint32_t face : faces.Sequence)
  {
    InsertFace(buffer, faces.Face(face));
  }
  std::size_t asked = 0;
  std::size_t hidden = 0;
  for (auto _ : state)
  {
    const std::uint32_t face = faces.Sequence[asked++ % 4096 * faces.Sequence.size() / 4096];
    hidden += HidesFace(buffer, faces.Face(face), 1e-6f);
  }
  state.counters["hidden_share"] = static_cast<double>(hidden) / static_cast<double>(asked);
}
BENCHMARK(TestFaces);

}
