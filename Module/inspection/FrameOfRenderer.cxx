#include "inspection/FrameOfRenderer.h"

#include "scene/PassTraits.h"
#include "transparency/abuffer/ListReader.h"
#include "vtkABufferTransparencyPass.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <string>

namespace vitrine
{

std::string FrameOfRenderer::Find(vtkRenderer* renderer)
{
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    return "the renderer is in no window of OpenGL: add it to a render window";
  }
  if (window->GetNeverRendered() || !window->GetRenderFramebuffer() ||
    !window->GetRenderFramebuffer()->GetColorAttachmentAsTextureObject(0))
  {
    return "the window has drawn no frame: call Render() first";
  }
  window->MakeCurrent();
  if (!window->IsCurrent())
  {
    return "the window's context cannot be made current";
  }
  vtkTextureObject* const color =
    window->GetRenderFramebuffer()->GetColorAttachmentAsTextureObject(0);
  this->Renderer = renderer;
  this->Width = static_cast<int>(color->GetWidth());
  this->Height = static_cast<int>(color->GetHeight());
  const int samples = static_cast<int>(color->GetSamples());
  this->Samples = samples > 1 ? samples : 0;
  this->FixedPoint = color->GetVTKDataType() != VTK_FLOAT;
  renderer->GetTiledSizeAndOrigin(
    &this->Viewport.Width, &this->Viewport.Height, &this->Viewport.X, &this->Viewport.Y);
  return {};
}

std::string FrameOfRenderer::FindPixelOutside(int left, int bottom, int right, int top) const
{
  const PixelRegion& v = this->Viewport;
  const int last = v.X + v.Width - 1;
  const int highest = v.Y + v.Height - 1;
  const auto areaOf = [](int x0, int y0, int x1, int y1)
  {
    return std::to_string(x0) + "," + std::to_string(y0) + " to " + std::to_string(x1) + "," +
      std::to_string(y1);
  };
  return left >= v.X && bottom >= v.Y && right <= last && top <= highest
    ? std::string()
    : "pixels " + areaOf(left, bottom, right, top) + " are not within the renderer's viewport, " +
      areaOf(v.X, v.Y, last, highest);
}

LayerCapture::Request FrameOfRenderer::RequestOf(const PixelRegion& pixels, bool translucent) const
{
  LayerCapture::Request request;
  request.Renderer = this->Renderer;
  request.Pixels = pixels;
  request.Width = this->Width;
  request.Height = this->Height;
  request.Samples = this->Samples;
  request.FixedPoint = this->FixedPoint;
  request.Translucent = translucent;
  return request;
}

bool FrameOfRenderer::ReadLists(
  const PixelRegion& pixels, std::vector<LayerFragment>& fragments) const
{
  const FrameSize size{ this->Width, this->Height, this->Samples };
  // The first pass that has lists of this frame drew it. AllPasses() ends with it.
  return this->Renderer->GetPass() &&
    !AllPasses(this->Renderer->GetPass(),
      [&](vtkRenderPass* pass)
      {
        auto* const lists = vtkABufferTransparencyPass::SafeDownCast(pass);
        return !lists || !lists->ReadLists(this->Renderer, size, pixels, fragments);
      });
}

}
