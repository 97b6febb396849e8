/** Parts that a pattern chooses, for VTK's wrapped methods. */
#ifndef VITRINE_ASSEMBLY_FOUND_PARTS_H
#define VITRINE_ASSEMBLY_FOUND_PARTS_H

#include "Core/assembly/PartPattern.h"

#include <string>
#include <vector>

class vtkIdList;

namespace vitrine
{

/** Lists the numbers of the parts that a pattern chooses. Returns an empty string, or why there are none. */
std::string FindParts(
  const std::vector<PartNames>& names, const std::string& pattern, vtkIdList* parts);

}

#endif
