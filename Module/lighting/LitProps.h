/**
 * Where all is that lights shine on.
 */
#ifndef VITRINE_LIT_PROPS_H
#define VITRINE_LIT_PROPS_H

#include "Core/lighting/LitRegion.h"

class vtkRenderState;

namespace vitrine
{

/**
 * Around all props that are about to be drawn, in view coordinates (VC); all of space where one may be drawn elsewhere than its bounds tell: other classes than actors of
 * polydata, users' shader code. So it is with several samples a pixel, too, as a fragment at an edge is
 * lit where its pixel's midst would be on the face, which may be far off.
 */
LitRegion LitRegionOf(const vtkRenderState* s);

}

#endif
