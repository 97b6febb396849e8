/**
 * Translucent geometry whose size counts in pixels, which a larger target would draw thinner.
 */
#ifndef VITRINE_TRANSPARENCY_STENCIL_PIXEL_SIZED_PRIMITIVES_H
#define VITRINE_TRANSPARENCY_STENCIL_PIXEL_SIZED_PRIMITIVES_H

#include <string>

class vtkRenderState;

namespace vitrine
{

/** Why the state's translucent props cannot be drawn into a larger target: lines or points. Empty if they can. */
std::string FindPixelSizedPrimitives(const vtkRenderState* s);

}
#endif
