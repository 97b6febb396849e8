#include "transparency/abuffer/PackedScan.h"

#include "Core/geometry/Rounding.h"
#include "gl/MemoryBarriers.h"
#include "gl/ProgramCache.h"
#include "gl/ScopedState.h"
#include "shader/ShaderText.h"
#include "transparency/abuffer/ListHeads.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

namespace vitrine
{
namespace
{

constexpr int GroupSize = 64; // Invocations of a group (ScanBlocks.glsl).

// Defines of the shaders that read or write heads.
std::vector<std::string> HeadDefines(const ListLayout& layout)
{
  return layout.FramebufferFetch ? std::vector<std::string>{ "VITRINE_FRAMEBUFFER_FETCH" }
                                 : std::vector<std::string>();
}

}

PackedScan::PackedScan()
  : Counts(shaders::ScanCounts)
  , Prediction(shaders::ScanPrediction)
  , Up(shaders::ScanUp)
  , Down(shaders::ScanDown)
  , Counted(shaders::PlaceCounted)
{
}

//------------------------------------------------------------------------------
std::string PackedScan::PlaceCounted(vtkOpenGLRenderWindow* window, const ListLayout& layout,
  const ListHeads& heads, const PixelRegion& region, std::uint32_t capacity)
{
  const std::string problem = this->Prepare(BlocksOf(region, VITRINE_BLOCK_SIZE));
  if (!problem.empty())
  {
    return problem;
  }
  const ScopedStorageBuffer sums(VITRINE_BINDING_SUMS, this->Sums.Handle());
  const ScopedImage image(
    VITRINE_IMAGE_HEADS, heads.Image().Handle(), layout.FramebufferFetch ? GL_RG32UI : GL_R32UI);
  BarrierBetweenScans();
  const bool done = this->RunOverBlocks(this->Counts, window, layout, region) &&
    this->ScanSums(window) && this->RunOverBlocks(this->Counted, window, layout, region, capacity);
  return done ? std::string() : ProgramFailure;
}

//------------------------------------------------------------------------------
std::string PackedScan::PlacePredicted(vtkOpenGLRenderWindow* window, const ListLayout& layout,
  ListHeads& heads, GLuint longestLists, const BlockRange& blocks, std::uint32_t capacity)
{
  const std::string problem = this->Prepare(blocks);
  if (!problem.empty())
  {
    return problem;
  }
  const ScopedStorageBuffer sums(VITRINE_BINDING_SUMS, this->Sums.Handle());
  const ScopedImage longest(VITRINE_IMAGE_BLOCKS, longestLists, GL_R32UI);
  BarrierBetweenScans();
  const bool done =
    this->RunOverBlocks(this->Prediction, window, layout, PixelsOf(blocks, VITRINE_BLOCK_SIZE)) &&
    this->ScanSums(window) && this->DrawPredicted(window, layout, heads, blocks, capacity);
  return done ? std::string() : ProgramFailure;
}

//------------------------------------------------------------------------------
// The buffer holds all levels one after the other, then the second values of the blocks.
std::string PackedScan::Prepare(const BlockRange& blocks)
{
  this->Levels = { { 0, blocks.Size() } };
  int end = blocks.Size();
  do
  {
    this->Levels.push_back({ end, DividedUp(this->Levels.back().Count, VITRINE_SCAN_FANOUT) });
    end += this->Levels.back().Count;
  } while (this->Levels.back().Count > 1);
  this->OfBlocks = end;
  const auto bytes =
    static_cast<std::int64_t>(this->OfBlocks + blocks.Size()) * std::int64_t(sizeof(uint));
  return bytes <= this->Sums.Bytes() || this->Sums.Allocate(bytes)
    ? std::string()
    : "the driver has no memory for the sums of a scan";
}

//------------------------------------------------------------------------------
bool PackedScan::RunOverBlocks(ComputeProgram& program, vtkOpenGLRenderWindow* window,
  const ListLayout& layout, const PixelRegion& region, std::uint32_t capacity)
{
  if (!program.Use(window, HeadDefines(layout)))
  {
    return false;
  }
  const BlockRange blocks = BlocksOf(region, VITRINE_BLOCK_SIZE);
  const int regionFirst[2] = { region.X, region.Y };
  const int regionEnd[2] = { region.X + region.Width, region.Y + region.Height };
  program.Set("regionFirst", regionFirst);
  program.Set("regionEnd", regionEnd);
  program.Set("blockFirst", blocks.First);
  program.Set("blockCount", blocks.Count);
  program.Set("blocks", blocks.Size());
  program.Set("ofBlocks", this->OfBlocks);
  program.Set("capacity", capacity);
  program.Set("hasReserve", this->HasReserve ? 1 : 0);
  ComputeProgram::DispatchFor(blocks.Size(), GroupSize);
  BarrierBetweenScans();
  return true;
}

//------------------------------------------------------------------------------
bool PackedScan::DrawPredicted(vtkOpenGLRenderWindow* window, const ListLayout& layout,
  ListHeads& heads, const BlockRange& blocks, std::uint32_t capacity)
{
  heads.BindForWriting(window->GetState(), PixelsOf(blocks, VITRINE_BLOCK_SIZE));
  const BoundVertexArray vertexArray(this->VertexArray.Handle());
  vtkShaderProgram* program = this->Predicted.Ready(window, "predicted", HeadDefines(layout),
    shaders::FullScreenVertex, [] { return shaders::PlacePredicted; });
  if (!program)
  {
    return false;
  }
  program->SetUniform2i("blockFirst", blocks.First);
  program->SetUniform2i("blockCount", blocks.Count);
  program->SetUniformi("ofBlocks", this->OfBlocks);
  // vtkShaderProgram has no unsigned uniforms.
  program->SetUniformi("capacity", static_cast<int>(capacity));
  glDrawArrays(GL_TRIANGLES, 0, 3);
  return true;
}

//------------------------------------------------------------------------------
// Adds up sums level by level to the total, which stays. Then replaces the sums, from top to bottom, by start
// positions.
bool PackedScan::ScanSums(vtkOpenGLRenderWindow* window)
{
  const std::size_t top = this->Levels.size() - 1;
  bool done = true;
  for (std::size_t level = 0; level < top; ++level)
  {
    done = done && this->RunOverLevel(this->Up, window, level);
  }
  for (std::size_t level = top; level-- > 0;)
  {
    done = done && this->RunOverLevel(this->Down, window, level);
  }
  return done;
}

//------------------------------------------------------------------------------
bool PackedScan::RunOverLevel(
  ComputeProgram& program, vtkOpenGLRenderWindow* window, std::size_t level)
{
  if (!program.Use(window, {}))
  {
    return false;
  }
  const Level& here = this->Levels[level];
  program.Set("level", here.Offset);
  program.Set("count", here.Count);
  program.Set("nextLevel", this->Levels[level + 1].Offset);
  program.Set("nextIsTotal", level + 2 == this->Levels.size() ? 1 : 0);
  ComputeProgram::DispatchFor(DividedUp(here.Count, VITRINE_SCAN_FANOUT), GroupSize);
  BarrierBetweenScans();
  return true;
}

//------------------------------------------------------------------------------
std::uint32_t PackedScan::ReadTotal() const
{
  std::uint32_t total = 0;
  BarrierBeforeReadingBuffers();
  this->Sums.Read(this->TotalOffset(), sizeof(total), &total);
  return total;
}

//------------------------------------------------------------------------------
bool PackedScan::HasFailed() const
{
  return this->Counts.HasFailed() || this->Prediction.HasFailed() || this->Up.HasFailed() ||
    this->Down.HasFailed() || this->Counted.HasFailed() || this->Predicted.HasFailed();
}

//------------------------------------------------------------------------------
void PackedScan::Release()
{
  this->Sums.Release();
  for (ComputeProgram* program :
    { &this->Counts, &this->Prediction, &this->Up, &this->Down, &this->Counted })
  {
    program->Release();
  }
  this->Predicted.Release();
  this->VertexArray.Release();
}

}
