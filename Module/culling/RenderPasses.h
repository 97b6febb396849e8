#ifndef VITRINE_CULLING_RENDER_PASSES_H
#define VITRINE_CULLING_RENDER_PASSES_H

#include <set>
#include <string>

class vtkRenderPass;

namespace vitrine
{

/**
 * Whether a renderer's passes draw what opaque parts leave to be seen in the view, and nothing else, as far as they can be asked; null is
 * what a renderer does by itself.
 * @param known  classes of users' passes that do, too
 */
bool ShowsTheViewAlone(vtkRenderPass* pass, const std::set<std::string>& known);

}

#endif
