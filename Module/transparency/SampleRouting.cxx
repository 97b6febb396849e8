#include "transparency/SampleRouting.h"

#include "gl/FullScreenDraw.h"
#include "gl/ScopedState.h"
#include "transparency/ShaderText.h"
#include "transparency/StencilCounter.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <algorithm>

namespace vitrine
{
namespace
{

GLint MostSamples()
{
  GLint samples[3] = { 0, 0, 0 };
  glGetIntegerv(GL_MAX_SAMPLES, &samples[0]);
  glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &samples[1]);
  glGetIntegerv(GL_MAX_DEPTH_TEXTURE_SAMPLES, &samples[2]);
  return *std::min_element(samples, samples + 3);
}

// Draws a fragment into every pixel. Returns whether a sample let it through.
bool DrawsThrough()
{
  GLuint query = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEndQuery(GL_SAMPLES_PASSED);
  GLuint passed = 0;
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &passed);
  glDeleteQueries(1, &query);
  return passed > 0;
}

}

const std::string& SampleRouting::FindObstacle(vtkOpenGLRenderWindow* window, int samples)
{
  const auto [entry, isNew] = this->Obstacles.try_emplace(samples);
  if (isNew && samples > 1)
  {
    entry->second = this->Probe(window, StencilRoute(samples));
  }
  return entry->second;
}

std::string SampleRouting::Probe(vtkOpenGLRenderWindow* window, const StencilRoute& route)
{
  const int samples = route.SamplesPerPass();
  if (samples > MostSamples())
  {
    return std::to_string(samples) +
      " samples a pixel are asked for, and the driver's images have " +
      std::to_string(MostSamples()) + " at most";
  }
  vtkOpenGLState* state = window->GetState();
  Image2D stencil;
  Framebuffer target;
  std::string problem = stencil.Allocate(StencilCounter::StencilFormat, 1, 1, samples);
  if (problem.empty())
  {
    AttachStencilAlone(state, target, stencil);
    BindForFullScreenDraw(state, target.Handle(), 1, 1);
    problem = this->RoutesOneByOne(window, route)
      ? std::string()
      : "the driver tests the stencil of one sample for all of a pixel where multisampling is off, "
        "as OpenGL allows, so " +
        std::to_string(samples) + " samples take no more than one does";
  }
  target.Release();
  stencil.Release();
  return problem;
}

// As many fragments pass, one by one, as there are samples, and no more.
bool SampleRouting::RoutesOneByOne(vtkOpenGLRenderWindow* window, const StencilRoute& route)
{
  if (!this->WriteStart(window, route))
  {
    return false;
  }
  const ScopedVertexArray vertexArray(this->VertexArray.Handle());
  RouteFragments(window->GetState(), route, 0);
  window->GetState()->vtkglDisable(GL_MULTISAMPLE);
  int passed = 0;
  while (passed <= route.SamplesPerPass() && DrawsThrough())
  {
    ++passed;
  }
  return passed == route.SamplesPerPass();
}

// A driver may make more samples than it was asked for: those begin with 0, which lets nothing through.
bool SampleRouting::WriteStart(vtkOpenGLRenderWindow* window, const StencilRoute& route)
{
  vtkOpenGLState* state = window->GetState();
  const bool single = route.SamplesPerPass() == 1;
  state->vtkglStencilMask(0xff);
  const GLint all = single ? route.StartValue(0) : 0;
  glClearBufferiv(GL_STENCIL, 0, &all);
  if (single)
  {
    return true;
  }
  const ScopedVertexArray vertexArray(this->VertexArray.Handle());
  const ScopedSampleMask sampleMask;
  if (!this->Programs.Ready(
        window, "stencil", {}, shaders::FullScreenVertex, [] { return shaders::StencilOnly; }))
  {
    return false;
  }
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglEnable(GL_MULTISAMPLE);
  state->vtkglEnable(GL_STENCIL_TEST);
  state->vtkglStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
  for (int i = 0; i < route.SamplesPerPass(); ++i)
  {
    ScopedSampleMask::DrawInto(i);
    state->vtkglStencilFunc(GL_ALWAYS, route.StartValue(i), 0xff);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  return true;
}

void SampleRouting::Release()
{
  this->Obstacles.clear();
  this->VertexArray.Release();
  this->Programs.Release();
}

void RouteFragments(vtkOpenGLState* state, const StencilRoute& route, int pass)
{
  state->vtkglEnable(GL_STENCIL_TEST);
  state->vtkglStencilFunc(GL_EQUAL, route.PassingValue(pass), 0xff);
  state->vtkglStencilOp(GL_DECR, GL_DECR, GL_DECR);
}

}
