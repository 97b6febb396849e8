#include "vtkLinkedListTransparencyPass.h"

#include "Core/ScreenBands.h"
#include "Shaders/SharedLayout.h"
#include "gl/BackdropCopy.h"
#include "gl/Capabilities.h"
#include "gl/GLObjects.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "transparency/FillExtensions.h"
#include "transparency/FillShader.h"
#include "transparency/ListResolver.h"
#include "transparency/NodePool.h"
#include "transparency/ShaderText.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkShaderProgram.h"

#include <vector>

vtkStandardNewMacro(vtkLinkedListTransparencyPass);

namespace
{

const char* const FetchExtension = "GL_EXT_shader_framebuffer_fetch";

}

struct vtkLinkedListTransparencyPass::Internals
{
  bool HasFramebufferFetch = false;
  vitrine::ListLayout Layout;
  vitrine::NodePool Pool;
  vitrine::Image2D Heads;
  vitrine::Framebuffer FillFramebuffer;  // opaque depth, and the heads where they are an attachment
  vitrine::Framebuffer ClearFramebuffer; // the heads
  vitrine::BackdropCopy Backdrop;
  vitrine::ListResolver Resolver;

  void PrepareTargets(vtkOpenGLState* state, const vitrine::RenderTarget& target);
  void ClearHeads(vtkOpenGLState* state, const vitrine::PixelRegion& region);
  std::vector<std::uint32_t> ReadCounts(vtkOpenGLState* state, const vitrine::RenderTarget& target);
};

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::Internals::PrepareTargets(
  vtkOpenGLState* state, const vitrine::RenderTarget& target)
{
  const bool fetch = this->Layout.FramebufferFetch;
  const bool fresh = fetch ? this->Heads.Allocate(GL_RG32UI, target.Width, target.Height, 0)
                           : this->Heads.Allocate(GL_R32UI, 2 * target.Width, target.Height, 0);
  if (fresh)
  {
    state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->ClearFramebuffer.Handle());
    glFramebufferTexture2D(
      GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Heads.Handle(), 0);
  }
  // The target's images may be new ones under old names, so they are attached anew each frame.
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->FillFramebuffer.Handle());
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, fetch ? this->Heads.Handle() : 0, 0);
  target.AttachDepth();
  // Location 0 is the colour that the mappers' shaders write themselves.
  unsigned int buffers[2] = { GL_NONE,
    static_cast<unsigned int>(fetch ? GL_COLOR_ATTACHMENT0 : GL_NONE) };
  state->vtkglDrawBuffers(2, buffers);
}

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::Internals::ClearHeads(
  vtkOpenGLState* state, const vitrine::PixelRegion& r)
{
  const bool fetch = this->Layout.FramebufferFetch;
  const int scale = fetch ? 1 : 2;
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->ClearFramebuffer.Handle());
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(scale * r.X, r.Y, scale * r.Width, r.Height);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const GLuint empty[4] = { fetch ? VITRINE_END : 0u, 0u, 0u, 0u };
  glClearBufferuiv(GL_COLOR, 0, empty);
}

//------------------------------------------------------------------------------
// Fragments of each pixel of the target, row by row.
std::vector<std::uint32_t> vtkLinkedListTransparencyPass::Internals::ReadCounts(
  vtkOpenGLState* state, const vitrine::RenderTarget& target)
{
  const int texels = this->Layout.FramebufferFetch ? 1 : 2;
  const std::size_t pixels = static_cast<std::size_t>(target.Width) * target.Height;
  std::vector<std::uint32_t> heads(2 * pixels);
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->ClearFramebuffer.Handle());
  glReadPixels(0, 0, texels * target.Width, target.Height,
    texels == 1 ? GL_RG_INTEGER : GL_RED_INTEGER, GL_UNSIGNED_INT, heads.data());
  std::vector<std::uint32_t> counts(pixels);
  for (std::size_t i = 0; i < pixels; ++i)
  {
    counts[i] = heads[2 * i + 1];
  }
  return counts;
}

//------------------------------------------------------------------------------
vtkLinkedListTransparencyPass::vtkLinkedListTransparencyPass()
  : Private(new Internals)
{
}

