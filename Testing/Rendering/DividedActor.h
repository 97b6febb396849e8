/**
 * Actors whose mappers draw parts one by one.
 */
#ifndef VITRINE_DIVIDED_ACTOR_H
#define VITRINE_DIVIDED_ACTOR_H

#include "CullerScene.h"

#include "vtkCellData.h"
#include "vtkCulledCompositePolyDataMapper.h"
#include "vtkCulledPolyDataMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <vector>

/** A grid of quads in the plane of height z. */
inline std::vector<Quad> Grid(double x0, double y0, double x1, double y1, double z, int cells)
{
  const auto x = [&](int i) { return x0 + (x1 - x0) * i / cells; };
  const auto y = [&](int i) { return y0 + (y1 - y0) * i / cells; };
  std::vector<Quad> quads;
  for (int i = 0; i < cells * cells; ++i)
  {
    const int column = i % cells, row = i / cells;
    quads.push_back(Rectangle(x(column), y(row), x(column + 1), y(row + 1), z));
  }
  return quads;
}

using PartsOfQuads = std::vector<std::vector<Quad>>;

constexpr int PatchCells = 12; ///< so that a patch has 288 triangles: enough for a part of a mesh

/** 30 patches in one layer: behind a wall at 0 if z is less. */
inline PartsOfQuads Patches(double z = -0.4)
{
  PartsOfQuads patches;
  for (int i = 0; i < 30; ++i)
  {
    const double x = 0.28 * (i % 6) - 0.8, y = 0.3 * (i / 6) - 0.75;
    patches.push_back(Grid(x, y, x + 0.2, y + 0.2, z, PatchCells));
  }
  return patches;
}

constexpr int PatchCount = 30;

/** A wall over all that stands behind it, and those patches. */
inline PartsOfQuads WallAndPatches()
{
  PartsOfQuads parts = Patches();
  parts.insert(parts.begin(), Grid(-2.5, -2.5, 2.5, 2.5, 0.0, PatchCells));
  return parts;
}

/** A mesh of quads, each of a colour of its own. */
inline vtkSmartPointer<vtkPolyData> ColoredMeshOf(
  const std::vector<Quad>& quads, TestRandom& random)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < 3 * quads.size(); ++i)
  {
    colors->InsertNextValue(static_cast<unsigned char>(random.Next() % 256));
  }
  const vtkSmartPointer<vtkPolyData> mesh = MeshOf(quads);
  mesh->GetCellData()->SetScalars(colors);
  return mesh;
}

enum class Division
{
  Blocks, ///< of a composite data set
  Leaves  ///< of one mesh
};

inline vtkSmartPointer<vtkMapper> DividedMapperOf(Division kind, const PartsOfQuads& parts)
{
  TestRandom random(313);
  if (kind == Division::Blocks)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    for (const std::vector<Quad>& part : parts)
    {
      blocks->SetBlock(blocks->GetNumberOfBlocks(), ColoredMeshOf(part, random));
    }
    auto mapper = vtkSmartPointer<vtkCulledCompositePolyDataMapper>::New();
    mapper->SetInputDataObject(blocks);
    return mapper;
  }
  std::vector<Quad> quads;
  for (const std::vector<Quad>& part : parts)
  {
    quads.insert(quads.end(), part.begin(), part.end());
  }
  auto mapper = vtkSmartPointer<vtkCulledPolyDataMapper>::New();
  mapper->SetInputData(ColoredMeshOf(quads, random));
  return mapper;
}

#endif
