/**
 * Geometry in NDC of the viewport that is lit by VTK's formulas.
 */
#ifndef VITRINE_LIGHTING_DEFERRED_LIT_SHAPE_H
#define VITRINE_LIGHTING_DEFERRED_LIT_SHAPE_H

#include "lighting/deferred/GBufferShader.h"
#include "shader/ShaderHook.h"
#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

class vtkPolyData;
class vtkRenderer;
class vtkWindow;

namespace vitrine
{

class LitShape
{
public:
  LitShape(Shading shading, vtkPolyData* shape);

  /** Draw the shape with the shaders that Hook rewrites. */
  void Draw(vtkRenderer* renderer);

  void ReleaseGraphicsResources(vtkWindow* window);

  vtkNew<ShaderHook> Hook;

private:
  vtkNew<vtkActor> Actor;
};

/** Returns a triangle that covers the viewport. */
vtkSmartPointer<vtkPolyData> MakeCover();

}

#endif
