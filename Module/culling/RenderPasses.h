#ifndef VITRINE_CULLING_RENDER_PASSES_H
#define VITRINE_CULLING_RENDER_PASSES_H

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

}

#endif
