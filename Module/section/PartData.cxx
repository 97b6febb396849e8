#include "section/PartData.h"

#include "scene/PartNumbers.h"
#include "scene/ScalarColors.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkDataSetMapper.h"
#include "vtkMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersionMacros.h"

#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 3
#include "vtkCompositePolyDataMapper2.h"
#else
#include "vtkCompositePolyDataMapper.h"
#endif

#include <algorithm>

namespace vitrine
{

namespace
{

#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 3
using CompositeMapper = vtkCompositePolyDataMapper2;
#else
using CompositeMapper = vtkCompositePolyDataMapper;
#endif

/** Returns the data of a mapper without blocks, or null if it has yet to make them. */
vtkPolyData* DataOf(vtkMapper* mapper)
{
  if (auto* const surface = vtkDataSetMapper::SafeDownCast(mapper))
  {
    if (auto* const given = vtkPolyData::SafeDownCast(surface->GetInput()))
    {
      return given;
    }
    vtkPolyDataMapper* const within = surface->GetPolyDataMapper();
    return within ? within->GetInput() : nullptr;
  }
  auto* const drawing = vtkPolyDataMapper::SafeDownCast(mapper);
  return drawing ? drawing->GetInput() : nullptr;
}

/** Visits the blocks below a node. `drawn` is what the node inherits. Returns the flat index after its last node. */
unsigned int VisitBlocks(vtkDataObject* node, DrawnData drawn, bool isVisible,
  vtkCompositeDataDisplayAttributes* attributes, const std::function<void(const DrawnData&)>& visit)
{
  if (attributes && node)
  {
    isVisible =
      attributes->HasBlockVisibility(node) ? attributes->GetBlockVisibility(node) : isVisible;
    if (attributes->HasBlockColor(node))
    {
      drawn.HasColor = true;
      attributes->GetBlockColor(node, &drawn.Color.x);
    }
    if (attributes->HasBlockOpacity(node))
    {
      drawn.HasOpacity = true;
      drawn.Opacity = attributes->GetBlockOpacity(node);
    }
  }
  unsigned int next = drawn.Block + 1;
  if (auto* const tree = vtkDataObjectTree::SafeDownCast(node))
  {
    for (vtkDataObject* const child : vtk::Range(tree, vtk::DataObjectTreeOptions::None))
    {
      drawn.Block = next;
      next = VisitBlocks(child, drawn, isVisible, attributes, visit);
    }
  }
  else if (auto* const data = vtkPolyData::SafeDownCast(node))
  {
    drawn.Data = data;
    if (isVisible && data->GetNumberOfPoints() > 0)
    {
      visit(drawn);
    }
  }
  return next;
}

/** Returns the mean of the colours of scalars, in [0, 1]. */
glm::vec4 MeanOf(vtkUnsignedCharArray* colors)
{
  const vtkIdType count = colors->GetNumberOfTuples();
  const int components = colors->GetNumberOfComponents();
  const vtkIdType step = std::max<vtkIdType>(1, count / 1024);
  glm::dvec4 sum(0.0);
  double taken = 0.0;
  for (vtkIdType i = 0; i < count; i += step)
  {
    const auto at = [&](int component)
    { return colors->GetValue(i * components + component) / 255.0; };
    sum += components < 3 ? glm::dvec4(at(0), at(0), at(0), components == 2 ? at(1) : 1.0)
                          : glm::dvec4(at(0), at(1), at(2), components == 4 ? at(3) : 1.0);
    taken += 1.0;
  }
  return glm::vec4(sum / std::max(taken, 1.0));
}

/** Returns the colours of the scalars, also where the device looks them up in a texture. */
vtkSmartPointer<vtkUnsignedCharArray> ColorsOf(vtkMapper* mapper, vtkPolyData* data)
{
  if (vtkUnsignedCharArray* const colors = mapper->MapScalars(data, 1.0))
  {
    return colors;
  }
  vtkAbstractArray* const scalars = ScalarsOf(mapper, data);
  return vtk::TakeSmartPointer(
    mapper->GetLookupTable()->MapScalars(scalars, mapper->GetColorMode(), -1));
}

/** Appends the triangles of cells. */
void AddTriangles(
  vtkCellArray* cells, vtkIdType points, bool areStrips, std::vector<std::uint32_t>& corners)
{
  const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(count, ids);
    for (vtkIdType i = 1; i + 1 < count; ++i)
    {
      const vtkIdType triangle[3] = { ids[areStrips ? i - 1 : 0], ids[i], ids[i + 1] };
      if (std::all_of(
            triangle, triangle + 3, [points](vtkIdType id) { return id >= 0 && id < points; }))
      {
        corners.insert(corners.end(), triangle, triangle + 3);
      }
    }
  }
}
}

