/** Makes faces of chosen parts the less opaque, the more they are turned to the eye. */
#ifndef VITRINE_LOOK_X_RAY_SHADER_H
#define VITRINE_LOOK_X_RAY_SHADER_H

#include "gl/HeldContext.h"
#include "look/ChosenParts.h"
#include "look/NumberShader.h"

#include "vtkOpenGLRenderPass.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <unordered_map>
#include <vector>

class vtkInformation;
class vtkRenderer;

namespace vitrine
{

/** A render pass that draws nothing. It is listed among the passes of props (scene/ListedPass). */
class XRayShader : public vtkOpenGLRenderPass
{
public:
  static XRayShader* New();
  vtkTypeMacro(XRayShader, vtkOpenGLRenderPass);

  double Floor = 0.05;  ///< the share of opacity that faces towards the eye keep
  double Falloff = 2.0; ///< the power of the falloff

  /** Begin a frame of a renderer with these chosen parts, and end it. */
  void Begin(vtkRenderer* renderer, const ChosenParts& parts, const std::vector<vtkProp*>& props);
  void End() { this->Numbers.End(); }

  /** Release what is held, in the context that holds it. */
  void Release();

  void Render(const vtkRenderState*) override {}
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vertexArray) override;
  vtkMTimeType GetShaderStageMTime() override { return this->Stage.GetMTime(); }

protected:
  XRayShader() = default;
  ~XRayShader() override;

private:
  void Refuse(const std::string& problem, std::string& fragmentShader, vtkProp* prop);
  void SetMatrices(vtkOpenGLRenderWindow* window, vtkShaderProgram* program);

  vtkWeakPointer<vtkRenderer> Renderer;
  HeldContext Context;
  NumberShader Numbers;
  std::unordered_map<vtkInformation*, vtkProp*> OwnerOf; ///< of keys, which inner props share
  vtkTimeStamp Stage;
};

}

#endif
