#include "transparency/stencil/RoutedResolver.h"

#include "gl/FullScreenDraw.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "shader/ShaderText.h"
#include "transparency/common/ResolveSources.h"
#include "transparency/stencil/RoutedTarget.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <array>
#include <vector>

namespace vitrine
{
namespace
{

// Bin b has the pixels with more fragments than the limit of bin b - 1, but not more than this limit. The last bin is
// resolved in blocks.
constexpr std::array<int, 5> BinLimits = { 4, 8, 16, 32, CountedRegions::LargestCount };
constexpr int BinCount = static_cast<int>(BinLimits.size());
constexpr int BlocksBin = BinCount - 1;
constexpr int BlockSize = 16;

// The draw of a bin, and the region that holds its pixels.
struct BinDraw
{
  int Bin;
  int Range[2]; // More fragments than the first number, at most the second.
  PixelRegion Region;
};

// A pixel with more fragments than are kept falls into the bin of the kept number.
std::vector<BinDraw> PlanDraws(
  const CountedRegions& counts, int layers, const PixelRegion& targetRegion)
{
  std::vector<BinDraw> draws;
  int longer = 0;
  for (int bin = 0; bin < BinCount && longer < layers; ++bin)
  {
    const int last = BinLimits[bin] < layers ? BinLimits[bin] : CountedRegions::LargestCount;
    PixelRegion region = counts.Around(longer + 1, last);
    if (!region.IsEmpty())
    {
      region.X += targetRegion.X;
      region.Y += targetRegion.Y;
      draws.push_back({ bin, { longer, BinLimits[bin] }, region });
    }
    longer = BinLimits[bin];
  }
  return draws;
}

}

bool RoutedResolver::Resolve(vtkOpenGLRenderWindow* window, const RoutedTarget& fragments,
  const CountedRegions& counts, int layers, const Image2D& backdrop, const RenderTarget& target)
{
  const std::vector<BinDraw> draws = PlanDraws(counts, layers, target.Region);
  for (const BinDraw& draw : draws)
  {
    if (!this->Ready(window, fragments, draw.Bin))
    {
      return false;
    }
  }
  vtkOpenGLState* state = window->GetState();
  const BoundVertexArray vertexArray(this->VertexArray.Handle());
  const ScopedTextureUnit colors(state, fragments.Colors().Target(), fragments.Colors().Handle());
  const ScopedTextureUnit depths(state, fragments.Depths().Target(), fragments.Depths().Handle());
  const ScopedTextureUnit counted(state, GL_TEXTURE_2D, fragments.Counter().Image().Handle());
  const ScopedTextureUnit behind(state, GL_TEXTURE_2D, backdrop.Handle());
  const int firstPixel[2] = { target.Region.X, target.Region.Y };
  for (const BinDraw& draw : draws)
  {
    BindForFullScreenDraw(state, target.Framebuffer, target.Width, target.Height, draw.Region);
    vtkShaderProgram* program = this->Ready(window, fragments, draw.Bin);
    program->SetUniformi("routedColors", colors.Unit());
    program->SetUniformi("routedDepths", depths.Unit());
    program->SetUniformi("pixelCounts", counted.Unit());
    program->SetUniformi("backdrop", behind.Unit());
    program->SetUniform2i("firstPixel", firstPixel);
    program->SetUniform2i("binRange", draw.Range);
    program->SetUniformi("keptLayers", layers);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  return true;
}

vtkShaderProgram* RoutedResolver::Ready(
  vtkOpenGLRenderWindow* window, const RoutedTarget& fragments, int bin)
{
  std::vector<std::string> defines = { "VITRINE_SAMPLES 0",
    "VITRINE_ROUTED_SAMPLES " + std::to_string(fragments.Route().SamplesPerPass()) };
  if (this->IsAdditive)
  {
    defines.emplace_back("VITRINE_ADDITIVE");
  }
  return this->Programs.Ready(window, "resolve " + std::to_string(BinLimits[bin]), defines,
    shaders::FullScreenVertex,
    [bin] {
      return bin == BlocksBin ? RoutedBlocksSource(BlockSize) : RoutedNetworkSource(BinLimits[bin]);
    });
}

void RoutedResolver::Release()
{
  this->VertexArray.Release();
  this->Programs.Release();
}

}