//------------------------------------------------------------------------------
vtkLinkedListTransparencyPass::~vtkLinkedListTransparencyPass()
{
  this->ReleaseBeforeDestruction();
}

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent
     << "ColorStorage: " << (this->ColorStorage == HALF_FLOAT ? "HALF_FLOAT" : "EIGHT_BIT") << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "PoolBytes: " << this->GetPoolBytes() << "\n";
  os << indent << "NumberOfBands: " << this->NumberOfBands << "\n";
}

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::SetColorStorage(int storage)
{
  if (storage != HALF_FLOAT && storage != EIGHT_BIT)
  {
    vtkErrorMacro(<< "ColorStorage is HALF_FLOAT (0) or EIGHT_BIT (1), not " << storage << ".");
    return;
  }
  if (storage != this->ColorStorage)
  {
    this->ColorStorage = storage;
    this->ShaderStage.Modified();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkLinkedListTransparencyPass::GetPoolBytes()
{
  return this->Private->Pool.Bytes();
}

//------------------------------------------------------------------------------
std::string vtkLinkedListTransparencyPass::FindMissingFeature(vtkOpenGLRenderWindow*)
{
  this->Private->HasFramebufferFetch = vitrine::HasExtension(FetchExtension);
  return vitrine::MissingFeatures(4, 3, vitrine::FillExtensions());
}

//------------------------------------------------------------------------------
vitrine::FillShader vtkLinkedListTransparencyPass::GetFillShader()
{
  vitrine::FillShader fill;
  const std::vector<const char*>& extensions = vitrine::FillExtensions();
  fill.Extensions.assign(extensions.begin(), extensions.end());
  if (this->Private->Layout.FramebufferFetch)
  {
    fill.Extensions.emplace_back(FetchExtension);
    fill.Defines.emplace_back("VITRINE_FRAMEBUFFER_FETCH");
  }
  if (this->Private->Layout.HalfFloat)
  {
    fill.Defines.emplace_back("VITRINE_HALF_FLOAT");
  }
  fill.Declarations = vitrine::shaders::LinkedListFillDec;
  fill.Implementation = vitrine::shaders::LinkedListFillImpl;
  return fill;
}

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::SetFillParameters(vtkShaderProgram* program)
{
  if (program->IsUniformUsed("vitrinePageSize"))
  {
    program->SetUniformi("vitrinePageSize", this->Private->Pool.PageSize());
  }
}

//------------------------------------------------------------------------------
std::string vtkLinkedListTransparencyPass::RenderFragments(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  Internals& in = *this->Private;
  this->PrepareFrame(target);

  vitrine::FragmentStatistics frame = this->Fill(s, target, target.Region);
  switch (in.Pool.Fit(frame))
  {
    case vitrine::NodePool::FITS:
      this->Resolve(target, target.Region, frame);
      break;
    case vitrine::NodePool::GREW:
      this->Fill(s, target, target.Region);
      this->Resolve(target, target.Region, frame);
      break;
    case vitrine::NodePool::TOO_LARGE:
    {
      const std::string problem = this->RenderInBands(s, target);
      if (!problem.empty())
      {
        return problem;
      }
    }
  }
  if (in.Resolver.HasFailed())
  {
    return "the driver cannot compile a shader of the method";
  }
  this->FinishFrame(frame);
  return {};
}

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::PrepareFrame(const vitrine::RenderTarget& target)
{
  Internals& in = *this->Private;
  vtkOpenGLState* state = this->GetWindow()->GetState();
  in.Layout.HalfFloat = this->ColorStorage == HALF_FLOAT;
  in.Layout.FixedPoint = target.FixedPoint;
  in.Layout.Samples = target.Samples;
  // An attachment that shaders fetch from has one value a sample: lists of multisampled pixels need atomics.
  const bool fetch = in.HasFramebufferFetch && target.Samples == 0;
  if (fetch != in.Layout.FramebufferFetch)
  {
    in.Layout.FramebufferFetch = fetch;
    this->ShaderStage.Modified();
  }
  in.Pool.SetLayout(in.Layout.NodeBytes(), fetch);
  in.Pool.SetLimit(this->MemoryLimit);
  in.Layout.PageSize = in.Pool.PageSize();
  this->NumberOfBands = 1;

  in.PrepareTargets(state, target);
  in.Backdrop.Copy(state, target);
}

//------------------------------------------------------------------------------
vitrine::FragmentStatistics vtkLinkedListTransparencyPass::Fill(
  const vtkRenderState* s, const vitrine::RenderTarget& target, const vitrine::PixelRegion& region)
{
  Internals& in = *this->Private;
  vtkOpenGLState* state = this->GetWindow()->GetState();
  in.ClearHeads(state, region);
  in.Pool.ResetCounters();
  target.BindForFill(state, in.FillFramebuffer.Handle(), region);
  {
    const vitrine::ScopedStorageBuffer counters(VITRINE_BINDING_COUNTERS, in.Pool.CounterBuffer());
    const vitrine::ScopedStorageBuffer nodes(VITRINE_BINDING_NODES, in.Pool.NodeBuffer());
    const vitrine::ScopedStorageBuffer links(VITRINE_BINDING_LINKS, in.Pool.LinkBuffer());
    const vitrine::ScopedImage heads(
      VITRINE_IMAGE_HEADS, in.Layout.FramebufferFetch ? 0 : in.Heads.Handle());
    this->DrawTranslucentGeometry(s, region);
  }
  in.Resolver.Classify(this->GetWindow(), in.Layout, in.Pool, in.Heads, target, region);
  return in.Pool.ReadCounters();
}

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::Resolve(const vitrine::RenderTarget& target,
  const vitrine::PixelRegion& region, const vitrine::FragmentStatistics& statistics)
{
  Internals& in = *this->Private;
  in.Resolver.Resolve(this->GetWindow(), in.Layout, in.Pool, in.Heads, in.Backdrop.Image(), target,
    region, statistics.TileBins);
}

//------------------------------------------------------------------------------
std::string vtkLinkedListTransparencyPass::RenderInBands(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  Internals& in = *this->Private;
  const auto pageSize = static_cast<std::uint32_t>(in.Pool.PageSize());
  std::vector<std::uint32_t> pages = in.ReadCounts(this->GetWindow()->GetState(), target);
  for (std::uint32_t& n : pages)
  {
    n = (n + pageSize - 1) / pageSize;
  }
  const vitrine::BandPlan plan = vitrine::PlanBands(pages, target.Width, target.Height,
    static_cast<std::uint64_t>(in.Pool.CapacityPages()), target.Region);
  if (!plan.Fits)
  {
    return "one pixel alone needs " + std::to_string(plan.LargestPixel * in.Pool.PageBytes()) +
      " bytes of the node pool, which may have " + std::to_string(in.Pool.Bytes());
  }
  for (const vitrine::PixelRegion& band : plan.Bands)
  {
    const vitrine::FragmentStatistics part = this->Fill(s, target, band);
    this->Resolve(target, band, part);
  }
  this->NumberOfBands = static_cast<int>(plan.Bands.size());
  return {};
}

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::FinishFrame(const vitrine::FragmentStatistics& frame)
{
  Internals& in = *this->Private;
  this->FragmentCount = frame.Fragments;
  this->LayersMax = frame.LayersMax;
  this->LayersMean = frame.CoveredPixels > 0
    ? static_cast<double>(frame.Fragments) / static_cast<double>(frame.CoveredPixels)
    : 0.0;
  in.Pool.EndFrame(frame);
  this->Bytes = in.Pool.Bytes() + in.Heads.Bytes() + in.Backdrop.Image().Bytes() +
    in.Resolver.Bytes() + this->GetSharedBytes();
}

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::ReleaseMethodResources()
{
  Internals& in = *this->Private;
  in.Pool.Release();
  in.Heads.Release();
  in.FillFramebuffer.Release();
  in.ClearFramebuffer.Release();
  in.Backdrop.Release();
  in.Resolver.Release();
}

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::ForgetMethodResources()
{
  this->Private.reset(new Internals);
}
