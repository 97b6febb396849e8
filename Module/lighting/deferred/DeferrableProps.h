/**
 * Decides which props can be drawn into a G-buffer.
 */
#ifndef VITRINE_LIGHTING_DEFERRED_DEFERRABLE_PROPS_H
#define VITRINE_LIGHTING_DEFERRED_DEFERRABLE_PROPS_H

#include <vector>

class vtkProp;
class vtkRenderPass;
class vtkRenderState;

namespace vitrine
{

/** The props of a state, in their order. */
struct SortedProps
{
  std::vector<vtkProp*> Deferrable; ///< opaque actors whose mappers let passes change their shaders
  std::vector<vtkProp*> Others;
};

/** @param pass  the only pass that may change the shaders of deferrable props */
SortedProps SortProps(const vtkRenderState* s, vtkRenderPass* pass);

/**
 * Returns the largest distance in pixels between a fragment of deferrable props and the position where it is lit.
 * Fragments of wide lines and points are lit at the middle of the line or point.
 */
double PixelsAside(const vtkRenderState* s);

}

#endif
