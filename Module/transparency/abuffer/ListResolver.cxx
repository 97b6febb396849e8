#include "transparency/abuffer/ListResolver.h"

#include "Core/lists/PixelBlocks.h"
#include "Shaders/SharedLayout.h"
#include "gl/Capabilities.h"
#include "gl/FullScreenDraw.h"
#include "gl/MemoryBarriers.h"
#include "gl/ScopedState.h"
#include "shader/ShaderText.h"
#include "transparency/abuffer/FragmentStore.h"
#include "transparency/common/ResolveSources.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>
#include <limits>

namespace vitrine
{
namespace
{

// Bin b holds the tiles whose longest list exceeds the limit of bin b - 1, but not this limit. The last bin is
// unbounded.
constexpr std::array<int, 7> BinLimits = { 8, 16, 32, VITRINE_LONGEST_NETWORK,
  VITRINE_RUN_SIZE* VITRINE_RUN_GROUP, VITRINE_RUN_SIZE* VITRINE_MAX_RUNS,
  std::numeric_limits<int>::max() };
constexpr int BinCount = static_cast<int>(BinLimits.size());
constexpr int LongRunsBin = BinCount - 1;

// As measured, lists of 30,000 fragments were complete and lists of 31,000 were not. With a coincidence tolerance, the
// figures are 20,000 and 24,576.
constexpr std::int64_t LongestOfSoftware = 20000;

bool IsMergeOfRuns(int bin)
{
  return BinLimits[bin] > VITRINE_LONGEST_NETWORK;
}

// The most nodes of a bin's lists that are sorted in registers. Longer lists have longer runs.
int NodesAtOnce(int bin)
{
  return std::min(BinLimits[bin], VITRINE_RUN_SIZE * VITRINE_MAX_RUNS);
}

std::string ResolveName(int bin)
{
  return "resolve " + std::to_string(NodesAtOnce(bin));
}

std::vector<std::string> RunDefines(const ListLayout& layout)
{
  std::vector<std::string> defines = layout.Defines();
  defines.push_back("VITRINE_RUN_PAGES " + std::to_string(VITRINE_RUN_SIZE / layout.PageSize));
  return defines;
}

std::string BinLimitList()
{
  std::string list;
  for (const int limit : BinLimits)
  {
    list += (list.empty() ? "" : ", ") + std::to_string(limit) + "u";
  }
  return list;
}

BlockRange TilesOf(const PixelRegion& region)
{
  return BlocksOf(region, VITRINE_TILE_SIZE);
}

// Textures that both the sort pass and the resolve pass read: heads, nodes and links.
class ScopedListTextures
{
public:
  ScopedListTextures(vtkOpenGLState* state, FragmentStore& store)
    : Heads(state, GL_TEXTURE_2D, store.Heads().Image().Handle())
    , Nodes(state, GL_TEXTURE_BUFFER, store.NodeTexture())
    , Links(state, GL_TEXTURE_BUFFER, store.LinkTexture())
  {
  }
  void SetUniforms(vtkShaderProgram* program) const
  {
    program->SetUniformi("heads", this->Heads.Unit());
    program->SetUniformi("nodes", this->Nodes.Unit());
    if (program->IsUniformUsed("links"))
    {
      program->SetUniformi("links", this->Links.Unit());
    }
  }

private:
  ScopedTextureUnit Heads;
  ScopedTextureUnit Nodes;
  ScopedTextureUnit Links;
};

}

//------------------------------------------------------------------------------
std::string ListResolver::FindProblemOfLength(std::int64_t longest)
{
  return longest > LongestOfSoftware && IsSoftwareRasteriser() ? "a pixel has " +
      std::to_string(longest) + " fragments, and this driver ends shaders that resolve more than " +
      std::to_string(LongestOfSoftware)
                                                               : "";
}

std::string ListResolver::PrepareTiles(vtkOpenGLState* state, const RenderTarget& target)
{
  const BlockRange tiles = TilesOf({ 0, 0, target.Width, target.Height });
  std::string problem = this->TileMax.Allocate(GL_R32UI, tiles.Count[0], tiles.Count[1], 0);
  if (problem.empty())
  {
    state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->TileFramebuffer.Handle());
    glFramebufferTexture2D(
      GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->TileMax.Handle(), 0);
  }
  return problem;
}

