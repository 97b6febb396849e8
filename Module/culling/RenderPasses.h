#ifndef VITRINE_CULLING_RENDER_PASSES_H
#define VITRINE_CULLING_RENDER_PASSES_H

class vtkRenderPass;

namespace vitrine
{

/**
 * Whether a renderer's passes draw what opaque parts leave to be seen in the view, and nothing else, as far as they can be asked; null is
 * what a renderer does by itself.
 */
bool ShowsTheViewAlone(vtkRenderPass* pass);

}

#endif
