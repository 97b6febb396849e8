#include "section/CutSums.h"

#include "Shaders/SharedLayout.h"
#include "gl/BufferTexels.h"
#include "gl/Capabilities.h"
#include "gl/FullScreenDraw.h"
#include "scene/Matrices.h"
#include "scene/ViewMatrices.h"
#include "shader/ShaderText.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace vitrine
{

namespace
{

/** Returns the matrix from WC to clip coordinates with which the renderer draws. */
glm::dmat4 ToClipOf(vtkRenderer* renderer)
{
  const ViewMatrices matrices = ViewMatricesOf(renderer);
  return MatrixOf(matrices.data() + 16) * MatrixOf(matrices.data());
}

/**
 * Returns 1 or -1, by which distances from the plane are multiplied to be positive beyond it along the ray. Distances
 * change with the depth by the third component of the plane in clip coordinates, the same at all pixels.
 */
double SignBeyond(const CutPlane& plane, const glm::dmat4& toClip)
{
  return plane.In(glm::inverse(toClip)).Normal.z >= 0.0 ? 1.0 : -1.0;
}

/** The ranges of corners for a multi-draw. Ranges that follow each other are one. */
struct Ranges
{
  std::vector<GLsizei> Counts;
  std::vector<const void*> Starts;
  std::uint32_t End = 0;

  void Add(std::uint32_t first, std::uint32_t count)
  {
    if (!this->Counts.empty() && this->End == first)
    {
      this->Counts.back() += static_cast<GLsizei>(count);
    }
    else if (count > 0)
    {
      this->Counts.push_back(static_cast<GLsizei>(count));
      this->Starts.push_back(
        reinterpret_cast<const void*>(static_cast<std::uintptr_t>(first) * sizeof(std::uint32_t)));
    }
    this->End = first + count;
  }
};

Ranges RangesOf(const CutParts& parts, std::uint32_t planeBit, bool areClosed)
{
  Ranges ranges;
  for (const CutPart& part : parts.Parts())
  {
    if (part.Slot != 0 && part.IsClosed == areClosed && (part.Cuts & planeBit) != 0)
    {
      ranges.Add(part.FirstCorner, part.CornerCount);
    }
  }
  return ranges;
}

/** Writes the items that a buffer does not have yet. It grows by doubling. */
template <class Item>
std::string Append(Buffer& buffer, std::size_t& written, const std::vector<Item>& items)
{
  const auto bytes = static_cast<std::int64_t>(items.size() * sizeof(Item));
  if (buffer.Bytes() < bytes)
  {
    written = 0;
    if (!buffer.Allocate(bytes + bytes / 2))
    {
      return "the driver has no memory for " + std::to_string(bytes) + " bytes of cut parts";
    }
  }
  const auto offset = static_cast<std::int64_t>(written * sizeof(Item));
  if (bytes > offset)
  {
    buffer.Write(offset, bytes - offset, items.data() + written);
  }
  written = items.size();
  return {};
}
}

void CutSums::UseWindow(vtkOpenGLRenderWindow* window)
{
  if (!this->Context.LivesIn(window))
  {
    this->Release();
    this->Context.Hold(window);
  }
}

int CutSums::SamplesOfTarget()
{
  GLint samples = 0;
  GLint most = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  glGetIntegerv(GL_MAX_INTEGER_SAMPLES, &most);
  return samples > 1 && samples <= most && MissingFeatures(4, 0, {}).empty() ? samples : 0;
}

std::string CutSums::Draw(
  vtkRenderer* renderer, const CutParts& parts, const SectionPlanes& planes, int samples)
{
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->UseWindow(window);
  Key key;
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, key.Viewport.data());
  key.ToClip = ToClipOf(renderer);
  key.Changes = parts.Changes();
  key.Samples = samples;
  key.Planes = planes.Planes;
  const auto isSamePlane = [](const CutPlane& a, const CutPlane& b)
  { return a.Equation() == b.Equation(); };
  if (key.Viewport == this->LastKey.Viewport && key.ToClip == this->LastKey.ToClip &&
    key.Changes == this->LastKey.Changes && key.Samples == this->LastKey.Samples &&
    std::equal(key.Planes.begin(), key.Planes.end(), this->LastKey.Planes.begin(),
      this->LastKey.Planes.end(), isSamePlane))
  {
    return {};
  }
  this->LastKey = key;
  vtkOpenGLState* const state = window->GetState();
  const ScopedArrayBuffer arrayBuffer;
  const ScopedVertexArray vertexArray(0);
  const ScopedTrackedState trackedState(state);
  const ScopedShaderProgram shaderProgram(window);
  const int layers = this->GiveLayers(parts, planes.Planes.size());
  std::string problem = this->Sums.Allocate(
    GL_RG32UI, std::max(key.Viewport[2], 1), std::max(key.Viewport[3], 1), samples, layers);
  problem = problem.empty() ? this->Upload(parts) : problem;
  problem = problem.empty() ? this->DrawPlanes(window, parts, planes) : problem;
  if (!problem.empty())
  {
    this->LastKey = Key();
  }
  return problem;
}

