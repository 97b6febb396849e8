#include "lighting/deferred/DeferredLists.h"

#include "Core/lighting/TileLists.h"
#include "lighting/forward/RendererLights.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace vitrine
{

namespace
{

ClusterSettings WithoutSlices(ClusterSettings settings)
{
  settings.Slices = 1;
  return settings;
}

// Returns one list with the lights of all rectangles.
LightLists NumberLights(const std::vector<LightRectangle>& rectangles)
{
  LightLists lists;
  for (const LightRectangle& rectangle : rectangles)
  {
    lists.Indices.push_back(rectangle.Light);
  }
  lists.Offsets = { 0, static_cast<std::uint32_t>(rectangles.size()) };
  return lists;
}
}

std::string DeferredLists::Assign(vtkOpenGLRenderer* renderer, const DeferredGrid& grid,
  const RendererLights& lights, const FindMarks& findMarks)
{
  this->Grid.emplace(
    renderer, grid.By == LightsBy::Volume ? WithoutSlices(grid.Clusters) : grid.Clusters);
  std::vector<std::uint8_t> marks = findMarks(*this->Grid);
  const auto start = std::chrono::steady_clock::now();
  this->AssignTo(grid, renderer, lights, marks);
  this->TimeTaken = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return this->Buffers.Write(
    lights.Packed, grid.By == LightsBy::Volume ? NumberLights(this->Volumes) : this->OfGrid);
}

void DeferredLists::AssignTo(const DeferredGrid& grid, vtkOpenGLRenderer* renderer,
  const RendererLights& lights, std::vector<std::uint8_t>& marks)
{
  if (grid.By == LightsBy::Tile)
  {
    MarkBetween(this->Clusters(), marks);
  }
  this->Assigner.Assign(
    this->Clusters(), lights.Volumes, this->OfGrid, marks.empty() ? nullptr : &marks);
  if (grid.By == LightsBy::Tile)
  {
    this->OfGrid = JoinSlices(this->Clusters(), this->OfGrid);
    marks = JoinMarks(this->Clusters(), marks);
    this->Grid.emplace(renderer, WithoutSlices(grid.Clusters));
  }
  else if (grid.By == LightsBy::Volume)
  {
    const double tilesAside = std::ceil(grid.PixelsAside / grid.Clusters.TileSize);
    this->Volumes = RectanglesOf(this->Clusters(), this->OfGrid, static_cast<int>(tilesAside));
    this->OfGrid = CoveredTiles(this->Clusters(), this->Volumes);
    marks.clear(); // all tiles that volumes cover are used
  }
  const auto unused = std::count(marks.begin(), marks.end(), 0);
  this->Used = this->Clusters().Count() - static_cast<std::uint32_t>(unused);
}

void DeferredLists::SetUniforms(vtkShaderProgram* program) const
{
  this->Buffers.SetUniforms(program);
  this->Grid->SetUniforms(program);
}

}
