#include "lighting/forward/LightBuffers.h"

#include "gl/BufferTexels.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace vitrine
{

namespace
{

/** The largest number of lights whose indices fit into 16 bits. */
constexpr std::size_t MostLightsOfShortIndices = 65536;
}

std::string LightBuffers::Write(const std::vector<VitrineLight>& lights, const LightLists& lists)
{
  std::vector<VitrineLightList> packed(lists.Offsets.size() - 1);
  for (std::size_t i = 0; i < packed.size(); ++i)
  {
    packed[i] = { lists.Offsets[i], lists.Offsets[i + 1] - lists.Offsets[i] };
  }
  std::string problem = WriteOtherTexels(
    this->Lights, this->WrittenLights, lights, GL_RGBA32F, VITRINE_LIGHT_TEXELS, "lights");
  if (problem.empty())
  {
    problem =
      WriteOtherTexels(this->Lists, this->WrittenLists, packed, GL_RG32UI, 1, "lists of lights");
  }
  return problem.empty() ? this->WriteIndices(lists.Indices, lights.size()) : problem;
}

// Shaders read both widths by the same sampler.
std::string LightBuffers::WriteIndices(
  const std::vector<std::uint32_t>& indices, std::size_t lights)
{
  const bool areShort = lights <= MostLightsOfShortIndices;
  const GLenum format = areShort ? GL_R16UI : GL_R32UI;
  if (this->IndexFormat != format)
  {
    this->Indices.Release();
    this->IndexFormat = format;
  }
  const char* const what = "lists of lights";
  if (!areShort)
  {
    return WriteOtherTexels(this->Indices, this->WrittenIndices, indices, format, 1, what);
  }
  return WriteOtherTexels(this->Indices, this->WrittenShortIndices,
    std::vector<std::uint16_t>(indices.begin(), indices.end()), format, 1, what);
}

void LightBuffers::Release()
{
  this->Lights.Release();
  this->Lists.Release();
  this->Indices.Release();
}

void LightBuffers::Bind(vtkOpenGLState* state)
{
  const auto unitOf = [&](const Buffer& buffer)
  {
    return std::make_unique<ScopedTextureUnit>(
      state, GL_TEXTURE_BUFFER, buffer.Texture(), WhenTaken::FAIL);
  };
  this->LightsUnit = unitOf(this->Lights);
  this->ListsUnit = unitOf(this->Lists);
  this->IndicesUnit = unitOf(this->Indices);
}

void LightBuffers::Unbind()
{
  this->IndicesUnit.reset();
  this->ListsUnit.reset();
  this->LightsUnit.reset();
}

void LightBuffers::SetUniforms(vtkShaderProgram* program) const
{
  program->SetUniformi("vitrineLights", this->LightsUnit->Unit());
  program->SetUniformi("vitrineLightLists", this->ListsUnit->Unit());
  program->SetUniformi("vitrineLightIndices", this->IndicesUnit->Unit());
}

std::int64_t LightBuffers::Bytes() const
{
  return this->Lights.Bytes() + this->Lists.Bytes() + this->Indices.Bytes();
}

}
