#include "lighting/deferred/MarkedClusters.h"

#include "Shaders/SharedLayout.h"
#include "gl/Capabilities.h"
#include "gl/MemoryBarriers.h"
#include "gl/ScopedState.h"
#include "lighting/forward/ViewGrid.h"
#include "shader/ShaderText.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <string>

namespace vitrine
{

std::vector<std::uint8_t> MarkedClusters::Find(
  vtkOpenGLRenderWindow* window, const ViewGrid& grid, int unit, int samples)
{
  std::vector<std::uint32_t> words(grid.Clusters().Count(), 0);
  const std::int64_t size = static_cast<std::int64_t>(words.size() * sizeof(std::uint32_t));
  if (!MissingFeatures(4, 3, {}).empty() || size > LargestStorageBlock() ||
    (this->Marks.Bytes() != size && !this->Marks.Allocate(size)))
  {
    return {};
  }
  const ScopedShaderProgram before(window);
  const vtkOpenGLState::ScopedglColorMask colorMask(window->GetState());
  window->GetState()->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  vtkShaderProgram* const program =
    this->Programs.Ready(window, "mark", { "VITRINE_SAMPLES " + std::to_string(samples) },
      shaders::FullScreenVertex, [] { return std::string(shaders::MarkClusters); });
  if (!program)
  {
    return {};
  }
  this->Marks.Clear();
  const ScopedStorageBuffer binding(VITRINE_BINDING_CLUSTERS, this->Marks.Handle());
  const ScopedVertexArray vertexArray(this->VertexArray.Handle());
  grid.SetUniforms(program);
  program->SetUniformi("vitrineGBuffer", unit);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  BarrierBeforeReadingBuffers();
  this->Marks.Read(0, size, words.data());
  return std::vector<std::uint8_t>(words.begin(), words.end());
}

void MarkedClusters::Release()
{
  this->Programs.Release();
  this->VertexArray.Release();
  this->Marks.Release();
}

}
