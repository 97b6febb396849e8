/**
 * The parts of a scene as a tree, for people and for programs: what `info --parts` tells.
 */
#ifndef VITRINE_PARTS_REPORT_H
#define VITRINE_PARTS_REPORT_H

#include "report/Json.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace program
{

struct PartInfo
{
  std::string Path;     ///< names from the root of the tree, each after a slash
  std::string Material; ///< its name; may be empty
  std::int64_t Triangles = 0;
  double Opacity = 1.0;
  bool IsTranslucent = false;
  bool IsClosed = false; ///< each edge has two triangles, so that the part has an inside
  std::array<double, 6> Bounds{};
};

/** The tree with a line for each node. A node that is no part tells how many parts and triangles are below it. */
std::string PartsText(const std::vector<PartInfo>& parts);

/** One object for each part, in the order of the tree. */
Json PartsJson(const std::vector<PartInfo>& parts);

}
#endif
