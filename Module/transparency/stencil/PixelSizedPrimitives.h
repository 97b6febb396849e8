/** Finds translucent geometry whose size is given in pixels. An enlarged target would draw it thinner. */
#ifndef VITRINE_TRANSPARENCY_STENCIL_PIXEL_SIZED_PRIMITIVES_H
#define VITRINE_TRANSPARENCY_STENCIL_PIXEL_SIZED_PRIMITIVES_H

#include <string>

class vtkRenderState;

namespace vitrine
{

/**
 * Returns why the state's translucent props cannot be drawn into an enlarged target (lines or points), or an empty
 * string.
 */
std::string FindPixelSizedPrimitives(const vtkRenderState* s);

}
#endif
