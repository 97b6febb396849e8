/** The results of `layers` for people and for programs. */
#ifndef VITRINE_LAYERS_REPORT_H
#define VITRINE_LAYERS_REPORT_H

#include <array>
#include <string>
#include <vector>

namespace program
{

/** A layer of a pixel, as vtkLayerPicker tells it. */
struct LayerRow
{
  std::string Part; ///< the part's path
  double Depth = 0.0;
  double Distance = 0.0;
  std::array<double, 3> Position{};
  std::array<double, 3> Color{};
  double Opacity = 0.0;
  double Share = 0.0;
  bool IsFront = false;
  bool IsOpaque = false;
};

struct LayersTable
{
  std::string Scene;
  std::array<int, 2> Size{};
  std::array<int, 2> Pixel{};
  std::vector<LayerRow> Layers; ///< from front to back
};

/** A line for each layer. */
std::string ToText(const LayersTable& table);
std::string ToJson(const LayersTable& table);

}
#endif
