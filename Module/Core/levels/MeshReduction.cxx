#include "Core/levels/MeshReduction.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <OpenMesh/Core/Geometry/QuadricT.hh> // which needs the former
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>

#include <algorithm>
#include <array>
#include <mutex>

namespace vitrine
{

namespace
{

struct DoubleTraits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using OpenMesh::FaceHandle;
using OpenMesh::VertexHandle;
using Side = OpenMesh::HalfedgeHandle;
using Quadric = OpenMesh::Geometry::QuadricT<double>;
using Vector = OpenMesh::Vec3d;

/**
 * OpenMesh's mesh, with two functions that the decimater asks of each possible move. Those of Debian's library check
 * assertions, which take most of the time.
 *
 * They look at the vertices around one. Each move has the decimater ask about all neighbours, so the hub of a fan would
 * take the cube of its triangles' number. So a *hub*, a vertex of many neighbours, takes no part in any move, and the
 * number of neighbours is known without a look around.
 */
class SurfaceMesh : public OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>
{
public:
  /** Counts the neighbours of all vertices. Moves are to be told from then on. */
  void CountNeighbours()
  {
    this->Neighbours.assign(this->n_vertices(), 0);
    for (const auto edge : this->edges())
    {
      const Side side = this->halfedge_handle(edge, 0);
      ++this->CountAt(this->to_vertex_handle(side));
      ++this->CountAt(this->from_vertex_handle(side));
    }
  }

  /** Tells that a side's first vertex is about to move onto its second one. */
  void NoteMove(Side side)
  {
    const Side back = this->opposite_halfedge_handle(side);
    std::uint32_t shared = 2; // the two are no longer neighbours of each other
    for (const VertexHandle third : { this->ThirdCorner(side), this->ThirdCorner(back) })
    {
      if (third.is_valid())
      {
        --this->CountAt(third);
        ++shared;
      }
    }
    const VertexHandle to = this->to_vertex_handle(side);
    this->CountAt(to) += this->CountAt(this->to_vertex_handle(back)) - shared;
  }

  Side find_halfedge(VertexHandle from, VertexHandle to)
  {
    if (this->CountAt(from) > this->CountAt(to))
    {
      const Side back = this->find_halfedge(to, from);
      return back.is_valid() ? this->opposite_halfedge_handle(back) : back;
    }
    for (auto side = this->cvoh_iter(from); side.is_valid(); ++side)
    {
      if (this->to_vertex_handle(*side) == to)
      {
        return *side;
      }
    }
    return Side();
  }

  /**
   * Returns true if the mesh stays a manifold when a side's first vertex moves onto its second one. The rings around
   * both then have nothing in common but the third corners of the triangles between them.
   */
  bool is_collapse_ok(Side side)
  {
    const Side back = this->opposite_halfedge_handle(side);
    const VertexHandle from = this->to_vertex_handle(back);
    const VertexHandle to = this->to_vertex_handle(side);
    if (this->IsHub(from) || this->IsHub(to) || this->status(this->edge_handle(side)).deleted() ||
      this->IsEar(side) || this->IsEar(back))
    {
      return false;
    }
    const VertexHandle left = this->ThirdCorner(side);
    const VertexHandle right = this->ThirdCorner(back);
    if (left == right)
    {
      return false;
    }
    this->Seen.resize(this->n_vertices(), 0);
    ++this->Turn;
    for (auto near = this->cvv_iter(to); near.is_valid(); ++near)
    {
      this->Seen[near->idx()] = this->Turn;
    }
    for (auto near = this->cvv_iter(from); near.is_valid(); ++near)
    {
      if (this->Seen[near->idx()] == this->Turn && *near != left && *near != right)
      {
        return false;
      }
    }
    return this->is_boundary(side) || this->is_boundary(back) || !this->is_boundary(from) ||
      !this->is_boundary(to);
  }

private:
  static constexpr std::uint32_t MostNeighbours = 100;

  std::uint32_t& CountAt(VertexHandle vertex)
  {
    return this->Neighbours[static_cast<std::size_t>(vertex.idx())];
  }
  bool IsHub(VertexHandle vertex) { return this->CountAt(vertex) > MostNeighbours; }

  VertexHandle ThirdCorner(Side side) const
  {
    return this->is_boundary(side) ? VertexHandle()
                                   : this->to_vertex_handle(this->next_halfedge_handle(side));
  }

  /** Returns true if the other two sides of the triangle of a side are open. */
  bool IsEar(Side side) const
  {
    const Side next = this->next_halfedge_handle(side);
    return !this->is_boundary(side) && this->is_boundary(this->opposite_halfedge_handle(next)) &&
      this->is_boundary(this->opposite_halfedge_handle(this->next_halfedge_handle(next)));
  }

