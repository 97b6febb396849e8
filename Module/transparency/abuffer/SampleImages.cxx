#include "transparency/abuffer/SampleImages.h"

#include "gl/RenderTarget.h"
#include "gl/StateRecord.h"

#include <vector>

namespace vitrine
{

std::string SampleImages::Prepare(vtkOpenGLState* state, const RenderTarget& target)
{
  std::string problem = this->Layers.Allocate(
    target.Color.InternalFormat, target.Width, target.Height, 0, target.Samples);
  if (!problem.empty() || this->Attached == this->Layers.Number())
  {
    return problem;
  }
  this->Target.Release(); // It may have more images attached.
  BindForDrawing(state, this->Target.Handle());
  std::vector<GLenum> outputs;
  for (int sample = 0; sample < target.Samples; ++sample)
  {
    outputs.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(sample));
    glFramebufferTextureLayer(
      GL_DRAW_FRAMEBUFFER, outputs.back(), this->Layers.Handle(), 0, sample);
  }
  SetDrawBuffers(state, outputs);
  this->Attached = this->Layers.Number();
  return {};
}

void SampleImages::Release()
{
  this->Layers.Release();
  this->Target.Release();
  this->Attached = 0;
}

}
