/**
 * Lights and the lists of clusters, as buffer textures that shaders read.
 */
#ifndef VITRINE_LIGHTING_FORWARD_LIGHT_BUFFERS_H
#define VITRINE_LIGHTING_FORWARD_LIGHT_BUFFERS_H

#include "Core/lighting/LightAssignment.h"
#include "Shaders/SharedLayout.h"
#include "gl/GLObjects.h"
#include "gl/ScopedState.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLState;
class vtkShaderProgram;

namespace vitrine
{

class LightBuffers
{
public:
  /** Returns an empty string, or why the driver cannot hold them. The context is current. */
  std::string Write(const std::vector<VitrineLight>& lights, const LightLists& lists);
  void Release();

  /** Until Unbind() they have texture units of their own. */
  void Bind(vtkOpenGLState* state);
  void Unbind();
  void SetUniforms(vtkShaderProgram* program) const;

  /** GPU memory. */
  std::int64_t Bytes() const;

private:
  std::string WriteIndices(const std::vector<std::uint32_t>& indices, std::size_t lights);

  Buffer Lights, Lists, Indices;
  GLenum IndexFormat = GL_NONE;
  std::vector<VitrineLightList> Packed;
  std::vector<std::uint16_t> ShortIndices;
  std::unique_ptr<ScopedTextureUnit> LightsUnit, ListsUnit, IndicesUnit;
};

}

#endif
