#include "gl/TargetPixels.h"

#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "gl/StateRecord.h"
#include "vtkOpenGLState.h"

#include <cstddef>

namespace vitrine
{
namespace
{

// How the pixels of a depth format are transferred.
struct DepthTransfer
{
  GLenum Format;
  GLenum Type;
  int Words; // of a pixel; the first has the depth
};

bool HasFloatDepth(GLenum format)
{
  return format == GL_DEPTH_COMPONENT32F || format == GL_DEPTH32F_STENCIL8;
}

// An image with a stencil is written as a whole.
DepthTransfer WritingOf(GLenum format)
{
  switch (format)
  {
    case GL_DEPTH24_STENCIL8:
      return { GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, 1 };
    case GL_DEPTH32F_STENCIL8:
      return { GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, 2 };
    default:
      return { GL_DEPTH_COMPONENT,
        HasFloatDepth(format) ? GLenum(GL_FLOAT) : GLenum(GL_UNSIGNED_INT), 1 };
  }
}

std::size_t PixelsOf(const RenderTarget& target)
{
  return std::size_t(target.Width) * target.Height;
}

std::vector<std::uint32_t> Read(
  vtkOpenGLState* state, const RenderTarget& target, int wordsOfPixel, GLenum format, GLenum type)
{
  std::vector<std::uint32_t> words(PixelsOf(target) * wordsOfPixel);
  const ScopedPixelTransfer pixelTransfer(ScopedPixelTransfer::FROM_DEVICE);
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, target.Framebuffer);
  const ScopedReadBuffer readBuffer(state, target.DrawBuffer);
  glReadPixels(0, 0, target.Width, target.Height, format, type, words.data());
  return words;
}

void Upload(vtkOpenGLState* state, const RenderTarget& target, const Image2D& image, GLenum format,
  GLenum type, const void* pixels)
{
  const ScopedPixelTransfer pixelTransfer(ScopedPixelTransfer::TO_DEVICE);
  const ScopedTextureUnit texture(state, GL_TEXTURE_2D, image.Handle());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, target.Width, target.Height, format, type, pixels);
}

// Copies from the framebuffer that is bound for reading.
void BlitInto(vtkOpenGLState* state, const RenderTarget& target, GLbitfield buffers)
{
  const PixelRegion& r = target.Region;
  BindForDrawing(state, target.Framebuffer);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglBlitFramebuffer(r.X, r.Y, r.X + r.Width, r.Y + r.Height, r.X, r.Y, r.X + r.Width,
    r.Y + r.Height, buffers, GL_NEAREST);
}

}

int TargetPixels::ColorWords(const RenderTarget& target)
{
  return target.EightBit || target.EncodesSRGB ? 1 : 4;
}

GLenum TargetPixels::ColorType(const RenderTarget& target)
{
  return ColorWords(target) == 1 ? GL_UNSIGNED_BYTE : GL_FLOAT;
}

std::uint32_t TargetPixels::Farthest(const RenderTarget& target)
{
  const bool hasFloats = HasFloatDepth(target.Depth.InternalFormat) || target.Samples > 0;
  return hasFloats ? 0x3f800000u : 0xffffffffu;
}

std::vector<std::uint32_t> TargetPixels::ReadColors(
  vtkOpenGLState* state, const RenderTarget& target)
{
  return Read(state, target, ColorWords(target), GL_RGBA, ColorType(target));
}

std::vector<std::uint32_t> TargetPixels::ReadDepths(
  vtkOpenGLState* state, const RenderTarget& target)
{
  return Read(state, target, 1, GL_DEPTH_COMPONENT,
    HasFloatDepth(target.Depth.InternalFormat) ? GL_FLOAT : GL_UNSIGNED_INT);
}

std::string TargetPixels::WriteColors(
  vtkOpenGLState* state, const RenderTarget& target, const std::vector<std::uint32_t>& words)
{
  std::string problem =
    this->Colors.Allocate(target.Color.InternalFormat, target.Width, target.Height, 0);
  if (!problem.empty())
  {
    return problem;
  }
  Upload(state, target, this->Colors, GL_RGBA, ColorType(target), words.data());
  this->ColorTarget.Attach(state, this->Colors);
  BindForReading(state, this->ColorTarget.Handle());
  BlitInto(state, target, GL_COLOR_BUFFER_BIT);
  return {};
}

std::string TargetPixels::WriteDepths(
  vtkOpenGLState* state, const RenderTarget& target, const std::vector<std::uint32_t>& words)
{
  const GLenum format = target.Depth.InternalFormat;
  std::string problem = this->Depths.Allocate(format, target.Width, target.Height, 0);
  if (!problem.empty())
  {
    return problem;
  }
  const DepthTransfer writing = WritingOf(format);
  std::vector<std::uint32_t> pairs;
  if (writing.Words == 2)
  {
    for (const std::uint32_t word : words)
    {
      pairs.insert(pairs.end(), { word, 0u });
    }
  }
  Upload(state, target, this->Depths, writing.Format, writing.Type,
    pairs.empty() ? words.data() : pairs.data());
  BindForDrawing(state, this->DepthTarget.Handle());
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, target.ReadyDepthAttachment(), GL_TEXTURE_2D, this->Depths.Handle(), 0);
  SetDrawBuffers(state, { GL_NONE });
  BindForReading(state, this->DepthTarget.Handle());
  BlitInto(state, target, GL_DEPTH_BUFFER_BIT);
  return {};
}

void TargetPixels::Release()
{
  this->Colors.Release();
  this->Depths.Release();
  this->ColorTarget.Release();
  this->DepthTarget.Release();
}

}
