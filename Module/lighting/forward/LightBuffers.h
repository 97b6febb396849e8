/**
 * Stores the lights and the clusters' lists in buffer textures for shaders. SharedLayout.h describes the layout of
 * texels:
 *
 *   Lists    RG32UI            for each cluster: first index, number of indices
 *   Indices  R16UI or R32UI    light numbers of all lists; 16 bits for up to 65,536 lights
 *   Lights   RGBA32F           four texels for each light
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
  /** Writes the buffers. Returns an empty string, or why the driver cannot hold them. The context must be current. */
  std::string Write(const std::vector<VitrineLight>& lights, const LightLists& lists);
  void Release();

  /** Binds each buffer texture to a texture unit until Unbind(). */
  void Bind(vtkOpenGLState* state);
  void Unbind();
  void SetUniforms(vtkShaderProgram* program) const;

  /** Returns the GPU memory in bytes. */
  std::int64_t Bytes() const;

private:
  std::string WriteIndices(const std::vector<std::uint32_t>& indices, std::size_t lights);

  Buffer Lights, Lists, Indices;
  GLenum IndexFormat = GL_NONE;
  ///@{
  /** What the buffers hold, as long as they exist. */
  std::vector<VitrineLight> WrittenLights;
  std::vector<VitrineLightList> WrittenLists;
  std::vector<std::uint16_t> WrittenShortIndices;
  std::vector<std::uint32_t> WrittenIndices;
  ///@}
  std::unique_ptr<ScopedTextureUnit> LightsUnit, ListsUnit, IndicesUnit;
};

}

#endif
