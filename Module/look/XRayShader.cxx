#include "look/XRayShader.h"

#include "Shaders/SharedLayout.h"
#include "gl/ProgramCache.h"
#include "scene/Matrices.h"
#include "scene/ViewMatrices.h"
#include "shader/ShaderTags.h"
#include "shader/ShaderText.h"
#include "shader/VTKText.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace vitrine
{

namespace
{

const std::string NormalOfFragment = "normalVCVSOutput";

/** Returns true if the shader declares a normal in its main function, as VTK does for what is lit. */
bool HasNormal(const std::string& fragmentShader)
{
  return fragmentShader.find("vec3 " + NormalOfFragment + " =") != std::string::npos;
}

/** Returns the matrix from view coordinates to those of the window: pixels, and depths from 0 to 1. */
glm::dmat4 ViewToWindow(vtkRenderer* renderer, vtkOpenGLState* state)
{
  int viewport[4] = { 0, 0, 1, 1 }; // passes may draw into targets of another size than the window
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const glm::dvec3 half(0.5 * viewport[2], 0.5 * viewport[3], 0.5);
  const glm::dmat4 toWindow = glm::scale(
    glm::translate(glm::dmat4(1.0), half + glm::dvec3(viewport[0], viewport[1], 0.0)), half);
  return toWindow * MatrixOf(ViewMatricesOf(renderer).data() + 16);
}

/**
 * Returns the matrix from (x, y, 1) of a pixel to the direction of the eye, in view coordinates. That is the way from
 * the far to the near plane, which is linear in x and y.
 */
glm::dmat3 PixelToEye(const glm::dmat4& viewToWindow)
{
  const glm::dmat4 toView = glm::inverse(viewToWindow);
  const auto towardsEye = [&](double x, double y)
  {
    const glm::dvec4 near = toView * glm::dvec4(x, y, 0.0, 1.0);
    const glm::dvec4 far = toView * glm::dvec4(x, y, 1.0, 1.0);
    return glm::dvec3(near) / near.w - glm::dvec3(far) / far.w;
  };
  const glm::dvec3 first = towardsEye(0.0, 0.0);
  const glm::dmat3 toEye(towardsEye(1.0, 0.0) - first, towardsEye(0.0, 1.0) - first, first);
  const double length = glm::length(first);
  return length > 0.0 ? toEye / length : toEye;
}

void SetMatrix(vtkShaderProgram* program, const char* name, const glm::dmat4& matrix)
{
  const glm::mat4 single(matrix);
  const GLint location = glGetUniformLocation(static_cast<GLuint>(program->GetHandle()), name);
  glUniformMatrix4fv(location, 1, GL_FALSE, glm::value_ptr(single));
}
}

vtkStandardNewMacro(XRayShader);

XRayShader::~XRayShader()
{
  this->Release();
}

void XRayShader::Release()
{
  this->Context.Release([this](vtkOpenGLRenderWindow*) { this->Numbers.Release(); });
  this->Numbers =
    NumberShader(); // If the context is gone, the names of the objects may be those of others.
  this->Context.LetGo();
}

void XRayShader::Begin(
  vtkRenderer* renderer, const ChosenParts& parts, const std::vector<vtkProp*>& props)
{
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!this->Context.LivesIn(window))
  {
    this->Release();
    this->Context.Hold(window);
  }
  this->Renderer = renderer;
  this->Numbers.Begin(parts, props);
  this->OwnerOf.clear();
  for (vtkProp* prop : props)
  {
    this->OwnerOf[prop->GetPropertyKeys()] = prop;
  }
}

bool XRayShader::PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
  std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop)
{
  std::string problem = NumberShader::Join(vertexShader, geometryShader, fragmentShader, mapper);
  if (problem.empty())
  {
    problem = ReplaceTag(fragmentShader, vtktext::DepthPeelingDec,
      std::string(shaders::XRayDec) + vtktext::DepthPeelingDec);
  }
  if (problem.empty())
  {
    problem = ReplaceTag(
      fragmentShader, vtktext::UniformFlowImpl, shaders::XRayFlow + vtktext::UniformFlowImpl);
  }
  this->Refuse(problem, fragmentShader, prop);
  return true;
}

/** It comes before passes that draw the frame, which store the fragment at the same tag. */
bool XRayShader::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  const std::string normal =
    HasNormal(fragmentShader) ? "\n#define VITRINE_NORMAL " + NormalOfFragment : std::string();
  this->Refuse(ReplaceTag(fragmentShader, vtktext::DepthPeelingImpl,
                 normal + "\n" + shaders::XRayImpl + vtktext::DepthPeelingImpl),
    fragmentShader, prop);
  return true;
}

/** Tells a problem, if there is one, and has the prop draw nothing then. */
void XRayShader::Refuse(const std::string& problem, std::string& fragmentShader, vtkProp* prop)
{
  if (!problem.empty())
  {
    vtkErrorMacro(<< "An x-ray cannot show " << (prop ? prop->GetClassName() : "a prop") << ": "
                  << problem << ". It is not drawn.");
    fragmentShader = "//VTK::System::Dec\nvoid main()\n{\n  discard;\n}\n";
  }
}

bool XRayShader::SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper,
  vtkProp* prop, vtkOpenGLVertexArrayObject* vertexArray)
{
  if (!program->IsUniformUsed("vitrineXRay"))
  {
    return true;
  }
  auto* const window = this->Context.Window();
  const auto owner = this->OwnerOf.find(prop->GetPropertyKeys());
  const std::string problem = this->Numbers.SetParameters(window, program, mapper,
    owner == this->OwnerOf.end() ? prop : owner->second, prop, vertexArray);
  if (!problem.empty())
  {
    vtkErrorMacro(<< "An x-ray cannot tell its blocks: " << problem);
  }
  const float falloff[2] = { static_cast<float>(this->Floor), static_cast<float>(this->Falloff) };
  program->SetUniform2f("vitrineXRay", falloff);
  this->SetMatrices(window, program);
  return true;
}

void XRayShader::SetMatrices(vtkOpenGLRenderWindow* window, vtkShaderProgram* program)
{
  const glm::dmat4 toWindow = ViewToWindow(this->Renderer, window->GetState());
  SetMatrix(program, "vitrineViewToWindow", toWindow);
  const glm::mat3 toEye(PixelToEye(toWindow));
  glUniformMatrix3fv(
    glGetUniformLocation(static_cast<GLuint>(program->GetHandle()), "vitrinePixelToEye"), 1,
    GL_FALSE, glm::value_ptr(toEye));
}

}
