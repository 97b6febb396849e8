/** Tells the fragment shaders of VTK's mappers the numbers of chosen parts. */
#ifndef VITRINE_LOOK_NUMBER_SHADER_H
#define VITRINE_LOOK_NUMBER_SHADER_H

#include "gl/GLObjects.h"
#include "gl/ScopedState.h"
#include "look/ChosenParts.h"
#include "scene/PartShader.h"

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

class vtkAbstractMapper;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkProp;
class vtkShaderProgram;

namespace vitrine
{

/**
 * A render pass calls Join() in PreReplaceShaderValues() and SetParameters() in SetShaderParameters(). Fragment code
 * reads `vitrineNumber` (Shaders/ChosenNumber.glsl). The context of the window is current in all calls but Begin().
 */
class NumberShader
{
public:
  /** Begin to draw props with these chosen parts. */
  void Begin(const ChosenParts& parts, const std::vector<vtkProp*>& props);
  void End() { this->Unit.reset(); }

  /** Declare the number in a mapper's shaders. Returns an error message, empty on success. */
  static std::string Join(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper);

  /**
   * Set the number before a mapper draws. Returns an error message, empty on success.
   * @param owner  the prop whose parts are chosen
   * @param drawn  the prop that draws, which may be one within `owner`
   */
  std::string SetParameters(vtkOpenGLRenderWindow* window, vtkShaderProgram* program,
    vtkAbstractMapper* mapper, vtkProp* owner, vtkProp* drawn,
    vtkOpenGLVertexArrayObject* vertexArray);

  /** Release the buffers. Their context is current. */
  void Release();

private:
  std::string Bind(vtkOpenGLRenderWindow* window);

  std::unordered_map<vtkProp*, std::uint32_t> NumberOf; ///< of props without blocks
  std::unordered_map<vtkProp*, int> RowOf;              ///< of props with blocks, in Numbers
  std::vector<std::uint32_t> Numbers;
  std::vector<std::uint32_t> Written;
  Buffer Texels;
  std::unique_ptr<ScopedTextureUnit> Unit;
  PartShader Blocks;
};

}

#endif