  std::vector<std::uint32_t> Neighbours; ///< for each vertex, how many it has
  std::vector<std::uint32_t>
    Seen; ///< for each vertex the turn in which it was in the ring of the second one
  std::uint32_t Turn = 0;
};

/** The vertices and wedges of a triangle. */
struct FaceCorners
{
  std::array<std::uint32_t, 3> Vertices;
  std::array<std::uint32_t, 3> Wedges;

  int PlaceOf(VertexHandle vertex) const
  {
    const auto number = static_cast<std::uint32_t>(vertex.idx());
    return this->Vertices[0] == number ? 0 : this->Vertices[1] == number ? 1 : 2;
  }
  std::uint32_t WedgeOf(VertexHandle vertex) const { return this->Wedges[this->PlaceOf(vertex)]; }
};

/** The wedges that wedges of a vertex become when it moves along an edge. */
struct WedgeMove
{
  std::array<std::uint32_t, 2> From;
  std::array<std::uint32_t, 2> To;

  bool Has(std::uint32_t wedge) const { return wedge == this->From[0] || wedge == this->From[1]; }
  std::uint32_t Of(std::uint32_t wedge) const
  {
    return wedge == this->From[0] ? this->To[0] : this->To[1];
  }
  bool IsUnique() const { return this->From[0] != this->From[1] || this->To[0] == this->To[1]; }
};

/** What the decimater asks about each move, and tells before it. */
template <class Mesh>
class MoveRules : public OpenMesh::Decimater::ModBaseT<Mesh>
{
public:
  using Rules = OpenMesh::Decimater::ModBaseT<Mesh>;
  using Move = typename Rules::CollapseInfo;
  using Handle = OpenMesh::Decimater::ModHandleT<MoveRules>;

  explicit MoveRules(Mesh& mesh)
    : Rules(mesh, false)
  {
  }

  std::vector<FaceCorners> Corners; ///< for each face
  std::vector<Quadric> Quadrics;    ///< for each vertex
  std::vector<std::uint8_t> Stays;  ///< for each vertex, 1 if it takes no part in any move
  const std::vector<std::uint32_t>* Colors = nullptr;

  void FindQuadrics()
  {
    Mesh& mesh = this->mesh();
    this->Quadrics.assign(mesh.n_vertices(), Quadric());
    for (auto& quadric : this->Quadrics)
    {
      quadric.clear();
    }
    for (const auto face : mesh.faces())
    {
      const Vector normal = this->AreaNormalOf(face);
      const double doubled = normal.norm();
      for (auto side = mesh.fh_iter(face); doubled > 0 && side.is_valid(); ++side)
      {
        const VertexHandle from = mesh.from_vertex_handle(*side);
        const VertexHandle to = mesh.to_vertex_handle(*side);
        const Vector unit = normal / doubled;
        this->Quadrics[to.idx()] += this->PlaneThrough(to, unit, doubled / 2);
        if (this->IsSeam(*side))
        {
          const Vector edge = mesh.point(to) - mesh.point(from);
          const Quadric across = this->PlaneThrough(to, (edge % unit).normalized(), edge.sqrnorm());
          this->Quadrics[from.idx()] += across;
          this->Quadrics[to.idx()] += across;
        }
      }
    }
  }

  float collapse_priority(const Move& move) override
  {
    if (this->Stays[move.v0.idx()] != 0 || this->Stays[move.v1.idx()] != 0)
    {
      return Rules::ILLEGAL_COLLAPSE;
    }
    const WedgeMove wedges = this->WedgesOf(move);
    if (!wedges.IsUnique() || !this->KeepsTheRing(move, wedges))
    {
      return Rules::ILLEGAL_COLLAPSE;
    }
    Quadric sum = this->Quadrics[move.v0.idx()];
    sum += this->Quadrics[move.v1.idx()];
    const double length = (move.p1 - move.p0).sqrnorm();
    // Of moves in one plane the shortest comes first, which keeps triangles round.
    return static_cast<float>(std::max(sum(move.p1), 0.0) + 1e-7 * length * length);
  }

  void preprocess_collapse(const Move& move) override
  {
    const WedgeMove wedges = this->WedgesOf(move);
    for (auto face = this->mesh().vf_iter(move.v0); face.is_valid(); ++face)
    {
      if (*face != move.fl && *face != move.fr)
      {
        FaceCorners& corners = this->Corners[face->idx()];
        const int place = corners.PlaceOf(move.v0);
        corners.Vertices[place] = static_cast<std::uint32_t>(move.v1.idx());
        corners.Wedges[place] = wedges.Of(corners.Wedges[place]);
      }
    }
    this->Quadrics[move.v1.idx()] += this->Quadrics[move.v0.idx()];
    this->mesh().NoteMove(move.v0v1);
  }

private:
  Quadric PlaneThrough(VertexHandle vertex, const Vector& unit, double weight)
  {
    Quadric quadric(unit[0], unit[1], unit[2], -(unit | this->mesh().point(vertex)));
    quadric *= weight;
    return quadric;
  }

