// Convex faces in an s-buffer at full resolution, by the statements on their order: what each saves, and what it takes.
// VITRINE_BENCHMARK_MESH names a file of a mesh that OpenMesh reads (STL, PLY, OBJ), which is measured then as well.

#include <OpenMesh/Core/IO/MeshIO.hh> // before the type of the mesh, or no format is known
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "BenchmarkMeshes.h"

#include "study/faces/FaceScan.h"

#include <benchmark/benchmark.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace vitrine;

constexpr int ScreenColumns = 960;
constexpr int ScreenLines = 540;

// Faces of equally many corners, on the screen.
struct ScreenFaces
{
  std::vector<glm::dvec3> Points;
  std::vector<std::uint32_t> Corners; // of one face after the other, counter-clockwise from outside
  std::size_t CornersPerFace = 3;

  std::vector<ScreenPoint> OnScreen; // the corners'
  std::vector<std::uint32_t> Neighbours;
  std::vector<std::uint32_t> Sequence; // front faces, as stored

  void Project();
  void SortFrontToBack();
  ConvexFace Face(std::uint32_t face) const
  {
    const std::size_t first = face * this->CornersPerFace;
    return { &this->OnScreen[first], this->CornersPerFace, face, &this->Neighbours[first] };
  }
};

// From outside, with all of the points in view.
void ScreenFaces::Project()
{
  glm::dvec3 low(1e300), high(-1e300);
  for (const glm::dvec3& point : this->Points)
  {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  const glm::dvec3 middle = 0.5 * (low + high);
  const double radius = 0.5 * glm::length(high - low);
  const glm::dmat4 look =
    glm::lookAt(middle + radius * glm::dvec3(1.4, 1.0, 1.7), middle, glm::dvec3(0.0, 1.0, 0.0));
  const ScreenProjection view(
    glm::perspective(glm::radians(40.0), 16.0 / 9.0, radius, 6 * radius) * look, ScreenColumns,
    ScreenLines, glm::max(glm::abs(low), glm::abs(high)), {});
  for (const std::uint32_t corner : this->Corners)
  {
    const glm::dvec4 place = view.ToScreen(this->Points[corner]);
    this->OnScreen.push_back({ static_cast<float>(place.x / place.w),
      static_cast<float>(place.y / place.w), static_cast<float>(place.z / place.w) });
  }

  const std::uint32_t count =
    static_cast<std::uint32_t>(this->Corners.size() / this->CornersPerFace);
  std::vector<std::uint32_t> ends(count);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    ends[i] = static_cast<std::uint32_t>((i + 1) * this->CornersPerFace);
    const ScreenPoint* p = this->Face(i).Corners;
    const float turn = (p[1].Column - p[0].Column) * (p[2].Line - p[0].Line) -
      (p[2].Column - p[0].Column) * (p[1].Line - p[0].Line);
    if (turn > 0.0f)
    {
      this->Sequence.push_back(i);
    }
  }
  this->Neighbours = FindFaceNeighbours(this->Points.size(), this->Corners, ends);
}

void ScreenFaces::SortFrontToBack()
{
  const auto depthOf = [&](std::uint32_t i) { return this->Face(i).Corners[0].Depth; };
  std::stable_sort(this->Sequence.begin(), this->Sequence.end(),
    [&](std::uint32_t a, std::uint32_t b) { return depthOf(a) > depthOf(b); });
}

// A heap of turned boxes, with faces of four corners; they cross each other here and there.
ScreenFaces Boxes()
{
  std::mt19937 random(1);
  const auto uniform = [&] { return random() / 4294967296.0; };
  const auto vector = [&]
  {
    const double x = uniform();
    const double y = uniform();
    return glm::dvec3(x, y, uniform());
  };
  ScreenFaces faces;
  faces.CornersPerFace = 4;
  for (std::uint32_t i = 0; i < 4000; ++i)
  {
    const glm::dvec3 centre = vector();
    const glm::dvec3 halfSize = 0.03 * (vector() + 0.3);
    const glm::dvec3 axis = glm::normalize(vector() - 0.5);
    const glm::dmat4 toWorld = glm::scale(
      glm::rotate(glm::translate(glm::dmat4(1.0), centre), 6.28 * uniform(), axis), halfSize);
    for (int j = 0; j < 8; ++j)
    {
      faces.Points.emplace_back(
        toWorld * glm::dvec4(j & 1 ? 1 : -1, j & 2 ? 1 : -1, j & 4 ? 1 : -1, 1));
    }
    for (const std::uint32_t corner :
      { 0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6 })
    {
      faces.Corners.push_back(8 * i + corner);
    }
  }
  faces.Project();
  return faces;
}

// Sixteen spheres, some of which cross.
ScreenFaces Spheres()
{
  const BenchmarkMesh mesh(BenchmarkMesh::Kinds::Spheres, 20000);
  ScreenFaces faces;
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    faces.Points.emplace_back(mesh.Points[i], mesh.Points[i + 1], mesh.Points[i + 2]);
  }
  faces.Corners = mesh.Corners;
  // These go around clockwise from outside.
  for (std::size_t i = 0; i < faces.Corners.size(); i += 3)
  {
    std::swap(faces.Corners[i], faces.Corners[i + 1]);
  }
  faces.Project();
  return faces;
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
  faces.Project();
  return faces;
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