/** Gives layers to the planes that cut parts. Returns how many there are, with those of open parts, and at least 1. */
int CutSums::GiveLayers(const CutParts& parts, std::size_t planes)
{
  std::uint32_t cuts = 0;
  bool hasOpen = false;
  for (const CutPart& part : parts.Parts())
  {
    cuts |= part.Slot != 0 ? part.Cuts : 0;
    hasOpen = hasOpen || (part.Slot != 0 && !part.IsClosed);
  }
  int count = 0;
  this->Layers.clear();
  for (std::size_t plane = 0; plane < planes; ++plane)
  {
    this->Layers.push_back((cuts >> plane & 1u) != 0 ? count++ : -1);
  }
  this->OpenLayer = hasOpen ? count : 0;
  return std::max(hasOpen ? 3 * count : count, 1);
}

std::string CutSums::Upload(const CutParts& parts)
{
  if (this->Generation != parts.Generation())
  {
    this->WrittenVertices = this->WrittenCorners = 0;
    this->Generation = parts.Generation();
  }
  const std::string problem = Append(this->Vertices, this->WrittenVertices, parts.Vertices());
  return problem.empty() ? Append(this->Corners, this->WrittenCorners, parts.Corners()) : problem;
}

/** Sets the vertex array to the vertices, for the inputs of the program. */
void CutSums::Connect(vtkShaderProgram* program)
{
  if (this->VertexArray == 0)
  {
    glGenVertexArrays(1, &this->VertexArray);
  }
  glBindVertexArray(this->VertexArray);
  glBindBuffer(GL_ARRAY_BUFFER, this->Vertices.Handle());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->Corners.Handle());
  const auto handle = static_cast<GLuint>(program->GetHandle());
  const auto position = static_cast<GLuint>(glGetAttribLocation(handle, "vertexPosition"));
  const auto slot = static_cast<GLuint>(glGetAttribLocation(handle, "vertexSlot"));
  glEnableVertexAttribArray(position);
  glVertexAttribPointer(position, 3, GL_FLOAT, GL_FALSE, sizeof(CutVertex), nullptr);
  glEnableVertexAttribArray(slot);
  glVertexAttribIPointer(slot, 1, GL_UNSIGNED_INT, sizeof(CutVertex),
    reinterpret_cast<const void*>(offsetof(CutVertex, Slot)));
}

