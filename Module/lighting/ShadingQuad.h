/**
 * What covers a viewport and is lit by VTK's formulas.
 */
#ifndef VITRINE_SHADING_QUAD_H
#define VITRINE_SHADING_QUAD_H

#include "lighting/GBufferShader.h"
#include "lighting/ShaderHook.h"
#include "vtkActor.h"
#include "vtkNew.h"

class vtkRenderer;
class vtkWindow;

namespace vitrine
{

class ShadingQuad
{
public:
  explicit ShadingQuad(Shading shading);

  /** Draw it with what Hook makes of its shaders. */
  void Draw(vtkRenderer* renderer);

  void ReleaseGraphicsResources(vtkWindow* window);

  vtkNew<ShaderHook> Hook;

private:
  vtkNew<vtkActor> Actor;
};

}

#endif
