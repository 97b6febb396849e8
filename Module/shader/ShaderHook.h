/** A render pass that lets functions rewrite the shaders of the opaque props that it draws. */
#ifndef VITRINE_SHADER_SHADER_HOOK_H
#define VITRINE_SHADER_SHADER_HOOK_H

#include "vtkNew.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkTimeStamp.h"

#include <functional>
#include <string>

namespace vitrine
{

class ShaderHook : public vtkOpenGLRenderPass
{
public:
  static ShaderHook* New();
  vtkTypeMacro(ShaderHook, vtkOpenGLRenderPass);

  /** Rewrites the vertex and the fragment shader of a mapper. */
  std::function<void(std::string&, std::string&)> Rewrite;

  /** Sets the uniforms of rewritten shaders, before a mapper draws a prop. */
  std::function<void(vtkShaderProgram*, vtkAbstractMapper*, vtkProp*)> SetUniforms;

  /** Call this if the inputs of Rewrite() have changed. */
  void RewriteAgain() { this->Stage.Modified(); }

  void Render(const vtkRenderState* s) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO) override;
  vtkMTimeType GetShaderStageMTime() override { return this->Stage.GetMTime(); }

private:
  vtkNew<vtkOpaquePass> Drawing;
  vtkTimeStamp Stage;
};

}

#endif