std::string CutSums::DrawPlanes(
  vtkOpenGLRenderWindow* window, const CutParts& parts, const SectionPlanes& planes)
{
  const int width = std::max(this->LastKey.Viewport[2], 1);
  const int height = std::max(this->LastKey.Viewport[3], 1);
  vtkShaderProgram* const program = this->Programs.Ready(
    window, "CutSum", {}, shaders::CutSumVertex, [] { return std::string(shaders::CutSum); });
  if (!program)
  {
    return ProgramFailure;
  }
  this->Connect(program);
  BindForFullScreenDraw(window->GetState(), this->Drawing.Handle(), width, height);
  glFramebufferTextureLayer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->Sums.Handle(), 0, 0);
  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    return "the driver cannot draw into an image of cut parts";
  }
  const ScopedSampleMask allSamples;
  std::optional<ScopedSampleShading>
    eachSample; // whether a face is beyond the plane differs within a pixel
  if (this->LastKey.Samples > 0)
  {
    window->GetState()->vtkglEnable(GL_MULTISAMPLE);
    eachSample.emplace();
  }
  const glm::dmat4& toClip = this->LastKey.ToClip;
  const glm::dmat4 fromCenter = glm::translate(glm::dmat4(1.0), parts.Center());
  const glm::mat4 matrix(toClip * fromCenter);
  glUniformMatrix4fv(
    glGetUniformLocation(static_cast<GLuint>(program->GetHandle()), "vitrineToClip"), 1, GL_FALSE,
    glm::value_ptr(matrix));
  for (std::size_t plane = 0; plane < planes.Planes.size(); ++plane)
  {
    const glm::dvec4 beyond =
      SignBeyond(planes.Planes[plane], toClip) * planes.Planes[plane].In(fromCenter).Equation();
    const std::uint32_t bit = 1u << plane;
    const int layer = this->Layers[plane];
    if (layer < 0)
    {
      continue;
    }
    this->DrawLayer(program, layer, parts, bit, true, beyond);
    if (this->OpenLayer > 0)
    {
      const int open = this->OpenLayer + 2 * layer;
      this->DrawLayer(program, open, parts, bit, false, beyond);
      this->DrawLayer(program, open + 1, parts, bit, false, -beyond);
    }
  }
  return {};
}

/** Draws the sums of closed or open parts into a layer. `beyond` is the plane whose positive side counts. */
void CutSums::DrawLayer(vtkShaderProgram* program, int layer, const CutParts& parts,
  std::uint32_t planeBit, bool areClosed, const glm::dvec4& beyond)
{
  glFramebufferTextureLayer(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->Sums.Handle(), 0, layer);
  const GLuint none[4] = { 0, 0, 0, 0 };
  glClearBufferuiv(GL_COLOR, 0, none);
  const Ranges ranges = RangesOf(parts, planeBit, areClosed);
  if (!ranges.Counts.empty())
  {
    const glm::vec4 equation(beyond);
    program->SetUniform4f("vitrinePlane", glm::value_ptr(equation));
    const ScopedExclusiveOr adding;
    glMultiDrawElements(GL_TRIANGLES, ranges.Counts.data(), GL_UNSIGNED_INT, ranges.Starts.data(),
      static_cast<GLsizei>(ranges.Counts.size()));
  }
}

