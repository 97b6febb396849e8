/** Lets the planes of a section cut what mappers draw, and caps look up what is cut. */
#ifndef VITRINE_SECTION_SECTION_SHADER_H
#define VITRINE_SECTION_SECTION_SHADER_H

#include "scene/PartShader.h"
#include "section/SectionPlanes.h"

#include "vtkOpenGLRenderPass.h"
#include "vtkTimeStamp.h"

#include <functional>

namespace vitrine
{

/**
 * A render pass that draws nothing. It is listed among the passes of props (vtkOpenGLRenderPass::RenderPasses()) while
 * their renderer draws a frame, whatever pass draws it, and changes the shaders of their mappers.
 */
class SectionShader : public vtkOpenGLRenderPass
{
public:
  static SectionShader* New();
  vtkTypeMacro(SectionShader, vtkOpenGLRenderPass);

  /** Set the planes of the frame. */
  void SetPlanes(const SectionPlanes& planes);

  /** Returns the planes that apply to a prop without blocks, or to all blocks of a prop. */
  std::function<PlaneMasks(vtkProp*)> MasksOf;

  /** Sets the uniforms of a cap's own lookups. */
  std::function<void(vtkShaderProgram*, vtkProp*)> SetCapUniforms;

  void Render(const vtkRenderState*) override {}
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vertexArray) override;
  vtkMTimeType GetShaderStageMTime() override { return this->Stage.GetMTime(); }

private:
  SectionPlanes Planes;
  vtkTimeStamp Stage;
};

}

#endif
