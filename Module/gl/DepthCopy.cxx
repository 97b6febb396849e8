#include "gl/DepthCopy.h"

#include "gl/Capabilities.h"
#include "gl/RenderTarget.h"
#include "gl/StateRecord.h"
#include "vtkOpenGLState.h"

namespace vitrine
{
namespace
{

void BlitDepth(vtkOpenGLState* state, const PixelRegion& r)
{
  state->vtkglBlitFramebuffer(r.X, r.Y, r.X + r.Width, r.Y + r.Height, r.X, r.Y, r.X + r.Width,
    r.Y + r.Height, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

// Copies the depth of the framebuffer bound for reading to the same pixels of a buffer with rows of `width` pixels.
void ReadDepth(const PixelRegion& r, int width, GLuint buffer)
{
  const ScopedPixelTransfer pixelTransfer(ScopedPixelTransfer::FROM_DEVICE);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
  glPixelStorei(GL_PACK_ROW_LENGTH, width);
  glPixelStorei(GL_PACK_SKIP_ROWS, r.Y);
  glPixelStorei(GL_PACK_SKIP_PIXELS, r.X);
  glReadPixels(r.X, r.Y, r.Width, r.Height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
}

}

int DepthCopy::UnitOf(vtkOpenGLState* state, const RenderTarget& target)
{
  if (!this->Binding && this->WhyNone.empty())
  {
    this->WhyNone =
      target.DepthIntegers ? this->CopyIntegers(state, target) : this->CopyImage(state, target);
    if (this->WhyNone.empty())
    {
      this->Binding = std::make_unique<ScopedTextureUnit>(state,
        target.DepthIntegers ? GL_TEXTURE_BUFFER : this->Depth.Target(),
        target.DepthIntegers ? this->Integers.Texture() : this->Depth.Handle());
    }
  }
  return this->Binding ? this->Binding->Unit() : -1;
}

std::string DepthCopy::CopyImage(vtkOpenGLState* state, const RenderTarget& target)
{
  this->Integers.Release();
  std::string problem =
    this->Depth.Allocate(target.Depth.InternalFormat, target.Width, target.Height, target.Samples);
  if (!problem.empty())
  {
    return problem;
  }
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, target.Framebuffer);
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Target.Handle());
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, target.ReadyDepthAttachment(), this->Depth.Target(),
    this->Depth.Handle(), 0);
  SetDrawBuffers(state, { GL_NONE });
  BlitDepth(state, target.Region);
  state->PopFramebufferBindings();
  return {};
}

std::string DepthCopy::CopyIntegers(vtkOpenGLState* state, const RenderTarget& target)
{
  this->Depth.Release();
  const std::int64_t pixels = std::int64_t(target.Width) * target.Height;
  if (pixels > LargestBufferTexture())
  {
    return "the opaque depth takes a buffer texture of " + std::to_string(pixels) +
      " texels, and the driver's largest has " + std::to_string(LargestBufferTexture());
  }
  const std::int64_t size = pixels * std::int64_t(sizeof(GLuint));
  if (this->Integers.Bytes() != size && !this->Integers.Allocate(size, GL_R32UI))
  {
    return "the driver has no memory for the opaque depth, " + std::to_string(size) + " bytes";
  }
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, target.Framebuffer);
  ReadDepth(target.Region, target.Width, this->Integers.Handle());
  state->PopFramebufferBindings();
  return {};
}

void DepthCopy::EndFrame()
{
  this->Binding.reset();
  this->WhyNone.clear();
}

void DepthCopy::Release()
{
  this->EndFrame();
  this->Depth.Release();
  this->Target.Release();
  this->Integers.Release();
}

}
