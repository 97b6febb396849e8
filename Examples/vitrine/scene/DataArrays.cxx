#include "scene/DataArrays.h"

#include "Join.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace program
{

namespace
{
bool IsForDrawing(vtkDataSetAttributes* data, vtkDataArray* array)
{
  const bool isColor = array == data->GetScalars() && array->GetNumberOfComponents() >= 3;
  return isColor || array == data->GetNormals() || array == data->GetTangents() ||
    array == data->GetTCoords();
}

using Found = std::map<std::pair<std::string, bool>, DataArray>;

void AddArrays(vtkDataSetAttributes* data, bool isAtCells, bool isFirst, Found& found)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = data->GetArray(i);
    if (!array || !array->GetName() || IsForDrawing(data, array))
    {
      continue;
    }
    DataArray& told = found[{ array->GetName(), isAtCells }];
    told.Name = array->GetName();
    told.IsAtCells = isAtCells;
    told.Components = std::max(told.Components, array->GetNumberOfComponents());
    ++told.Parts;
    if (isFirst)
    {
      Widen(told.Range, ValuesOf(array, std::nullopt));
    }
  }
}
}

std::vector<DataArray> ListDataArrays(const Scene& scene)
{
  Found found;
  std::set<vtkPolyData*> seen; // geometry that parts share is looked at once
  for (const Part& part : scene.Parts)
  {
    const bool isFirst = seen.insert(part.Geometry).second;
    AddArrays(part.Geometry->GetPointData(), false, isFirst, found);
    AddArrays(part.Geometry->GetCellData(), true, isFirst, found);
  }
  std::vector<DataArray> arrays;
  for (const auto& [key, array] : found)
  {
    arrays.push_back(array);
  }
  return arrays;
}

std::string NameDataArrays(const std::vector<DataArray>& arrays)
{
  return Join(arrays,
    [](const DataArray& array)
    { return "'" + array.Name + "' (" + (array.IsAtCells ? "cells" : "points") + ")"; });
}

std::vector<double> ValuesOf(vtkDataArray* array, const std::optional<int>& component)
{
  const int components = array->GetNumberOfComponents();
  std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const auto tuple = static_cast<vtkIdType>(i);
    if (component || components == 1)
    {
      values[i] = array->GetComponent(tuple, component.value_or(0));
      continue;
    }
    for (int c = 0; c < components; ++c)
    {
      values[i] = std::hypot(values[i], array->GetComponent(tuple, c));
    }
  }
  return values;
}

void Widen(std::optional<std::array<double, 2>>& range, const std::vector<double>& values)
{
  for (const double value : values)
  {
    if (std::isfinite(value))
    {
      range = range
        ? std::array<double, 2>{ std::min((*range)[0], value), std::max((*range)[1], value) }
        : std::array<double, 2>{ value, value };
    }
  }
}

}
