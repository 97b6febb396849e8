/** Boxes around the props that lights shine on. */
#ifndef VITRINE_SCENE_LIT_PROPS_H
#define VITRINE_SCENE_LIT_PROPS_H

#include "Core/geometry/Box.h"
#include "Core/lighting/LitRegion.h"

#include <optional>
#include <vector>

class vtkRenderState;

namespace vitrine
{

class VisibleBox;

/** The box around a prop. */
struct LitBox
{
  Box InWorld; ///< In world coordinates (WC).
  Box InView;  ///< In view coordinates (VC), enlarged by the rounding of shaders' floats.
};

/** The props of a frame. */
struct LitProps
{
  /** Region around all visible props of the renderer, in view coordinates (VC). It does not depend on cullers. */
  LitRegion Region;

  /** Boxes around the props that are about to be drawn. They are absent if the box of one prop is not known. */
  std::optional<std::vector<LitBox>> Boxes;
};

/**
 * Finds the props of a frame.
 *
 * The region is all of space if a prop may be drawn outside its bounds: a class other than actors of polydata, or
 * shader code of users. It is all of space with several samples per pixel as well. A fragment at an edge is lit at the
 * point where the face's plane meets the pixel's centre, and that may be far away.
 *
 * @param box  what is known of the renderer's props from frames before
 */
LitProps LitPropsOf(const vtkRenderState* s, VisibleBox& box);

}

#endif