std::string CutSums::WriteTables(vtkRenderer* renderer, const CutParts& parts,
  const HatchOf& hatchOf, const PlaneMasks& ofInterference)
{
  this->UseWindow(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
  std::vector<std::array<std::uint32_t, 4>> table(parts.SlotCount());
  std::vector<std::array<glm::vec4, 2>> looks(parts.SlotCount());
  table[0] = { 0, ofInterference.Any, ofInterference.All, 0 };
  looks[0] = { glm::vec4(0.9f, 0.1f, 0.1f, 1.0f), glm::vec4(0.0f) };
  for (const CutPart& part : parts.Parts())
  {
    if (part.Slot == 0)
    {
      continue;
    }
    const std::uint32_t hatch = static_cast<std::uint32_t>(hatchOf(part)) | part.Place << 8;
    table[part.Slot] = { part.Number, part.Masks.Any, part.Masks.All, hatch };
    looks[part.Slot] = { part.Look.Diffuse, part.Look.Ambient };
  }
  std::string problem =
    WriteOtherTexels(this->PartTable, this->WrittenParts, table, GL_RGBA32UI, 1, "cut parts");
  return problem.empty() ? WriteOtherTexels(this->LookTable, this->WrittenLooks, looks, GL_RGBA32F,
                             VITRINE_CUT_LOOK_TEXELS, "looks of cut parts")
                         : problem;
}

std::string CutSums::Bind(vtkOpenGLState* state)
{
  this->SumsUnit = std::make_unique<ScopedTextureUnit>(
    state, this->Sums.Target(), this->Sums.Handle(), WhenTaken::FAIL);
  this->PartsUnit = std::make_unique<ScopedTextureUnit>(
    state, GL_TEXTURE_BUFFER, this->PartTable.Texture(), WhenTaken::FAIL);
  this->LooksUnit = std::make_unique<ScopedTextureUnit>(
    state, GL_TEXTURE_BUFFER, this->LookTable.Texture(), WhenTaken::FAIL);
  if (std::min({ this->SumsUnit->Unit(), this->PartsUnit->Unit(), this->LooksUnit->Unit() }) < 0)
  {
    this->Unbind();
    return "no texture unit is free for caps";
  }
  return {};
}

void CutSums::Unbind()
{
  this->LooksUnit.reset();
  this->PartsUnit.reset();
  this->SumsUnit.reset();
}

void CutSums::SetUniforms(vtkShaderProgram* program, int plane, bool isTranslucent) const
{
  program->SetUniformi("vitrineCutSums", this->SumsUnit->Unit());
  program->SetUniformi("vitrineCutParts", this->PartsUnit->Unit());
  program->SetUniformi("vitrineCutLooks", this->LooksUnit->Unit());
  const GLint location =
    glGetUniformLocation(static_cast<GLuint>(program->GetHandle()), "vitrineCapPlace");
  glUniform4i(
    location, plane, this->LastKey.Viewport[0], this->LastKey.Viewport[1], isTranslucent ? 1 : 0);
}

CutSums::Pixels CutSums::Read(int plane)
{
  Pixels pixels;
  const int layer = this->LayerOf(static_cast<std::size_t>(plane));
  if (!this->Context.Lives() || this->LastKey.Changes == 0 || layer < 0)
  {
    return pixels;
  }
  pixels.Width = std::max(this->LastKey.Viewport[2], 1);
  pixels.Height = std::max(this->LastKey.Viewport[3], 1);
  pixels.Sums.resize(static_cast<std::size_t>(pixels.Width) * pixels.Height);
  vtkOpenGLRenderWindow* const window = this->Context.Window();
  window->MakeCurrent();
  const ScopedTrackedState trackedState(window->GetState());
  const ScopedPixelTransfer transfer(ScopedPixelTransfer::FROM_DEVICE);
  window->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Drawing.Handle());
  glFramebufferTextureLayer(
    GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->Sums.Handle(), 0, layer);
  const ScopedReadBuffer readBuffer(window->GetState(), GL_COLOR_ATTACHMENT0);
  Image2D single;
  Framebuffer resolving;
  if (this->LastKey.Samples > 0)
  {
    // Of integers, one of the samples is taken.
    if (!single.Allocate(GL_RG32UI, pixels.Width, pixels.Height, 0).empty())
    {
      return {};
    }
    resolving.Attach(window->GetState(), single);
    window->GetState()->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->Drawing.Handle());
    window->GetState()->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolving.Handle());
    window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(0, 0, pixels.Width, pixels.Height, 0, 0, pixels.Width, pixels.Height,
      GL_COLOR_BUFFER_BIT, GL_NEAREST);
    window->GetState()->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, resolving.Handle());
  }
  glReadPixels(
    0, 0, pixels.Width, pixels.Height, GL_RG_INTEGER, GL_UNSIGNED_INT, pixels.Sums.data());
  window->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Drawing.Handle());
  resolving.Release();
  single.Release();
  return pixels;
}

void CutSums::Release(vtkWindow* window)
{
  if (this->Context.LivesIn(window))
  {
    this->Release();
  }
}

void CutSums::Release()
{
  this->Context.Release(
    [this](vtkOpenGLRenderWindow*)
    {
      this->Unbind();
      for (Buffer* const buffer :
        { &this->Vertices, &this->Corners, &this->PartTable, &this->LookTable })
      {
        buffer->Release();
      }
      this->Sums.Release();
      this->Drawing.Release();
      glDeleteVertexArrays(1, &this->VertexArray);
    });
  this->Forget();
}

/** Forgets all objects. Their names may be those of others now. */
void CutSums::Forget()
{
  this->Vertices = Buffer();
  this->Corners = Buffer();
  this->PartTable = Buffer();
  this->LookTable = Buffer();
  this->WrittenParts.clear();
  this->WrittenLooks.clear();
  this->Sums = Image2D();
  this->Drawing = Framebuffer();
  this->VertexArray = 0;
  this->Programs.Release();
  this->Generation = 0;
  this->LastKey = Key();
  this->Layers.clear();
  this->Context.LetGo();
}

std::int64_t CutSums::Bytes() const
{
  return this->Sums.Bytes() + this->Vertices.Bytes() + this->Corners.Bytes() +
    this->PartTable.Bytes() + this->LookTable.Bytes();
}

}
