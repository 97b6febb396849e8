/**
 * What VTK itself offers for translucent geometry.
 */
#ifndef VITRINE_VTK_METHODS_H
#define VITRINE_VTK_METHODS_H

#include "methods/Method.h"

#include <vector>

namespace program
{

/** VTK's mapper with plain alpha blending, in the order of the actors. */
std::unique_ptr<Method> MakeBlend();

/** vtkOrderIndependentTranslucentPass: what VTK does by default. */
std::unique_ptr<Method> MakeVTKOIT();

/** vtkDualDepthPeelingPass with at most that many peels, each of which takes off two layers. */
std::unique_ptr<Method> MakeVTKPeeling(int peels);

/** The classes of the passes of all of these, which draw what those of VTK's draw that they are derived from. */
std::vector<const char*> PassesOfVTKMethods();

}
#endif
