/**
 * The results of `info` for people and for programs.
 */
#ifndef VITRINE_INFO_REPORT_H
#define VITRINE_INFO_REPORT_H

#include "methods/Stage.h"
#include "report/PartsReport.h"
#include "scene/DataArrays.h"
#include "scene/Scene.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace program
{

struct SceneInfo
{
  std::string Name;
  std::size_t Parts = 0;
  std::size_t TranslucentParts = 0;
  std::int64_t Triangles = 0;
  std::int64_t Lines = 0;
  std::int64_t Points = 0; ///< drawn as points, not corners
  std::size_t Lights = 0;  ///< of its own
  std::size_t Materials = 0;
  std::array<double, 6> Bounds{};
  std::string LengthUnit; ///< of a file whose lengths were converted to metres; may be empty
  PictureSize Size{};
  std::string WhyNoLayers; ///< empty if Layers holds
  MethodStatistics Layers; ///< of translucent geometry, from the view that was asked for
  std::string Expectation; ///< how methods do on it; may be empty
  std::vector<SkippedPart> Skipped;
  std::vector<std::string> Notes;
  std::vector<DataArray> Arrays;
  std::optional<std::vector<PartInfo>> Tree; ///< all parts, where they were asked for
};

std::string ToText(const SceneInfo& info);
std::string ToJson(const SceneInfo& info);

}
#endif
