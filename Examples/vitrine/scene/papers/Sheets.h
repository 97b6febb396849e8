/**
 * Textured sheets, one behind the other.
 */
#ifndef VITRINE_PAPERS_SHEETS_H
#define VITRINE_PAPERS_SHEETS_H

#include "scene/Random.h"
#include "scene/Scene.h"

#include <vector>

namespace program
{

struct SheetSettings
{
  int Count = 0;
  int Triangles = 0;       ///< of all sheets together; at least three for each
  double HalfWidth = 0.0;  ///< of the largest sheet
  double HalfHeight = 0.0; ///< likewise
  double HalfDepth = 0.0;  ///< of where their middles lie, along z
};

/**
 * Sheets across the z axis, tilted a little, so that they cut each other. A sheet is a plane fan of triangles
 * with the outline of a flower, and so adds at most one layer to a pixel from wherever it is seen. All
 * of them cover the surroundings of the z axis; the larger ones go further, so that layers become fewer
 * from the middle outwards.
 */
std::vector<Part> MakeSheets(const SheetSettings& settings, Random& random);

}
#endif
