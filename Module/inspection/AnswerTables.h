#ifndef VITRINE_INSPECTION_ANSWER_TABLES_H
#define VITRINE_INSPECTION_ANSWER_TABLES_H

#include "inspection/IndexedParts.h"

#include <vector>

class vtkTable;

namespace vitrine
{

/** Write the answers of vtkAssemblyIndex into a table, in place of what it had. Its header names the columns. */
void WriteCrossings(vtkTable* table, const Ray& ray, const std::vector<IndexedCrossing>& crossings);
void WriteWalls(vtkTable* table, const std::vector<Wall>& walls);
void WriteClashes(vtkTable* table, const std::vector<Clash>& clashes);

}

#endif