void ForEachDrawn(vtkActor* actor, const std::function<void(const DrawnData&)>& visit)
{
  vtkMapper* const mapper = actor->GetMapper();
  if (!mapper)
  {
    return;
  }
  mapper->GetBounds(); // updates the pipeline
  if (vtkDataObject* const blocks = CompositeDataOf(actor))
  {
    auto* const composite = CompositeMapper::SafeDownCast(mapper);
    VisitBlocks(blocks, {}, true,
      composite ? composite->GetCompositeDataDisplayAttributes() : nullptr, visit);
    return;
  }
  DrawnData drawn;
  drawn.Data = DataOf(mapper);
  if (drawn.Data && drawn.Data->GetNumberOfPoints() > 0)
  {
    visit(drawn);
  }
}

PartLook LookOf(vtkActor* actor, const DrawnData& drawn)
{
  vtkProperty* const property = actor->GetProperty();
  const double* const diffuse = property->GetDiffuseColor();
  const double* const ambient = property->GetAmbientColor();
  glm::dvec3 diffuseColor(diffuse[0], diffuse[1], diffuse[2]);
  glm::dvec3 ambientColor(ambient[0], ambient[1], ambient[2]);
  double opacity = drawn.HasOpacity ? drawn.Opacity : property->GetOpacity();
  vtkMapper* const mapper = actor->GetMapper();
  if (drawn.HasColor)
  {
    diffuseColor = ambientColor = drawn.Color;
  }
  else if (drawn.Block == 0 && ScalarsOf(mapper, drawn.Data))
  {
    if (const auto colors = ColorsOf(mapper, drawn.Data))
    {
      const glm::vec4 mean = MeanOf(colors);
      diffuseColor = ambientColor = glm::dvec3(mean);
      opacity *= mean.a;
    }
  }
  const bool isPhysical = property->GetInterpolation() == VTK_PBR;
  if (!property->GetLighting())
  {
    // Mappers show the sum of both colours then. Caps are lit, so all of it counts as ambient.
    const glm::dvec3 all = diffuseColor * (isPhysical ? 1.0 : property->GetDiffuse()) +
      ambientColor * (isPhysical ? 0.0 : property->GetAmbient());
    return { glm::vec4(0.0f, 0.0f, 0.0f, opacity), glm::vec4(glm::vec3(all), 0.0f) };
  }
  return { glm::vec4(
             glm::vec3(diffuseColor * (isPhysical ? 1.0 : property->GetDiffuse())), opacity),
    glm::vec4(glm::vec3(ambientColor * (isPhysical ? 0.0 : property->GetAmbient())), 0.0f) };
}

std::vector<glm::dvec3> PointsOfPart(vtkPolyData* data)
{
  std::vector<glm::dvec3> points(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    data->GetPoints()->GetPoint(static_cast<vtkIdType>(i), &points[i].x);
  }
  return points;
}

std::vector<std::uint32_t> TrianglesOfPart(vtkPolyData* data)
{
  std::vector<std::uint32_t> corners;
  AddTriangles(data->GetPolys(), data->GetNumberOfPoints(), false, corners);
  AddTriangles(data->GetStrips(), data->GetNumberOfPoints(), true, corners);
  return corners;
}

}
