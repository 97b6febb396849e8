#include "transparency/ranks/SamplePixels.h"

#include "gl/FullScreenDraw.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "gl/StateRecord.h"
#include "gl/TargetPixels.h"
#include "shader/ShaderText.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace vitrine
{
namespace
{

const SamplePlane::Format DepthFormat = { GL_R32F, GL_RED, GL_FLOAT, true };
constexpr GLfloat NotFound[] = { -1.0f, -1.0f, -1.0f, -1.0f };
// How much a sampler and a float of 24 bits may lose of a depth of fixed point.
constexpr double LossOfSamplers = 1.0 / 8388608.0;
const char* const NotTold =
  "the driver does not tell the depths of samples to the bit, which ranks "
  "need; call SetMultiSamples(0)";
constexpr std::uint32_t SignBit = 0x80000000u; // of depths that were not found
// From this depth on floats have steps of 2^-24, so that no smaller step of a search changes them.
constexpr std::uint32_t FirstCoarseDepth = 0x3f100000u; // 0.5625
constexpr double CoarseStep = 1.0 / 16777216.0;

std::size_t PixelsOfPlane(const RenderTarget& target)
{
  return std::size_t(target.Width) * target.Height;
}

// Returns true if each depth of the region was found, and none is nearer than `nearest`.
bool AreFound(const RenderTarget& target, const std::uint32_t* depths, std::uint32_t nearest)
{
  const PixelRegion& r = target.Region;
  bool all = true;
  for (int y = r.Y; y < r.Y + r.Height; ++y)
  {
    for (int x = r.X; x < r.X + r.Width; ++x)
    {
      const std::uint32_t depth = depths[std::size_t(y) * target.Width + x];
      all = all && depth < SignBit && depth >= nearest;
    }
  }
  return all;
}

}

//------------------------------------------------------------------------------
std::string SamplePixels::PrepareColors(vtkOpenGLRenderWindow* window, const RenderTarget& target)
{
  const std::string problem = this->Colors.Prepare(window->GetState(), target,
    { target.Color.InternalFormat, GL_RGBA, TargetPixels::ColorType(target) });
  return problem.empty() && !this->Colors.Compile(window, target) ? ProgramFailure : problem;
}

//------------------------------------------------------------------------------
std::string SamplePixels::PrepareDepths(vtkOpenGLRenderWindow* window, const RenderTarget& target)
{
  const std::string problem = this->Depths.Prepare(window->GetState(), target, DepthFormat);
  return problem.empty() && !this->Depths.Compile(window, target) ? ProgramFailure : problem;
}

//------------------------------------------------------------------------------
std::string SamplePixels::ReadColors(
  vtkOpenGLRenderWindow* window, const RenderTarget& target, std::vector<std::uint32_t>& words)
{
  const std::size_t wordsOfPlane = PixelsOfPlane(target) * TargetPixels::ColorWords(target);
  words.resize(wordsOfPlane * target.Samples);
  std::string problem = this->PrepareColors(window, target);
  if (problem.empty())
  {
    problem = this->ColorCopy.Copy(window->GetState(), target);
  }
  const ScopedEncoding encoding(target.EncodesSRGB);
  for (int sample = 0; sample < target.Samples && problem.empty(); ++sample)
  {
    this->Colors.Read(
      window, target, this->ColorCopy.Image(), sample, &words[sample * wordsOfPlane]);
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string SamplePixels::WriteColors(vtkOpenGLRenderWindow* window, const RenderTarget& target,
  const std::vector<std::uint32_t>& words)
{
  const std::size_t wordsOfPlane = PixelsOfPlane(target) * TargetPixels::ColorWords(target);
  std::string problem = this->PrepareColors(window, target);
  const ScopedEncoding encoding(target.EncodesSRGB);
  for (int sample = 0; sample < target.Samples && problem.empty(); ++sample)
  {
    this->Colors.Write(window, target, sample, &words[sample * wordsOfPlane]);
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string SamplePixels::ReadDepths(
  vtkOpenGLRenderWindow* window, const RenderTarget& target, std::vector<std::uint32_t>& words)
{
  words.resize(PixelsOfPlane(target) * target.Samples);
  std::string problem = this->PrepareDepths(window, target);
  if (problem.empty())
  {
    problem = this->PrepareSearch(window, target);
  }
  const int copy = problem.empty() ? this->DepthToSample.UnitOf(window->GetState(), target) : -1;
  if (problem.empty() && copy < 0)
  {
    problem = this->DepthToSample.Problem();
  }
  if (problem.empty() && !this->Search(window, target, copy, words))
  {
    problem = NotTold;
  }
  this->DepthToSample.EndFrame();
  return problem;
}

//------------------------------------------------------------------------------
std::string SamplePixels::WriteDepths(vtkOpenGLRenderWindow* window, const RenderTarget& target,
  const std::vector<std::uint32_t>& words)
{
  std::string problem = this->PrepareDepths(window, target);
  for (int sample = 0; sample < target.Samples && problem.empty(); ++sample)
  {
    this->Depths.Write(window, target, sample, &words[sample * PixelsOfPlane(target)]);
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string SamplePixels::PrepareSearch(vtkOpenGLRenderWindow* window, const RenderTarget& target)
{
  vtkOpenGLState* const state = window->GetState();
  for (DepthImage* const image : { &this->Found, &this->Next })
  {
    const std::string problem =
      image->Depths.Allocate(DepthFormat.Image, target.Width, target.Height, target.Samples);
    if (!problem.empty())
    {
      return problem;
    }
    image->Target.Attach(state, image->Depths);
    BindForDrawing(state, image->Target.Handle());
    target.AttachDepth();
    if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    {
      return NotTold;
    }
  }
  return this->ReadyCompare(window) ? std::string() : ProgramFailure;
}

//------------------------------------------------------------------------------
// Takes the sampled depths if all of them are those of the samples. Else floats are searched for the others: the search
// goes up from a depth that is not farther, as long as the depth test finds none nearer. Steps get smaller by half,
// down to those of the depth buffer. So the last float is the largest that is not farther. If all depths are coarse,
// the smaller steps change none and are left out. What is found depends on the depth of the sample alone.
bool SamplePixels::Search(vtkOpenGLRenderWindow* window, const RenderTarget& target, int copy,
  std::vector<std::uint32_t>& words)
{
  vtkOpenGLState* const state = window->GetState();
  const auto compare = [&](double offset, GLenum test)
  {
    const ScopedTextureUnit unit(state, this->Found.Depths.Target(), this->Found.Depths.Handle());
    this->Compare(window, target, unit.Unit(), offset, test);
  };
  this->ClearNext(state);
  this->Compare(window, target, copy, 0.0, GL_EQUAL);
  if (this->ReadFound(window, target, 0u, words))
  {
    return true;
  }
  const double smallest = std::ldexp(1.0, -std::max(target.Depth.DepthBits, 25));
  double step = 2.0 * LossOfSamplers;
  this->Compare(window, target, copy, -step, GL_ALWAYS);
  for (const bool isLast : { false, true })
  {
    for (; step >= (isLast ? smallest : CoarseStep); step /= 2.0)
    {
      this->CopyToNext(state, target);
      compare(step, GL_LEQUAL);
    }
    this->ClearNext(state);
    compare(0.0, GL_EQUAL);
    std::swap(this->Found, this->Next); // to draw over it
    this->Compare(window, target, copy, 0.0, GL_EQUAL);
    if (this->ReadFound(window, target, isLast ? 0u : FirstCoarseDepth, words))
    {
      return true;
    }
    std::swap(this->Found, this->Next); // to what was compared
  }
  return false;
}

//------------------------------------------------------------------------------
// Returns false, without reading all, if a depth was not found or is nearer than `nearest`.
bool SamplePixels::ReadFound(vtkOpenGLRenderWindow* window, const RenderTarget& target,
  std::uint32_t nearest, std::vector<std::uint32_t>& words)
{
  bool all = true;
  for (int sample = 0; sample < target.Samples && all; ++sample)
  {
    std::uint32_t* const depths = &words[sample * PixelsOfPlane(target)];
    this->Depths.Read(window, target, this->Found.Depths, sample, depths);
    all = AreFound(target, depths, nearest);
  }
  return all;
}

//------------------------------------------------------------------------------
vtkShaderProgram* SamplePixels::ReadyCompare(vtkOpenGLRenderWindow* window)
{
  return this->Programs.Ready(
    window, "compare", {}, shaders::FullScreenVertex, [] { return shaders::SampleDepth; });
}

//------------------------------------------------------------------------------
// Sets the samples of `Next` whose depths pass the test to these depths: those of a texture unit, and an offset. Then
// they are in `Found`.
void SamplePixels::Compare(vtkOpenGLRenderWindow* window, const RenderTarget& target, int source,
  double offset, unsigned int test)
{
  vtkOpenGLState* const state = window->GetState();
  BindForFullScreenDraw(state, this->Next.Target.Handle(), target.Width, target.Height);
  state->vtkglEnable(GL_MULTISAMPLE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(test);
  const ScopedSampleMask sampleMask;
  const BoundVertexArray vertexArray(this->VertexArray.Handle());
  vtkShaderProgram* const program = this->ReadyCompare(window);
  program->SetUniformi("source", source);
  program->SetUniformf("offset", static_cast<float>(offset));
  glDrawArrays(GL_TRIANGLES, 0, 3);
  std::swap(this->Found, this->Next);
}

//------------------------------------------------------------------------------
void SamplePixels::CopyToNext(vtkOpenGLState* state, const RenderTarget& target)
{
  BindForReading(state, this->Found.Target.Handle());
  BindForDrawing(state, this->Next.Target.Handle());
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglBlitFramebuffer(0, 0, target.Width, target.Height, 0, 0, target.Width, target.Height,
    GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

//------------------------------------------------------------------------------
void SamplePixels::ClearNext(vtkOpenGLState* state)
{
  BindForDrawing(state, this->Next.Target.Handle());
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClearBufferfv(GL_COLOR, 0, NotFound);
}

//------------------------------------------------------------------------------
std::int64_t SamplePixels::Bytes() const
{
  return this->Colors.Bytes() + this->Depths.Bytes() + this->ColorCopy.Image().Bytes() +
    this->DepthToSample.Bytes() + this->Found.Depths.Bytes() + this->Next.Depths.Bytes();
}

//------------------------------------------------------------------------------
void SamplePixels::Release()
{
  this->Colors.Release();
  this->Depths.Release();
  this->ColorCopy.Release();
  this->DepthToSample.Release();
  for (DepthImage* const image : { &this->Found, &this->Next })
  {
    image->Depths.Release();
    image->Target.Release();
  }
  this->VertexArray.Release();
  this->Programs.Release();
}

}