  Vector AreaNormalOf(FaceHandle face)
  {
    const auto& corners = this->Corners[face.idx()].Vertices;
    const auto at = [&](int k)
    { return this->mesh().point(VertexHandle(static_cast<int>(corners[k]))); };
    return (at(1) - at(0)) % (at(2) - at(0));
  }

  /** Returns true if a side is open, or has other wedges on its other side. */
  bool IsSeam(Side side)
  {
    Mesh& mesh = this->mesh();
    const FaceHandle here = mesh.face_handle(side);
    const FaceHandle there = mesh.opposite_face_handle(side);
    const auto differ = [&](VertexHandle vertex) {
      return this->Corners[here.idx()].WedgeOf(vertex) !=
        this->Corners[there.idx()].WedgeOf(vertex);
    };
    return !there.is_valid() || differ(mesh.from_vertex_handle(side)) ||
      differ(mesh.to_vertex_handle(side));
  }

  WedgeMove WedgesOf(const Move& move) const
  {
    const FaceHandle left = move.fl.is_valid() ? move.fl : move.fr;
    const FaceHandle right = move.fr.is_valid() ? move.fr : move.fl;
    const FaceCorners& onLeft = this->Corners[left.idx()];
    const FaceCorners& onRight = this->Corners[right.idx()];
    return { { onLeft.WedgeOf(move.v0), onRight.WedgeOf(move.v0) },
      { onLeft.WedgeOf(move.v1), onRight.WedgeOf(move.v1) } };
  }

  /** Returns true if the triangles that follow a move keep their sides, wedges and colours. */
  bool KeepsTheRing(const Move& move, const WedgeMove& wedges)
  {
    for (auto face = this->mesh().vf_iter(move.v0); face.is_valid(); ++face)
    {
      const FaceCorners& corners = this->Corners[face->idx()];
      const bool remains = *face != move.fl && *face != move.fr;
      if (!wedges.Has(corners.WedgeOf(move.v0)) || !this->IsOfOneColor(corners) ||
        (remains && this->Turns(corners, move)))
      {
        return false;
      }
    }
    return true;
  }

  bool IsOfOneColor(const FaceCorners& corners) const
  {
    const auto color = [&](int k) { return (*this->Colors)[corners.Wedges[k]]; };
    return this->Colors->empty() || (color(0) == color(1) && color(1) == color(2));
  }

  bool Turns(const FaceCorners& corners, const Move& move)
  {
    const int place = corners.PlaceOf(move.v0);
    const Vector a =
      this->mesh().point(VertexHandle(static_cast<int>(corners.Vertices[(place + 1) % 3])));
    const Vector b =
      this->mesh().point(VertexHandle(static_cast<int>(corners.Vertices[(place + 2) % 3])));
    const Vector before = (a - move.p0) % (b - move.p0);
    const Vector after = (a - move.p1) % (b - move.p1);
    const double along = before | after;
    return along < 0 ||
      along * along < CosineOfTurn * CosineOfTurn * before.sqrnorm() * after.sqrnorm();
  }

  static constexpr double CosineOfTurn = 0.25; // 75 degrees
};

/** Has the decimater stop when it is told to. */
class StopObserver : public OpenMesh::Decimater::Observer
{
public:
  explicit StopObserver(const std::atomic<bool>& isStopped)
    : Observer(16)
    , IsStopped(isStopped)
  {
  }
  void notify(std::size_t) override {}
  bool abort() const override { return this->IsStopped; }

private:
  const std::atomic<bool>& IsStopped;
};

/** Silences OpenMesh, which writes a line to its error stream for each face that it refuses. */
class Quiet
{
public:
  Quiet()
    : Turn(OneAtATime)
    , WasEnabled(omerr().is_enabled())
  {
    omerr().disable();
  }
  ~Quiet()
  {
    if (this->WasEnabled)
    {
      omerr().enable();
    }
  }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

private:
  static inline std::mutex OneAtATime;
  std::lock_guard<std::mutex> Turn;
  bool WasEnabled;
};

}

class MeshReduction::Work
{
public:
  using Decimater = OpenMesh::Decimater::DecimaterT<SurfaceMesh>;
  using Rules = MoveRules<SurfaceMesh>;

