/**
 * The second half of the stencil masks: what the groups hold becomes a picture.
 */
#ifndef VITRINE_MASK_RESOLVER_H
#define VITRINE_MASK_RESOLVER_H

#include "Core/StencilMasks.h"
#include "gl/GLObjects.h"
#include "gl/ProgramCache.h"

#include <string>

class vtkOpenGLRenderWindow;

namespace vitrine
{

class MaskTarget;
struct RenderTarget;

/** The shaders' define for a group. */
std::string GroupDefine(const MaskGroup& group);

class MaskResolver
{
public:
  /** Sort and composite the groups over the backdrop, into the target. Returns false if a shader does not compile. */
  bool Resolve(vtkOpenGLRenderWindow* window, const MaskGroup& group, const MaskTarget& masks,
    const Image2D& backdrop, const RenderTarget& target);

  void Release();

private:
  EmptyVertexArray VertexArray;
  ProgramCache Programs{ GLSL150 };
};

}
#endif
