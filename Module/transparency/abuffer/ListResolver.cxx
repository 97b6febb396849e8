#include "transparency/abuffer/ListResolver.h"

#include "Core/lists/PixelBlocks.h"
#include "Shaders/SharedLayout.h"
#include "gl/Capabilities.h"
#include "gl/FullScreenDraw.h"
#include "gl/MemoryBarriers.h"
#include "gl/ScopedState.h"
#include "gl/StateRecord.h"
#include "shader/ShaderText.h"
#include "transparency/abuffer/ErrorBounds.h"
#include "transparency/abuffer/FragmentStore.h"
#include "transparency/abuffer/HiddenDepths.h"
#include "transparency/common/ResolveSources.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <optional>

namespace vitrine
{
namespace
{

// As measured, lists of 30,000 fragments were complete and lists of 31,000 were not. With a coincidence tolerance, the
// figures are 20,000 and 24,576.
constexpr std::int64_t LongestOfSoftware = 20000;

bool MergesRuns(const SortBin& bin)
{
  return bin.Sort == ListSort::Runs || bin.Sort == ListSort::LongRuns;
}

std::string BinLimitList(const SortPlan& plan)
{
  std::string list;
  for (const SortBin& bin : plan.Bins)
  {
    list += (list.empty() ? "" : ", ") + std::to_string(bin.Limit) + "u";
  }
  return list;
}

SortPlan PlanOf(const ListLayout& layout)
{
  return PlanSort({ layout.FragmentWords(), layout.NodeWords(), layout.Packed, !layout.IsSoftware,
    layout.Coincidence });
}

std::vector<std::string> RunDefines(
  const ListLayout& layout, const SortPlan& plan, const SortBin& bin)
{
  std::vector<std::string> defines = layout.Defines();
  defines.push_back("VITRINE_RUN_PAGES " + std::to_string(bin.RunSize / layout.PageSize));
  defines.push_back("VITRINE_MAX_RUNS " + std::to_string(plan.MaximumRuns));
  return defines;
}

// Programs that sort nodes in place move the words of parts, too.
std::vector<std::string> SortDefines(
  const ListLayout& layout, const SortPlan& plan, const SortBin& bin)
{
  std::vector<std::string> defines = RunDefines(layout, plan, bin);
  if (layout.PartNumbers)
  {
    defines.emplace_back("VITRINE_SORTS_PARTS");
  }
  return defines;
}

std::string ResolveName(const SortBin& bin)
{
  const char* const kind = MergesRuns(bin) ? "merge "
    : bin.Sort == ListSort::SlotNetwork    ? "slots "
                                           : "network ";
  return kind + std::to_string(bin.Size);
}

std::vector<std::string> ResolveDefines(
  const ListLayout& layout, const SortPlan& plan, const SortBin& bin)
{
  if (MergesRuns(bin))
  {
    return RunDefines(layout, plan, bin);
  }
  std::vector<std::string> defines = layout.Defines();
  defines.push_back("VITRINE_BIN " + std::to_string(bin.Size));
  if (plan.BlendsInTurn)
  {
    defines.emplace_back("VITRINE_BLENDS_IN_TURN");
  }
  return defines;
}

BlockRange TilesOf(const PixelRegion& region)
{
  return BlocksOf(region, VITRINE_TILE_SIZE);
}

// What shaders read and write to find out more than the picture.
class ScopedFindings
{
public:
  ScopedFindings(vtkOpenGLState* state, const ListLayout& layout, const ResolveFindings& findings)
    : Findings(findings)
  {
    if (layout.ErrorBounds)
    {
      this->Bounds.emplace(*findings.Bounds);
    }
    if (layout.HiddenDepths)
    {
      this->Hidden.emplace(state, *findings.Hidden);
    }
  }
  void SetUniforms(vtkShaderProgram* program) const
  {
    if (this->Bounds)
    {
      this->Findings.Bounds->SetUniforms(program);
    }
    if (this->Hidden)
    {
      this->Hidden->SetUniforms(program);
    }
  }

private:
  const ResolveFindings& Findings;
  std::optional<ScopedErrorBounds> Bounds;
  std::optional<ScopedHiddenDepths> Hidden;
};

// Textures that both the sort pass and the resolve pass read: heads, nodes and links.
class ScopedListTextures
{
public:
  ScopedListTextures(vtkOpenGLState* state, FragmentStore& store)
    : Heads(state, GL_TEXTURE_2D, store.Heads().Image().Handle())
    , Nodes(state, GL_TEXTURE_BUFFER, store.Nodes().Texture())
    , ThirdWords(state, GL_TEXTURE_BUFFER, store.Nodes().ThirdWordTexture())
    , Links(state, GL_TEXTURE_BUFFER, store.LinkTexture())
  {
  }
  void SetUniforms(vtkShaderProgram* program) const
  {
    program->SetUniformi("heads", this->Heads.Unit());
    if (program->IsUniformUsed("nodes"))
    {
      program->SetUniformi("nodes", this->Nodes.Unit());
    }
    if (program->IsUniformUsed("thirdWords"))
    {
      program->SetUniformi("thirdWords", this->ThirdWords.Unit());
    }
    if (program->IsUniformUsed("links"))
    {
      program->SetUniformi("links", this->Links.Unit());
    }
  }

private:
  ScopedTextureUnit Heads;
  ScopedTextureUnit Nodes;
  ScopedTextureUnit ThirdWords;
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

std::string ListResolver::Prepare(
  vtkOpenGLState* state, const RenderTarget& target, const ListLayout& layout)
{
  const BlockRange tiles = TilesOf({ 0, 0, target.Width, target.Height });
  std::string problem = this->TileMax.Allocate(GL_R32UI, tiles.Count[0], tiles.Count[1], 0);
  if (problem.empty())
  {
    this->TileFramebuffer.Attach(state, this->TileMax);
  }
  if (!layout.ResolvesAllSamples())
  {
    this->Samples.Release();
  }
  else if (problem.empty())
  {
    problem = this->Samples.Prepare(state, target);
  }
  return problem;
}

//------------------------------------------------------------------------------
void ListResolver::Classify(vtkOpenGLRenderWindow* window, const ListLayout& layout,
  FragmentStore& store, const ResolveFindings& findings, const RenderTarget& target,
  const PixelRegion& region)
{
  vtkOpenGLState* state = window->GetState();
  const BlockRange all = TilesOf({ 0, 0, target.Width, target.Height });
  const BlockRange tiles = TilesOf(region);
  BindForFullScreenDraw(state, this->TileFramebuffer.Handle(), all.Count[0], all.Count[1],
    { tiles.First[0], tiles.First[1], tiles.Count[0], tiles.Count[1] });

  BarrierBeforeReadingLists();
  const BoundVertexArray vertexArray(this->VertexArray.Handle());
  const ScopedStorageBuffer counters(VITRINE_BINDING_COUNTERS, store.CounterBuffer());
  const ScopedImage longestLists(VITRINE_IMAGE_BLOCKS, store.BlockImage());
  const ScopedListTextures textures(state, store);
  const ScopedFindings scopedFindings(state, layout, findings);
  vtkShaderProgram* program = this->ReadyClassify(window, layout);
  if (!program)
  {
    return;
  }
  textures.SetUniforms(program);
  scopedFindings.SetUniforms(program);
  const int regionFirst[2] = { region.X, region.Y };
  const int regionEnd[2] = { region.X + region.Width, region.Y + region.Height };
  program->SetUniform2i("regionFirst", regionFirst);
  program->SetUniform2i("regionEnd", regionEnd);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

//------------------------------------------------------------------------------
bool ListResolver::Resolve(vtkOpenGLRenderWindow* window, const ListLayout& layout,
  FragmentStore& store, const ResolveFindings& findings, const Image2D& backdropImage,
  const RenderTarget& target, const PixelRegion& region, std::uint32_t tileBins)
{
  const SortPlan plan = PlanOf(layout);
  const std::vector<BinDraw> draws = this->PlanDraws(layout, plan, tileBins);
  for (const BinDraw& draw : draws)
  {
    if (!this->ReadyPrograms(window, layout, plan, draw.Bin))
    {
      return false;
    }
  }
  const bool allSamples = layout.ResolvesAllSamples();
  if (allSamples && !this->ReadySamples(window, layout))
  {
    return false;
  }

  vtkOpenGLState* state = window->GetState();
  BindForFullScreenDraw(state, target.Framebuffer, target.Width, target.Height);

  const BlockRange tiles = TilesOf(region);
  const int targetSize[2] = { target.Width, target.Height };
  const int regionFirst[2] = { region.X, region.Y };
  const int regionEnd[2] = { region.X + region.Width, region.Y + region.Height };
  const BoundVertexArray vertexArray(this->VertexArray.Handle());
  const ScopedListTextures textures(state, store);
  const ScopedTextureUnit tileMax(state, GL_TEXTURE_2D, this->TileMax.Handle());
  const ScopedTextureUnit backdrop(state, backdropImage.Target(), backdropImage.Handle());
  const ScopedFindings scopedFindings(state, layout, findings);
  const auto drawTiles = [&](vtkShaderProgram* program, const BinDraw& draw)
  {
    textures.SetUniforms(program);
    scopedFindings.SetUniforms(program);
    program->SetUniformi("tileMax", tileMax.Unit());
    if (program->IsUniformUsed("backdrop"))
    {
      program->SetUniformi("backdrop", backdrop.Unit());
    }
    const int lengths[2] = { draw.Longer, draw.Bin.Limit };
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
    if (MergesRuns(draw.Bin))
    {
      this->BindForSort(state, target);
      const ScopedNodeImages nodes(store.Nodes());
      drawTiles(this->ReadySortRuns(window, layout, plan, draw.Bin), draw);
      BarrierBeforeReadingLists();
    }
    BindForDrawing(state, allSamples ? this->Samples.FramebufferHandle() : target.Framebuffer);
    drawTiles(this->ReadyResolve(window, layout, plan, draw.Bin), draw);
  }
  if (allSamples)
  {
    const ScopedTextureUnit colors(state, GL_TEXTURE_2D_ARRAY, this->Samples.Colors().Handle());
    BindForDrawing(state, target.Framebuffer);
    vtkShaderProgram* program = this->ReadySamples(window, layout);
    program->SetUniformi("sampleColors", colors.Unit());
    for (const BinDraw& draw : draws)
    {
      drawTiles(program, draw);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Binds a framebuffer without images. With one sample per pixel the shader runs once per pixel. In a multisampled
// framebuffer it would run twice along the diagonals of tiles, where both triangles cover samples of a pixel.
void ListResolver::BindForSort(vtkOpenGLState* state, const RenderTarget& target)
{
  BindForDrawing(state, this->SortFramebuffer.Handle());
  glFramebufferParameteri(GL_DRAW_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_WIDTH, target.Width);
  glFramebufferParameteri(GL_DRAW_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_HEIGHT, target.Height);
}

//------------------------------------------------------------------------------
bool ListResolver::ReadyPrograms(
  vtkOpenGLRenderWindow* window, const ListLayout& layout, const SortPlan& plan, const SortBin& bin)
{
  return this->ReadyResolve(window, layout, plan, bin) &&
    (!MergesRuns(bin) || this->ReadySortRuns(window, layout, plan, bin));
}

//------------------------------------------------------------------------------
// A driver may take a second to compile a large network. So a frame compiles at most one program: that of the longest
// lists which lack one. Other bins without a program are drawn by that of the next longer lists, which yields the same
// bits.
std::vector<ListResolver::BinDraw> ListResolver::PlanDraws(
  const ListLayout& layout, const SortPlan& plan, std::uint32_t tileBins) const
{
  std::vector<BinDraw> draws;
  bool mayCompile = true;
  for (std::size_t i = plan.Bins.size(); i-- > 0;)
  {
    if ((tileBins >> i & 1u) == 0)
    {
      continue;
    }
    const SortBin& bin = plan.Bins[i];
    const int longer = i > 0 ? plan.Bins[i - 1].Limit : 0;
    const bool compiled = this->Programs.Has(ResolveName(bin), ResolveDefines(layout, plan, bin));
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
  const SortPlan plan = PlanOf(layout);
  std::vector<std::string> defines = layout.Defines();
  defines.push_back("VITRINE_BIN_COUNT " + std::to_string(plan.Bins.size()));
  defines.push_back("VITRINE_BIN_LIMITS " + BinLimitList(plan));
  return this->Programs.Ready(
    window, "classify", defines, shaders::FullScreenVertex, [] { return shaders::TileClassify; });
}

vtkShaderProgram* ListResolver::ReadySortRuns(
  vtkOpenGLRenderWindow* window, const ListLayout& layout, const SortPlan& plan, const SortBin& bin)
{
  const bool longRuns = bin.Sort == ListSort::LongRuns;
  return this->Programs.Ready(window, longRuns ? "sort long runs" : "sort runs",
    SortDefines(layout, plan, bin), shaders::TileQuadVertex,
    [&]
    {
      return longRuns ? SortLongRunsSource(bin.RunSize, layout.PageSize)
                      : SortRunsSource(bin.RunSize, layout.PageSize);
    });
}

vtkShaderProgram* ListResolver::ReadySamples(
  vtkOpenGLRenderWindow* window, const ListLayout& layout)
{
  return this->Programs.Ready(window, "samples", layout.Defines(), shaders::TileQuadVertex,
    [] { return shaders::ListSamples; });
}

vtkShaderProgram* ListResolver::ReadyResolve(
  vtkOpenGLRenderWindow* window, const ListLayout& layout, const SortPlan& plan, const SortBin& bin)
{
  return this->Programs.Ready(window, ResolveName(bin), ResolveDefines(layout, plan, bin),
    shaders::TileQuadVertex,
    [&]
    {
      switch (bin.Sort)
      {
        case ListSort::Network:
          return NetworkSource(bin.Size, layout.PageSize);
        case ListSort::SlotNetwork:
          return SlotNetworkSource(bin.Size);
        case ListSort::Runs:
        case ListSort::LongRuns:
          break;
      }
      return MergeRunsSource(bin.Size, plan.RunGroup);
    });
}

void ListResolver::Release()
{
  this->TileMax.Release();
  this->TileFramebuffer.Release();
  this->SortFramebuffer.Release();
  this->Samples.Release();
  this->VertexArray.Release();
  this->Programs.Release();
}

}
