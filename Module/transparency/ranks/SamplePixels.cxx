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
// The bit of the sign, which words of NotFound have. It stands for a depth that is searched.
constexpr std::uint32_t Unknown = 0x80000000u;
// From this depth on floats have steps of 2^-24, so that no smaller step of a search changes them.
constexpr std::uint32_t FirstCoarseDepth = 0x3f100000u; // 0.5625
constexpr double CoarseStep = 1.0 / 16777216.0;

std::size_t PixelsOfPlane(const RenderTarget& target)
{
  return std::size_t(target.Width) * target.Height;
}

// Returns the rectangle around both.
PixelRegion BoxOf(const PixelRegion& a, const PixelRegion& b)
{
  if (a.IsEmpty() || b.IsEmpty())
  {
    return a.IsEmpty() ? b : a;
  }
  const int x = std::min(a.X, b.X);
  const int y = std::min(a.Y, b.Y);
  return { x, y, std::max(a.X + a.Width, b.X + b.Width) - x,
    std::max(a.Y + a.Height, b.Y + b.Height) - y };
}

// Takes the depths of a region that were found and are not nearer than `nearest`, where none is known. Returns the
// rectangle of those that stay unknown.
PixelRegion TakeFound(const PixelRegion& region, int width, const std::uint32_t* found,
  std::uint32_t nearest, std::uint32_t* depths)
{
  PixelRegion unknown;
  for (int y = region.Y; y < region.Y + region.Height; ++y)
  {
    for (int x = region.X; x < region.X + region.Width; ++x)
    {
      const std::size_t pixel = std::size_t(y) * width + x;
      if (depths[pixel] == Unknown && found[pixel] < Unknown && found[pixel] >= nearest)
      {
        depths[pixel] = found[pixel];
      }
      if (depths[pixel] == Unknown)
      {
        unknown = BoxOf(unknown, { x, y, 1, 1 });
      }
    }
  }
  return unknown;
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
// Takes the sampled depths that are those of the samples. Floats are searched for the others, in their rectangle: the
// search goes up from a depth that is not farther, as long as the depth test finds none nearer. Steps get smaller by
// half, down to those of the depth buffer. So the last float is the largest that is not farther. Smaller steps change
// no coarse depth, so these are taken before. What is found depends on the depth of the sample alone.
bool SamplePixels::Search(vtkOpenGLRenderWindow* window, const RenderTarget& target, int copy,
  std::vector<std::uint32_t>& words)
{
  vtkOpenGLState* const state = window->GetState();
  PixelRegion region = target.Region; // of the depths that are unknown
  const auto compare = [&](double offset, GLenum test)
  {
    const ScopedTextureUnit unit(state, this->Found.Depths.Target(), this->Found.Depths.Handle());
    this->Compare(window, target, region, unit.Unit(), offset, test);
  };
  words.assign(PixelsOfPlane(target) * target.Samples, Unknown);
  this->ClearNext(state, region);
  this->Compare(window, target, region, copy, 0.0, GL_EQUAL);
  region = this->ReadFound(window, target, region, 0u, words);
  if (region.IsEmpty())
  {
    return true;
  }
  const double smallest = std::ldexp(1.0, -std::max(target.Depth.DepthBits, 25));
  double step = 2.0 * LossOfSamplers;
  this->Compare(window, target, region, copy, -step, GL_ALWAYS);
  for (const bool isLast : { false, true })
  {
    for (; step >= (isLast ? smallest : CoarseStep); step /= 2.0)
    {
      this->CopyToNext(state, region);
      compare(step, GL_LEQUAL);
    }
    this->ClearNext(state, region);
    compare(0.0, GL_EQUAL);
    const PixelRegion left =
      this->ReadFound(window, target, region, isLast ? 0u : FirstCoarseDepth, words);
    if (left.IsEmpty())
    {
      return true;
    }
    region = left;
    std::swap(this->Found, this->Next); // to what was compared
  }
  return false;
}

//------------------------------------------------------------------------------
// Returns the rectangle of the depths that were not found or are nearer than `nearest`.
PixelRegion SamplePixels::ReadFound(vtkOpenGLRenderWindow* window, const RenderTarget& target,
  const PixelRegion& region, std::uint32_t nearest, std::vector<std::uint32_t>& words)
{
  PixelRegion unknown;
  std::vector<std::uint32_t> found(PixelsOfPlane(target));
  for (int sample = 0; sample < target.Samples; ++sample)
  {
    this->Depths.Read(window, target, this->Found.Depths, sample, found.data());
    unknown = BoxOf(unknown,
      TakeFound(region, target.Width, found.data(), nearest, &words[sample * found.size()]));
  }
  return unknown;
}

//------------------------------------------------------------------------------
vtkShaderProgram* SamplePixels::ReadyCompare(vtkOpenGLRenderWindow* window)
{
  return this->Programs.Ready(
    window, "compare", {}, shaders::FullScreenVertex, [] { return shaders::SampleDepth; });
}

//------------------------------------------------------------------------------
// Sets the samples of a region of `Next` whose depths pass the test to these depths: those of a texture unit, and an
// offset. Then they are in `Found`.
void SamplePixels::Compare(vtkOpenGLRenderWindow* window, const RenderTarget& target,
  const PixelRegion& region, int source, double offset, unsigned int test)
{
  vtkOpenGLState* const state = window->GetState();
  BindForFullScreenDraw(state, this->Next.Target.Handle(), target.Width, target.Height, region);
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
void SamplePixels::CopyToNext(vtkOpenGLState* state, const PixelRegion& region)
{
  BindForReading(state, this->Found.Target.Handle());
  BindForDrawing(state, this->Next.Target.Handle());
  state->vtkglDisable(GL_SCISSOR_TEST);
  const int right = region.X + region.Width;
  const int top = region.Y + region.Height;
  state->vtkglBlitFramebuffer(region.X, region.Y, right, top, region.X, region.Y, right, top,
    GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

//------------------------------------------------------------------------------
void SamplePixels::ClearNext(vtkOpenGLState* state, const PixelRegion& region)
{
  BindForDrawing(state, this->Next.Target.Handle());
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(region.X, region.Y, region.Width, region.Height);
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
