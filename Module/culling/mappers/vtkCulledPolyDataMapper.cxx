#include "gl/VitrineOpenGL.h"

#include "vtkCulledPolyDataMapper.h"

#include "culling/mappers/LeafParts.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <cstddef>
#include <vector>

vtkStandardNewMacro(vtkCulledPolyDataMapper);

namespace
{

/** The triangles of a buffer that are drawn, in their order, as runs without gaps. */
struct DrawnTriangles
{
  std::vector<GLsizei> Counts; ///< number of indices of each run
  std::vector<const void*> Starts;

  /** Adds the triangles from `first` up to before `end`. There are none if VTK draws no triangle of a leaf. */
  void Add(std::uint32_t first, std::uint32_t end)
  {
    if (first == end)
    {
      return;
    }
    const std::size_t start = std::size_t{ 3 } * first * sizeof(GLuint);
    const auto count = static_cast<GLsizei>(3 * (end - first));
    if (!this->Starts.empty() && this->End == start)
    {
      this->Counts.back() += count;
    }
    else
    {
      this->Starts.push_back(reinterpret_cast<const void*>(start));
      this->Counts.push_back(count);
    }
    this->End = start + static_cast<std::size_t>(count) * sizeof(GLuint);
  }

  int FirstTriangle(std::size_t run) const
  {
    return static_cast<int>(
      reinterpret_cast<std::size_t>(this->Starts[run]) / (3 * sizeof(GLuint)));
  }

private:
  std::size_t End = 0; ///< end of the last run, in bytes
};

DrawnTriangles DrawnOf(
  const std::vector<std::uint32_t>& firsts, const std::vector<std::uint8_t>& shown)
{
  DrawnTriangles drawn;
  for (std::size_t leaf = 0; leaf < shown.size(); ++leaf)
  {
    if (shown[leaf])
    {
      drawn.Add(firsts[leaf], firsts[leaf + 1]);
    }
  }
  return drawn;
}

/**
 * Returns where leaves begin in a buffer with this number of indices. Returns null if the buffer does not hold the
 * leaves.
 */
const std::vector<std::uint32_t>* FirstsIn(const vitrine::Leaves& leaves, std::size_t indices)
{
  for (const auto* firsts : { &leaves.FirstOfDrawn, &leaves.FirstOfAll })
  {
    if (std::size_t{ 3 } * firsts->back() == indices)
    {
      return firsts;
    }
  }
  return nullptr;
}
}

vtkCulledPolyDataMapper::vtkCulledPolyDataMapper()
  : Leaves(std::make_unique<vitrine::LeafParts>(this))
{
}

vtkCulledPolyDataMapper::~vtkCulledPolyDataMapper() = default;

vitrine::DividedMapper* vtkCulledPolyDataMapper::GetDividedMapper()
{
  return this->Leaves.get();
}

void vtkCulledPolyDataMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  const std::shared_ptr<const vitrine::ShownParts> shown = this->Leaves->ShownIn(renderer, actor);
  const bool isOfLeaves = shown && shown->Division() == this->Leaves->Known() &&
    FirstsIn(*this->Leaves->Known(), this->Primitives[PrimitiveTris].IBO->IndexCount);
  if (isOfLeaves)
  {
    this->DrawLeaves(renderer, actor, *shown);
  }
  else
  {
    this->Superclass::RenderPieceDraw(renderer, actor);
  }
}

/**
 * Draws the leaves that show. VTK prepares the drawing, and draws nothing: there are only triangles, and it is told
 * that there are none.
 */
void vtkCulledPolyDataMapper::DrawLeaves(
  vtkRenderer* renderer, vtkActor* actor, const vitrine::ShownParts& shown)
{
  vtkOpenGLHelper& triangles = this->Primitives[PrimitiveTris];
  const std::size_t indices = triangles.IBO->IndexCount;
  triangles.IBO->IndexCount = 0;
  this->Superclass::RenderPieceDraw(renderer, actor);
  triangles.IBO->IndexCount = indices;

  const DrawnTriangles drawn = DrawnOf(*FirstsIn(*this->Leaves->Known(), indices), shown.Shown());
  this->DrawingVertices = false;
  this->DrawingSelection = false;
  this->UpdateShaders(triangles, renderer, actor);
  triangles.IBO->Bind();
  if (triangles.Program->IsUniformUsed("PrimitiveIDOffset"))
  {
    // A device counts primitives anew in each run.
    const auto last = static_cast<GLuint>(this->VBOs->GetNumberOfTuples("vertexMC") - 1);
    for (std::size_t run = 0; run < drawn.Counts.size(); ++run)
    {
      triangles.Program->SetUniformi("PrimitiveIDOffset", drawn.FirstTriangle(run));
      glDrawRangeElements(
        GL_TRIANGLES, 0, last, drawn.Counts[run], GL_UNSIGNED_INT, drawn.Starts[run]);
    }
  }
  else
  {
    glMultiDrawElements(GL_TRIANGLES, drawn.Counts.data(), GL_UNSIGNED_INT, drawn.Starts.data(),
      static_cast<GLsizei>(drawn.Counts.size()));
  }
  triangles.IBO->Release();
}
