/**
 * Which props can be drawn into a G-buffer.
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
  std::vector<vtkProp*> Deferrable; ///< opaque actors whose mappers let passes write their shaders
  std::vector<vtkProp*> Others;
};

/** @param pass  the only one that may have a say in the shaders of those that can be deferred */
SortedProps SortProps(const vtkRenderState* s, vtkRenderPass* pass);

/** How many pixels fragments of deferrable props, which have been drawn, may be from where they are lit: those of wide lines and points are lit in their midst. */
double PixelsAside(const vtkRenderState* s);

}

#endif
