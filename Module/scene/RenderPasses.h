#ifndef VITRINE_SCENE_RENDER_PASSES_H
#define VITRINE_SCENE_RENDER_PASSES_H

#include <set>
#include <string>

class vtkRenderer;

namespace vitrine
{

/**
 * Whether a renderer, or its passes, draw what opaque parts leave to be seen in the view, and nothing else, as far as they can be asked. Shadows are of what the lights see.
 * @param known  classes of users' passes that do, too
 */
bool ShowsTheViewAlone(vtkRenderer* renderer, const std::set<std::string>& known);

/**
 * Whether it finds ambient occlusion (vtkSSAOPass): places and normals are blended into targets of their own. Where what is in front has none, or they are not numbers, as of faces that are shaded flat and
 * seen from their edge, those of what it hides stay.
 */
bool FindsAmbientOcclusion(vtkRenderer* renderer);

/**
 * Whether it peels what is translucent (vtkDepthPeelingPass): the alpha of the picture and how volumes are drawn depend on whether there is any, seen or not.
 */
bool PeelsDepth(vtkRenderer* renderer);

/** Whether it works on the whole picture, whatever was drawn there before, or keeps it, in frames in which it draws a prop, seen or not. */
bool DoesMoreWhereAnyIsDrawn(vtkRenderer* renderer);

}

#endif
