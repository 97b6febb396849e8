#include "transparency/common/SamplePlane.h"

#include "gl/FullScreenDraw.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "gl/StateRecord.h"
#include "shader/ShaderText.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <optional>
#include <vector>

namespace vitrine
{

std::string SamplePlane::Prepare(
  vtkOpenGLState* state, const RenderTarget& target, const Format& format)
{
  this->Transfer = format;
  std::string problem = this->Picture.Allocate(format.Image, target.Width, target.Height, 0);
  if (problem.empty())
  {
    this->Target.Attach(state, this->Picture);
  }
  return problem;
}

bool SamplePlane::Compile(vtkOpenGLRenderWindow* window, const RenderTarget& target)
{
  return this->ReadyRead(window, target) && this->ReadyWrite(window);
}

vtkShaderProgram* SamplePlane::ReadyRead(vtkOpenGLRenderWindow* window, const RenderTarget& target)
{
  return this->Programs.Ready(window, "read",
    { "VITRINE_SAMPLES " + std::to_string(target.Samples) }, shaders::FullScreenVertex,
    [] { return shaders::SampleRead; });
}

vtkShaderProgram* SamplePlane::ReadyWrite(vtkOpenGLRenderWindow* window)
{
  const std::vector<std::string> defines = this->Transfer.HasDepth
    ? std::vector<std::string>{ "VITRINE_SAMPLE_DEPTH" }
    : std::vector<std::string>();
  return this->Programs.Ready(
    window, "write", defines, shaders::FullScreenVertex, [] { return shaders::SampleWrite; });
}

void SamplePlane::Draw(
  vtkOpenGLRenderWindow* window, vtkShaderProgram* program, const Image2D& source)
{
  const BoundVertexArray vertexArray(this->VertexArray.Handle());
  const ScopedTextureUnit unit(window->GetState(), source.Target(), source.Handle());
  program->SetUniformi("source", unit.Unit());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void SamplePlane::Read(vtkOpenGLRenderWindow* window, const RenderTarget& target,
  const Image2D& source, int sample, void* pixels)
{
  vtkOpenGLState* const state = window->GetState();
  BindForFullScreenDraw(state, this->Target.Handle(), target.Width, target.Height);
  vtkShaderProgram* const program = this->ReadyRead(window, target);
  program->SetUniformi("sampleNumber", sample);
  this->Draw(window, program, source);
  BindForReading(state, this->Target.Handle());
  const ScopedPixelTransfer pixelTransfer(ScopedPixelTransfer::FROM_DEVICE);
  glReadPixels(
    0, 0, target.Width, target.Height, this->Transfer.Pixels, this->Transfer.Type, pixels);
}

void SamplePlane::Write(
  vtkOpenGLRenderWindow* window, const RenderTarget& target, int sample, const void* pixels)
{
  vtkOpenGLState* const state = window->GetState();
  {
    const ScopedPixelTransfer pixelTransfer(ScopedPixelTransfer::TO_DEVICE);
    const ScopedTextureUnit unit(state, GL_TEXTURE_2D, this->Picture.Handle());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, target.Width, target.Height, this->Transfer.Pixels,
      this->Transfer.Type, pixels);
  }
  BindForFullScreenDraw(state, target.Framebuffer, target.Width, target.Height);
  if (this->Transfer.HasDepth)
  {
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(GL_ALWAYS);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  }
  vtkShaderProgram* const program = this->ReadyWrite(window);
  const PixelRegion& r = target.Region;
  const int first[2] = { r.X, r.Y };
  const int end[2] = { r.X + r.Width, r.Y + r.Height };
  program->SetUniform2i("regionFirst", first);
  program->SetUniform2i("regionEnd", end);
  std::optional<ScopedSampleMask> sampleMask;
  if (target.Samples > 0)
  {
    sampleMask.emplace();
    state->vtkglEnable(GL_MULTISAMPLE);
    ScopedSampleMask::DrawInto(sample);
  }
  this->Draw(window, program, this->Picture);
}

void SamplePlane::Release()
{
  this->Picture.Release();
  this->Target.Release();
  this->VertexArray.Release();
  this->Programs.Release();
}

}
