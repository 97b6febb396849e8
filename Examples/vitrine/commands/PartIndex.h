/** An index of the parts of a scene, for commands that measure. */
#ifndef VITRINE_PROGRAM_PART_INDEX_H
#define VITRINE_PROGRAM_PART_INDEX_H

#include "scene/Scene.h"

#include "vtkAssemblyIndex.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace program
{

/** An index whose parts have the numbers of the scene's. */
vtkSmartPointer<vtkAssemblyIndex> MakePartIndex(const Scene& scene);

/**
 * The number of the one part that has this path or name, or that a GLOB chooses. Throws InputError for none or several.
 * @param option  named in the error
 */
int FindPart(const Scene& scene, const std::string& option, const std::string& text);

}
#endif
