#include "transparency/stencil/RoutingProbe.h"

#include "gl/FullScreenDraw.h"
#include "gl/ScopedState.h"
#include "gl/StateRecord.h"
#include "shader/ShaderText.h"
#include "transparency/stencil/RoutedImages.h"
#include "transparency/stencil/SampleRouting.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>

namespace vitrine
{
namespace
{

// Distance of edges from the pixel's centre, in coordinates in which a pixel is 2 wide. It is an eighth of a pixel:
// small enough that samples lie beyond it, and a multiple of the drivers' subpixel steps.
constexpr float NearCentre = 0.25f;

// Number of fragments that do not cover the pixel's centre. Those that cover it are numbered from 0. Cleared samples
// have 255.
constexpr int StrayNumber = 64;

GLint MostSamples()
{
  GLint samples[3] = { 0, 0, 0 };
  glGetIntegerv(GL_MAX_SAMPLES, &samples[0]);
  glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &samples[1]);
  glGetIntegerv(GL_MAX_DEPTH_TEXTURE_SAMPLES, &samples[2]);
  return *std::min_element(samples, samples + 3);
}

// Draws a fragment that covers everything on one side of an edge. Side 1 is the left one.
void DrawUpTo(vtkShaderProgram* program, float edge, float side, int number)
{
  program->SetUniformf("edge", edge);
  program->SetUniformf("side", side);
  program->SetUniformi("number", number);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

/** Binds no framebuffer. Where a bound one is deleted, OpenGL does so by itself, but the record would not show it. */
void LeaveFramebuffers(vtkOpenGLState* state)
{
  BindForDrawing(state, 0);
  BindForReading(state, 0);
}

std::array<GLubyte, 4> ReadPixel(vtkOpenGLState* state, Framebuffer& source)
{
  std::array<GLubyte, 4> pixel = {};
  const ScopedPixelTransfer pixelTransfer(ScopedPixelTransfer::FROM_DEVICE);
  BindForReading(state, source.Handle());
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  return pixel;
}

std::string DescribeVerdict(bool strayed, bool routed, int samples)
{
  const std::string those = std::to_string(samples) + " samples of a pixel";
  if (strayed)
  {
    return "the driver goes on multisampling where it is switched off, so that fragments do not "
           "cover all " +
      those + " alike";
  }
  if (!routed)
  {
    return "where multisampling is off, the driver does not let one fragment through to each of " +
      those + ": OpenGL allows it to test the stencil of one sample for all";
  }
  return {};
}

}

const std::string& RoutingProbe::FindObstacle(
  vtkOpenGLRenderWindow* window, SampleRouting& routing, int samples, bool halfFloat)
{
  const auto [entry, isNew] = this->Obstacles.try_emplace({ samples, halfFloat });
  if (isNew && samples > 1)
  {
    entry->second = this->Probe(window, routing, StencilRoute(samples), halfFloat);
  }
  return entry->second;
}

std::string RoutingProbe::Probe(
  vtkOpenGLRenderWindow* window, SampleRouting& routing, const StencilRoute& route, bool halfFloat)
{
  const int samples = route.SamplesPerPass();
  if (samples > MostSamples())
  {
    return std::to_string(samples) +
      " samples a pixel are asked for, and the driver's images have " +
      std::to_string(MostSamples()) + " at most";
  }
  vtkOpenGLState* state = window->GetState();
  const ScopedSampleMask sampleMask;
  RoutedImages images;
  std::string problem = images.Allocate(state, { 1, 1, samples, halfFloat }, 1);
  if (problem.empty())
  {
    BindForFullScreenDraw(state, images.Target().Handle(), 1, 1);
    problem = routing.WriteStart(window, route) && this->DrawFragments(window, route)
      ? this->Judge(window, route, images)
      : ProgramFailure;
  }
  LeaveFramebuffers(state);
  images.Release();
  return problem;
}

// Draws one fragment more than there are samples. Before each of them, two stray fragments end short of the pixel's
// centre, on either side. If the driver tests coverage per sample, these get into the samples meant for the next
// fragment.
bool RoutingProbe::DrawFragments(vtkOpenGLRenderWindow* window, const StencilRoute& route)
{
  const ScopedVertexArray vertexArray(this->VertexArray.Handle());
  vtkShaderProgram* program = this->Programs.Ready(window, "fragment", {},
    shaders::StencilRoutedProbeVertex, [] { return shaders::StencilRoutedProbe; });
  if (!program)
  {
    return false;
  }
  const GLfloat nothing[4] = { 1.0f, 1.0f, 1.0f, 1.0f };
  glClearBufferfv(GL_COLOR, 0, nothing);
  glClearBufferfv(GL_COLOR, 1, nothing);
  RouteFragments(window->GetState(), route, 0);
  for (int i = 0; i <= route.SamplesPerPass(); ++i)
  {
    DrawUpTo(program, -NearCentre, 1.0f, StrayNumber);
    DrawUpTo(program, -NearCentre, -1.0f, StrayNumber);
    DrawUpTo(program, NearCentre, i % 2 == 0 ? 1.0f : -1.0f, i);
  }
  return true;
}

// Reads the samples as a resolve does. The fragments' own colours tell the verdict. A query of passed samples is
// avoided, since the application may have one running.
std::string RoutingProbe::Judge(
  vtkOpenGLRenderWindow* window, const StencilRoute& route, const RoutedImages& images)
{
  vtkOpenGLState* state = window->GetState();
  Image2D image;
  Framebuffer target;
  std::string problem = image.Allocate(GL_RGBA8, 1, 1, 0);
  if (!problem.empty())
  {
    return problem;
  }
  BindForFullScreenDraw(state, target.Handle(), 1, 1);
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, image.Handle(), 0);
  const ScopedVertexArray vertexArray(this->VertexArray.Handle());
  const ScopedTextureUnit colors(state, images.Colors().Target(), images.Colors().Handle());
  const ScopedTextureUnit depths(state, images.Depths().Target(), images.Depths().Handle());
  vtkShaderProgram* program = this->Programs.Ready(window, "verdict",
    { "VITRINE_ROUTED_SAMPLES " + std::to_string(route.SamplesPerPass()),
      "VITRINE_PROBE_STRAY " + std::to_string(StrayNumber) },
    shaders::FullScreenVertex, [] { return shaders::StencilRoutedVerdict; });
  if (program)
  {
    program->SetUniformi("routedColors", colors.Unit());
    program->SetUniformi("routedDepths", depths.Unit());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    const std::array<GLubyte, 4> verdict = ReadPixel(state, target);
    problem = DescribeVerdict(verdict[0] > 0, verdict[1] > 0, route.SamplesPerPass());
  }
  else
  {
    problem = ProgramFailure;
  }
  LeaveFramebuffers(state);
  target.Release();
  image.Release();
  return problem;
}

void RoutingProbe::Release()
{
  this->Obstacles.clear();
  this->VertexArray.Release();
  this->Programs.Release();
}

}
