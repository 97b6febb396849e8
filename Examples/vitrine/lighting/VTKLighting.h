/**
 * Lights as VTK draws them by itself.
 */
#ifndef VITRINE_VTK_LIGHTING_H
#define VITRINE_VTK_LIGHTING_H

#include "lighting/LightingMode.h"

namespace program
{

std::unique_ptr<LightingMode> MakeVTKLighting();

}
#endif
