#include "assembly/PartDetail.h"

#include "assembly/CadCache.h"
#include "assembly/LevelFile.h"
#include "assembly/PartLooks.h"
#include "scene/PartTriangles.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace vitrine
{

namespace
{

constexpr vtkIdType CellsOfASecond = 100000; ///< whose levels take about a second
constexpr std::uint64_t BytesOfCache = std::uint64_t{ 1 } << 30;

std::vector<glm::vec3> NormalsOf(vtkPolyData* geometry)
{
  vtkDataArray* const normals = geometry->GetPointData()->GetNormals();
  std::vector<glm::vec3> read;
  for (vtkIdType i = 0; normals && i < normals->GetNumberOfTuples(); ++i)
  {
    double normal[3];
    normals->GetTuple(i, normal);
    const double length =
      std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    read.emplace_back(glm::dvec3(normal[0], normal[1], normal[2]) / (length > 0 ? length : 1.0));
  }
  return read;
}

/** Returns the colours of points, which are bytes, as numbers. */
std::vector<std::uint32_t> ColorsOf(vtkPolyData* geometry)
{
  std::vector<std::uint32_t> read;
  if (!HasColors(geometry))
  {
    return read;
  }
  vtkDataArray* const colors = geometry->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
  {
    std::uint32_t color = 0;
    for (int channel = 0; channel < colors->GetNumberOfComponents(); ++channel)
    {
      color = color << 8 | (static_cast<std::uint32_t>(colors->GetComponent(i, channel)) & 0xff);
    }
    read.push_back(color);
  }
  return read;
}

bool HasCells(vtkCellArray* cells)
{
  return cells && cells->GetNumberOfCells() > 0;
}

}

bool HasTrianglesAlone(vtkPolyData* geometry)
{
  return !HasCells(geometry->GetVerts()) && !HasCells(geometry->GetLines()) &&
    (HasCells(geometry->GetPolys()) || HasCells(geometry->GetStrips()));
}

std::shared_ptr<const PartDetail> MakePartDetail(
  const DetailedMesh& mesh, std::vector<MeshLevel> levels, const std::atomic<bool>& isStopped)
{
  if (!IsUsable(mesh))
  {
    return nullptr;
  }
  auto detail = std::make_shared<PartDetail>();
  detail->Whole = mesh.Corners;
  detail->Levels = std::move(levels);
  const double area = AreaOf(mesh.Points, detail->Whole);
  for (const MeshLevel& level : detail->Levels)
  {
    detail->Shares.push_back(area > 0 ? AreaOf(mesh.Points, level.Corners) / area : 1.0);
  }
  detail->Speck = SpeckOf(mesh, isStopped);
  return detail;
}

DetailedMesh DetailedMeshOf(vtkPolyData* geometry)
{
  PartTriangles triangles = ReadTriangles(geometry);
  return { std::move(triangles.Points), std::move(triangles.Corners), NormalsOf(geometry),
    ColorsOf(geometry) };
}

DetailWork::DetailWork(Geometries geometries, bool useCache)
  : Work(std::move(geometries))
  , UseCache(useCache)
  , Made(Work.size())
{
  for (std::size_t i = 0; i < this->Work.size(); ++i)
  {
    this->PlaceOf.emplace(this->Work[i], i);
    this->Times.push_back(this->Work[i]->GetMTime());
  }
  this->Thread = std::thread([this] { this->Run(); });
}

DetailWork::~DetailWork()
{
  this->IsStopped = true;
  this->Wait();
}

void DetailWork::Run()
{
  const vtkIdType cells = std::accumulate(this->Work.begin(), this->Work.end(), vtkIdType{ 0 },
    [](vtkIdType sum, vtkPolyData* geometry) { return sum + geometry->GetNumberOfCells(); });
  if (this->UseCache && cells >= CellsOfASecond)
  {
    this->MakeByCache(CadCache({}, BytesOfCache, "levels", ".levels"));
  }
  else
  {
    this->Make();
  }
}

void DetailWork::MakeByCache(const CadCache& cache)
{
  const bool isUsable = cache.Problem().empty();
  const std::string key = isUsable ? KeyOfLevels(this->Work, this->IsStopped) : std::string();
  if (isUsable && !this->IsStopped &&
    ReadLevels(cache, key, this->Work, this->IsStopped, this->Made))
  {
    this->Done = this->Work.size();
    return;
  }
  this->Make();
  if (isUsable && !this->IsStopped)
  {
    KeepLevels(cache, key, this->Made);
  }
}

void DetailWork::Make()
{
  for (std::size_t i = 0; i < this->Work.size() && !this->IsStopped; ++i)
  {
    const DetailedMesh mesh = DetailedMeshOf(this->Work[i]);
    this->Made[i] = MakePartDetail(mesh, LevelsOf(mesh, this->IsStopped).Levels, this->IsStopped);
    ++this->Done;
  }
}

void DetailWork::Wait()
{
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
}

std::shared_ptr<const PartDetail> DetailWork::Of(vtkPolyData* geometry) const
{
  const auto found = this->PlaceOf.find(geometry);
  const bool isOfNow =
    found != this->PlaceOf.end() && geometry->GetMTime() == this->Times[found->second];
  return isOfNow ? this->Made[found->second] : nullptr;
}

vtkMTimeType DetailWork::TimeOfChange() const
{
  vtkMTimeType last = 0;
  for (vtkPolyData* const geometry : this->Work)
  {
    last = std::max(last, geometry->GetMTime());
  }
  return last;
}

}
