/**
 * GLB from shapes with triangles.
 */
#ifndef VITRINE_CAD_GLB_FILE_H
#define VITRINE_CAD_GLB_FILE_H

#include "CadFile.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace cad
{

/** What the file tells about itself: members of asset.extras. */
using GlbExtras = std::vector<std::pair<std::string, std::string>>;

/**
 * Write a GLB in metres, Y upwards. Nodes have the names of instances where these say something, and of products
 * elsewhere.
 * @param unnamed  the name of what has none
 * @throws  CadError if it cannot be written; nothing is left then
 */
void WriteGlb(const CadFile& file, const std::filesystem::path& output, const std::string& unnamed,
  const GlbExtras& extras, ProgressLines& progress);

}
#endif