  explicit Work(const WeldedMesh& mesh)
    : Colors(mesh.Colors)
    , Reducer(Surface)
  {
    Rules::Handle handle;
    this->Reducer.add(handle);
    this->Reducer.initialize();
    this->Moves = &this->Reducer.module(handle);
    this->Moves->Colors = &this->Colors;
    this->AddFaces(mesh);
    this->KeepKnots();
    this->Surface.CountNeighbours();
    this->Moves->FindQuadrics();
  }

  void ReduceTo(std::size_t triangles, const std::atomic<bool>& isStopped)
  {
    StopObserver observer(isStopped);
    this->Reducer.set_observer(&observer);
    while (this->Left > triangles && !isStopped)
    {
      // A move of an inner vertex takes two triangles away, and one along an open edge takes one.
      const std::size_t moves = (this->Left - triangles + 1) / 2;
      const std::size_t made = this->Reducer.decimate(moves);
      this->Count();
      if (made < moves)
      {
        break;
      }
    }
    this->Reducer.set_observer(nullptr);
  }

  std::vector<std::uint32_t> Triangles() const
  {
    std::vector<std::uint32_t> triangles;
    triangles.reserve(3 * this->Left);
    for (const auto face : this->Surface.faces())
    {
      const auto& wedges = this->Moves->Corners[face.idx()].Wedges;
      triangles.insert(triangles.end(), wedges.begin(), wedges.end());
    }
    return triangles;
  }

  std::size_t Unfit = 0;

private:
  void AddFaces(const WeldedMesh& mesh)
  {
    const Quiet quiet;
    this->Surface.reserve(mesh.Places.size(), mesh.Vertices.size() / 2, mesh.Vertices.size() / 3);
    for (const glm::dvec3& place : mesh.Places)
    {
      this->AddVertex(place);
    }
    for (std::size_t i = 0; i < mesh.Vertices.size(); i += 3)
    {
      std::array<VertexHandle, 3> corners;
      std::transform(&mesh.Vertices[i], &mesh.Vertices[i] + 3, corners.begin(),
        [](std::uint32_t vertex) { return VertexHandle(static_cast<int>(vertex)); });
      const std::array<VertexHandle, 3> turned{ corners[2], corners[1], corners[0] };
      if (!this->Surface.add_face(corners.data(), 3).is_valid() &&
        !this->Surface.add_face(turned.data(), 3).is_valid())
      {
        this->AddUnfit(corners);
      }
      const auto number = [](VertexHandle vertex)
      { return static_cast<std::uint32_t>(vertex.idx()); };
      this->Moves->Corners.push_back(
        { { number(corners[0]), number(corners[1]), number(corners[2]) },
          { mesh.Wedges[i], mesh.Wedges[i + 1], mesh.Wedges[i + 2] } });
    }
    this->Left = this->Surface.n_faces();
  }

  VertexHandle AddVertex(const glm::dvec3& place)
  {
    this->Moves->Stays.push_back(0);
    return this->Surface.add_vertex({ place.x, place.y, place.z });
  }

  /** Adds a triangle with vertices of its own. */
  void AddUnfit(std::array<VertexHandle, 3>& corners)
  {
    for (VertexHandle& corner : corners)
    {
      this->Moves->Stays[corner.idx()] = 1;
      const Vector place = this->Surface.point(corner);
      corner = this->AddVertex({ place[0], place[1], place[2] });
      this->Moves->Stays.back() = 1;
    }
    this->Surface.add_face(corners.data(), 3);
    ++this->Unfit;
  }

  /** Lets vertices stay at which more than one surface ends. */
  void KeepKnots()
  {
    for (const auto vertex : this->Surface.vertices())
    {
      if (!this->Surface.is_manifold(vertex))
      {
        this->Moves->Stays[vertex.idx()] = 1;
      }
    }
  }

  void Count()
  {
    std::size_t left = 0;
    for (const auto face : this->Surface.faces()) // those that are not deleted
    {
      static_cast<void>(face);
      ++left;
    }
    this->Left = left;
  }

  std::vector<std::uint32_t> Colors;
  SurfaceMesh Surface;
  Decimater Reducer;
  Rules* Moves = nullptr; ///< It belongs to Reducer.
  std::size_t Left = 0;
};

MeshReduction::MeshReduction(const WeldedMesh& mesh)
  : Mesh(std::make_unique<Work>(mesh))
{
}

MeshReduction::~MeshReduction() = default;

void MeshReduction::ReduceTo(std::size_t triangles, const std::atomic<bool>& isStopped)
{
  this->Mesh->ReduceTo(triangles, isStopped);
}

std::vector<std::uint32_t> MeshReduction::Triangles() const
{
  return this->Mesh->Triangles();
}

std::size_t MeshReduction::CountOfUnfit() const
{
  return this->Mesh->Unfit;
}

}
