#include "transparency/abuffer/ListReader.h"

#include "Shaders/SharedLayout.h"
#include "gl/Capabilities.h"
#include "gl/MemoryBarriers.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "shader/ShaderText.h"
#include "transparency/abuffer/FragmentStore.h"
#include "transparency/abuffer/ListLayout.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

namespace vitrine
{
namespace
{

constexpr std::int64_t FragmentBytes = sizeof(LayerFragment);
constexpr std::int64_t FirstCapacity = 4096;
constexpr int ReaderGroupSize = 64; // as in LayerLists.glsl

}

ListReader::ListReader()
  : Program(shaders::LayerLists)
{
}

void ListReader::Note(vtkRenderer* renderer, const RenderTarget& target, const FragmentStore& store)
{
  this->Drawn = renderer;
  this->Size = { target.Width, target.Height, target.Samples };
  this->Region = target.Region;
  this->Matrices = ViewMatricesOf(renderer);
  this->NodesNumber = store.Nodes().Number();
}

bool ListReader::Read(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, const FrameSize& size,
  const ListLayout& layout, FragmentStore& store, const PixelRegion& pixels,
  std::vector<LayerFragment>& fragments)
{
  const PixelRegion& r = this->Region;
  const bool isInside = pixels.X >= r.X && pixels.Y >= r.Y &&
    pixels.X + pixels.Width <= r.X + r.Width && pixels.Y + pixels.Height <= r.Y + r.Height;
  if (!renderer || renderer != this->Drawn || !(size == this->Size) || !isInside ||
    this->NodesNumber != store.Nodes().Number() || !window->IsCurrent() ||
    this->Matrices != ViewMatricesOf(renderer))
  {
    return false;
  }
  if ((this->Counter.Handle() == 0 && !this->Counter.Allocate(sizeof(VitrineCaptureCounters))) ||
    (this->Fragments.Handle() == 0 && !this->Fragments.Allocate(FirstCapacity * FragmentBytes)))
  {
    return false;
  }
  for (int attempt = 0; attempt < 2; ++attempt)
  {
    if (!this->Run(window, layout, store, pixels))
    {
      return false;
    }
    VitrineCaptureCounters counters = {};
    BarrierBeforeReadingBuffers();
    this->Counter.Read(0, sizeof(counters), &counters);
    const std::int64_t bytes = counters.Fragments * FragmentBytes;
    if (bytes <= this->Fragments.Bytes())
    {
      const std::size_t before = fragments.size();
      fragments.resize(before + counters.Fragments);
      if (bytes > 0)
      {
        this->Fragments.Read(0, bytes, fragments.data() + before);
      }
      return true;
    }
    if (bytes > LargestStorageBlock() || !this->Fragments.Allocate(bytes))
    {
      this->Fragments.Release();
      return false;
    }
  }
  return false;
}

bool ListReader::Run(vtkOpenGLRenderWindow* window, const ListLayout& layout, FragmentStore& store,
  const PixelRegion& pixels)
{
  vtkOpenGLState* const state = window->GetState();
  const VitrineCaptureCounters zero = {};
  this->Counter.Write(0, sizeof(zero), &zero);
  const ScopedShaderProgram program(window);
  const ScopedStorageBuffer counter(VITRINE_BINDING_COUNTERS, this->Counter.Handle());
  const ScopedStorageBuffer captured(VITRINE_BINDING_CAPTURE, this->Fragments.Handle());
  const vtkOpenGLState::ScopedglActiveTexture activeTexture(state);
  const ScopedTextureUnit heads(state, GL_TEXTURE_2D, store.Heads().Image().Handle());
  const ScopedTextureUnit nodes(state, GL_TEXTURE_BUFFER, store.Nodes().Texture());
  const ScopedTextureUnit thirdWords(state, GL_TEXTURE_BUFFER, store.Nodes().ThirdWordTexture());
  const ScopedTextureUnit parts(state, GL_TEXTURE_BUFFER, store.Nodes().PartTexture());
  const ScopedTextureUnit links(state, GL_TEXTURE_BUFFER, store.LinkTexture());
  if (!this->Program.Use(window, layout.Defines()))
  {
    return false;
  }
  this->Program.Set("heads", heads.Unit());
  this->Program.Set("nodes", nodes.Unit());
  this->Program.Set("thirdWords", thirdWords.Unit());
  this->Program.Set("parts", parts.Unit());
  this->Program.Set("links", links.Unit());
  const int first[2] = { pixels.X, pixels.Y };
  const int size[2] = { pixels.Width, pixels.Height };
  this->Program.Set("areaFirst", first);
  this->Program.Set("areaSize", size);
  BarrierBetweenScans();
  ComputeProgram::DispatchFor(std::int64_t(pixels.Width) * pixels.Height, ReaderGroupSize);
  glUseProgram(0);
  return true;
}

void ListReader::Release()
{
  this->Drawn = nullptr;
  this->Program.Release();
  this->Counter.Release();
  this->Fragments.Release();
}

}