//------------------------------------------------------------------------------
void ListResolver::Classify(vtkOpenGLRenderWindow* window, const ListLayout& layout,
  FragmentStore& store, const RenderTarget& target, const PixelRegion& region)
{
  vtkOpenGLState* state = window->GetState();
  const BlockRange all = TilesOf({ 0, 0, target.Width, target.Height });
  const BlockRange tiles = TilesOf(region);
  BindForFullScreenDraw(state, this->TileFramebuffer.Handle(), all.Count[0], all.Count[1],
    { tiles.First[0], tiles.First[1], tiles.Count[0], tiles.Count[1] });

  BarrierBeforeReadingLists();
  const ScopedVertexArray vertexArray(this->VertexArray.Handle());
  const ScopedStorageBuffer counters(VITRINE_BINDING_COUNTERS, store.CounterBuffer());
  const ScopedImage longestLists(VITRINE_IMAGE_BLOCKS, store.BlockImage());
  const ScopedListTextures textures(state, store);
  vtkShaderProgram* program = this->ReadyClassify(window, layout);
  if (!program)
  {
    return;
  }
  textures.SetUniforms(program);
  const int regionFirst[2] = { region.X, region.Y };
  const int regionEnd[2] = { region.X + region.Width, region.Y + region.Height };
  program->SetUniform2i("regionFirst", regionFirst);
  program->SetUniform2i("regionEnd", regionEnd);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

//------------------------------------------------------------------------------
bool ListResolver::Resolve(vtkOpenGLRenderWindow* window, const ListLayout& layout,
  FragmentStore& store, const Image2D& backdropImage, const RenderTarget& target,
  const PixelRegion& region, std::uint32_t tileBins)
{
  const std::vector<BinDraw> draws = this->PlanDraws(layout, tileBins);
  for (const BinDraw& draw : draws)
  {
    if (!this->ReadyPrograms(window, layout, draw.Bin))
    {
      return false;
    }
  }

  vtkOpenGLState* state = window->GetState();
  BindForFullScreenDraw(state, target.Framebuffer, target.Width, target.Height);

  const BlockRange tiles = TilesOf(region);
  const int targetSize[2] = { target.Width, target.Height };
  const int regionFirst[2] = { region.X, region.Y };
  const int regionEnd[2] = { region.X + region.Width, region.Y + region.Height };
  const ScopedVertexArray vertexArray(this->VertexArray.Handle());
  const ScopedListTextures textures(state, store);
  const ScopedTextureUnit tileMax(state, GL_TEXTURE_2D, this->TileMax.Handle());
  const ScopedTextureUnit backdrop(state, backdropImage.Target(), backdropImage.Handle());
  const auto drawTiles = [&](vtkShaderProgram* program, const BinDraw& draw)
  {
    textures.SetUniforms(program);
    program->SetUniformi("tileMax", tileMax.Unit());
    if (program->IsUniformUsed("backdrop"))
    {
      program->SetUniformi("backdrop", backdrop.Unit());
    }
    const int lengths[2] = { draw.Longer, BinLimits[draw.Bin] };
    program->SetUniform2i("binRange", lengths);
    program->SetUniform2i("tileFirst", tiles.First);
    program->SetUniform2i("tileCount", tiles.Count);
    program->SetUniform2i("targetSize", targetSize);
    program->SetUniform2i("regionFirst", regionFirst);
    program->SetUniform2i("regionEnd", regionEnd);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, tiles.Count[0] * tiles.Count[1]);
  };
  for (const BinDraw& draw : draws)
  {
    if (IsMergeOfRuns(draw.Bin))
    {
      this->BindForSort(state, target);
      const ScopedStorageBuffer nodes(VITRINE_BINDING_NODES, store.NodeBuffer());
      drawTiles(this->ReadySortRuns(window, layout, draw.Bin), draw);
      BarrierBeforeReadingLists();
    }
    state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.Framebuffer);
    drawTiles(this->ReadyResolve(window, layout, draw.Bin), draw);
  }
  return true;
}

