/**
 * The numbers that parts have at their points and cells.
 */
#ifndef VITRINE_DATA_ARRAYS_H
#define VITRINE_DATA_ARRAYS_H

#include "scene/Scene.h"

#include "vtkDataArray.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace program
{

/** An array of one name at points or at cells, of all the parts that have it. */
struct DataArray
{
  std::string Name;
  bool IsAtCells = false;
  int Components = 1;
  std::size_t Parts = 0;
  std::optional<std::array<double, 2>>
    Range; ///< of finite values, or of magnitudes of several components; without if there are none
};

/** Arrays of all parts in the order of their names. Normals, tangents, texture coordinates and colours are none. */
std::vector<DataArray> ListDataArrays(const Scene& scene);

/** Names for a message: "'T' (points), 'stress' (cells)". */
std::string NameDataArrays(const std::vector<DataArray>& arrays);

/** One value of each tuple: a component, or, without one, the only component or the magnitude. */
std::vector<double> ValuesOf(vtkDataArray* array, const std::optional<int>& component);

/** Widen a range by the finite values. */
void Widen(std::optional<std::array<double, 2>>& range, const std::vector<double>& values);

}
#endif
