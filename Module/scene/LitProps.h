/**
 * Where everything is that lights shine on.
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

/** The box around a prop. */
struct LitBox
{
  Box InWorld; ///< in world coordinates (WC)
  Box InView;  ///< in view coordinates (VC), wider by the rounding of shaders' floats
};

/** The props of a frame. */
struct LitProps
{
  /** Around all visible props of the renderer, in view coordinates (VC). It does not depend on cullers. */
  LitRegion Region;

  /** Around each prop that is about to be drawn; nothing where that is not known. */
  std::optional<std::vector<LitBox>> Boxes;
};

/**
 * Finds the props of a frame.
 *
 * The region is all of space if any prop may be drawn outside its bounds: a class other than actors of polydata, or
 * shader code of users. It is all of space with several samples a pixel as well: a fragment at an edge is lit where
 * the centre of its pixel would be on the face, which may be far away.
 */
LitProps LitPropsOf(const vtkRenderState* s);

}

#endif