//------------------------------------------------------------------------------
// Binds a framebuffer without images. With one sample per pixel the shader runs once per pixel. In a multisampled
// framebuffer it would run twice along the diagonals of tiles, where both triangles cover samples of a pixel.
void ListResolver::BindForSort(vtkOpenGLState* state, const RenderTarget& target)
{
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->SortFramebuffer.Handle());
  glFramebufferParameteri(GL_DRAW_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_WIDTH, target.Width);
  glFramebufferParameteri(GL_DRAW_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_HEIGHT, target.Height);
}

//------------------------------------------------------------------------------
bool ListResolver::ReadyPrograms(vtkOpenGLRenderWindow* window, const ListLayout& layout, int bin)
{
  return this->ReadyResolve(window, layout, bin) &&
    (!IsMergeOfRuns(bin) || this->ReadySortRuns(window, layout, bin));
}

//------------------------------------------------------------------------------
// A driver takes seconds to compile a large network. So a frame compiles at most one program: that of the longest lists
// which lack one. Other bins without a program are drawn with the next larger network, which sorts to the same bits.
std::vector<ListResolver::BinDraw> ListResolver::PlanDraws(
  const ListLayout& layout, std::uint32_t tileBins) const
{
  std::vector<BinDraw> draws;
  bool mayCompile = true;
  for (int bin = BinCount - 1; bin >= 0; --bin)
  {
    if ((tileBins >> bin & 1u) == 0)
    {
      continue;
    }
    const int longer = bin > 0 ? BinLimits[bin - 1] : 0;
    const bool compiled = this->Programs.Has(ResolveName(bin), RunDefines(layout));
    if (compiled || mayCompile)
    {
      mayCompile = mayCompile && compiled;
      draws.push_back({ bin, longer });
    }
    else
    {
      draws.back().Longer = longer;
    }
  }
  return draws;
}

//------------------------------------------------------------------------------
vtkShaderProgram* ListResolver::ReadyClassify(
  vtkOpenGLRenderWindow* window, const ListLayout& layout)
{
  std::vector<std::string> defines = layout.Defines();
  defines.push_back("VITRINE_BIN_COUNT " + std::to_string(BinCount));
  defines.push_back("VITRINE_BIN_LIMITS " + BinLimitList());
  return this->Programs.Ready(
    window, "classify", defines, shaders::FullScreenVertex, [] { return shaders::TileClassify; });
}

vtkShaderProgram* ListResolver::ReadySortRuns(
  vtkOpenGLRenderWindow* window, const ListLayout& layout, int bin)
{
  const bool longRuns = bin == LongRunsBin;
  return this->Programs.Ready(window, longRuns ? "sort long runs" : "sort runs", RunDefines(layout),
    shaders::TileQuadVertex,
    [&]
    {
      return longRuns ? SortLongRunsSource(VITRINE_RUN_SIZE, layout.PageSize)
                      : SortRunsSource(VITRINE_RUN_SIZE, layout.PageSize);
    });
}

vtkShaderProgram* ListResolver::ReadyResolve(
  vtkOpenGLRenderWindow* window, const ListLayout& layout, int bin)
{
  const int size = NodesAtOnce(bin);
  return this->Programs.Ready(window, ResolveName(bin), RunDefines(layout), shaders::TileQuadVertex,
    [&]
    {
      return IsMergeOfRuns(bin) ? MergeRunsSource(size / VITRINE_RUN_SIZE)
                                : NetworkSource(size, layout.PageSize);
    });
}

void ListResolver::Release()
{
  this->TileMax.Release();
  this->TileFramebuffer.Release();
  this->SortFramebuffer.Release();
  this->VertexArray.Release();
  this->Programs.Release();
}

}
