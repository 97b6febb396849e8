#include "shader/ShaderHook.h"

#include "vtkObjectFactory.h"

namespace vitrine
{

vtkStandardNewMacro(ShaderHook);

void ShaderHook::Render(const vtkRenderState* s)
{
  this->PreRender(s);
  this->Drawing->Render(s);
  this->PostRender(s);
  this->NumberOfRenderedProps = this->Drawing->GetNumberOfRenderedProps();
}

bool ShaderHook::PostReplaceShaderValues(std::string& vertexShader, std::string&,
  std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  this->Rewrite(vertexShader, fragmentShader);
  return true;
}

bool ShaderHook::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  if (this->SetUniforms)
  {
    this->SetUniforms(program, mapper, prop);
  }
  return true;
}

}
