/**
 * Where all is that lights shine on.
 */
#ifndef VITRINE_SCENE_LIT_PROPS_H
#define VITRINE_SCENE_LIT_PROPS_H

#include "Core/geometry/Box.h"
#include "Core/lighting/LitRegion.h"

#include <optional>
#include <vector>

class vtkRenderState;

namespace vitrine
{

/** Around a prop. */
struct LitBox
{
  Box InWorld;
  Box InView; ///< with what shaders' floats may be off
};

/** Props that are about to be drawn. */
struct LitProps
{
  LitRegion Region;                         ///< around all of them, in view coordinates (VC)
  std::optional<std::vector<LitBox>> Boxes; ///< around each, if there is one around all
};

/**
 * The region is all of space where a prop may be drawn elsewhere than its bounds tell: other classes than actors of
 * polydata, users' shader code. So it is with several samples a pixel, too, as a fragment at an edge is
 * lit where its pixel's midst would be on the face, which may be far off.
 */
LitProps LitPropsOf(const vtkRenderState* s);

}

#endif
