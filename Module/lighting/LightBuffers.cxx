#include "lighting/LightBuffers.h"

#include "gl/Capabilities.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace vitrine
{

namespace
{

/** Grows by more than is asked for, as lists change from frame to frame; returns an empty string, or why there is no room. */
template <class Item>
std::string WriteInto(Buffer& buffer, const std::vector<Item>& items, GLenum format, int texels)
{
  const std::int64_t count = static_cast<std::int64_t>(items.size());
  if (count * texels > LargestBufferTexture())
  {
    return "lights and their lists take " + std::to_string(count * texels) +
      " texels, and the driver's largest buffer texture has " +
      std::to_string(LargestBufferTexture());
  }
  const std::int64_t size = count * static_cast<std::int64_t>(sizeof(Item));
  const std::int64_t least = texels * std::int64_t{ 16 };
  if (buffer.Bytes() < std::max(size, least))
  {
    const std::int64_t roomy = std::min(
      size + size / 4, LargestBufferTexture() * (static_cast<std::int64_t>(sizeof(Item)) / texels));
    if (!buffer.Allocate(std::max(roomy, least), format))
    {
      return "the driver has no memory for " + std::to_string(size) + " bytes of lights";
    }
  }
  if (size > 0)
  {
    buffer.Write(0, size, items.data());
  }
  return {};
}
}

std::string LightBuffers::Write(const std::vector<VitrineLight>& lights, const LightLists& lists)
{
  this->Packed.resize(lists.Offsets.size() - 1);
  for (std::size_t i = 0; i < this->Packed.size(); ++i)
  {
    this->Packed[i] = { lists.Offsets[i], lists.Offsets[i + 1] - lists.Offsets[i] };
  }
  std::string problem = WriteInto(this->Lights, lights, GL_RGBA32F, VITRINE_LIGHT_TEXELS);
  if (problem.empty())
  {
    problem = WriteInto(this->Lists, this->Packed, GL_RG32UI, 1);
  }
  return problem.empty() ? WriteInto(this->Indices, lists.Indices, GL_R32UI, 1) : problem;
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
  { return std::make_unique<ScopedTextureUnit>(state, GL_TEXTURE_BUFFER, buffer.Texture()); };
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
