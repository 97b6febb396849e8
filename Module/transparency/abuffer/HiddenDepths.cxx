#include "transparency/abuffer/HiddenDepths.h"

#include "Core/geometry/Rounding.h"
#include "Shaders/SharedLayout.h"
#include "gl/FullScreenDraw.h"
#include "gl/MemoryBarriers.h"
#include "gl/StateRecord.h"
#include "shader/ShaderText.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace vitrine
{
namespace
{

constexpr int GroupSize = 64;      // as in HiddenSpread.glsl
constexpr int BlocksOfHeight = 32; // A picture may move by so many parts of its height.
constexpr int SmallestBlock = 8;
const char* const NoMemory = "the driver has no memory for the depths that hide what is behind";

// Pixels of a side of a block: a power of two.
int BlockOf(int height)
{
  int block = SmallestBlock;
  while (2 * block * BlocksOfHeight <= height)
  {
    block *= 2;
  }
  return block;
}

}

//------------------------------------------------------------------------------
HiddenDepths::HiddenDepths()
  : Spread(shaders::HiddenSpread)
{
}

//------------------------------------------------------------------------------
std::string HiddenDepths::Begin(vtkOpenGLRenderWindow* window, const RenderTarget& target,
  bool cuts, bool moved, RenderTarget& fill)
{
  this->Block = 0;
  this->Now = nullptr;
  if (!this->Reserve(target))
  {
    return NoMemory;
  }
  std::string problem;
  if (cuts && this->HasLast)
  {
    if (moved && !this->SpreadWords(window))
    {
      return ProgramFailure;
    }
    this->Block = moved ? BlockOf(this->Size[1]) : 1;
    this->Row = moved ? this->Blocks[0] : this->Size[0];
    this->Now = moved ? &this->BlockWords[1] : &this->Words[this->Next];
    problem = this->DrawCut(window, target, fill);
  }
  this->HasLast = false;
  this->Next = 1 - this->Next;
  this->Words[this->Next].Clear();
  return problem;
}

//------------------------------------------------------------------------------
bool HiddenDepths::Reserve(const RenderTarget& target)
{
  const std::array<int, 2> size{ target.Width, target.Height };
  if (size == this->Size)
  {
    return true;
  }
  const int block = BlockOf(target.Height);
  this->HasLast = false;
  this->Size = {};
  this->Blocks = { DividedUp(target.Width, block), DividedUp(target.Height, block) };
  const std::int64_t word = sizeof(std::uint32_t);
  for (int i = 0; i < 2; ++i)
  {
    if (!this->Words[i].Allocate(word * size[0] * size[1], GL_R32UI) ||
      !this->BlockWords[i].Allocate(word * this->Blocks[0] * this->Blocks[1], GL_R32UI))
    {
      return false;
    }
  }
  this->Size = size;
  return true;
}

//------------------------------------------------------------------------------
bool HiddenDepths::SpreadWords(vtkOpenGLRenderWindow* window)
{
  return this->RunSpread(window, this->Words[this->Next], this->Size, this->BlockWords[0],
           this->Blocks, BlockOf(this->Size[1])) &&
    this->RunSpread(
      window, this->BlockWords[0], this->Blocks, this->BlockWords[1], this->Blocks, 1);
}

//------------------------------------------------------------------------------
bool HiddenDepths::RunSpread(vtkOpenGLRenderWindow* window, const Buffer& in,
  const std::array<int, 2>& sizeIn, const Buffer& out, const std::array<int, 2>& sizeOut,
  int pixelsOfBlock)
{
  const ScopedImage wordsIn(VITRINE_IMAGE_HIDDEN, in.Texture());
  const ScopedImage wordsOut(VITRINE_IMAGE_HIDDEN_OUT, out.Texture());
  if (!this->Spread.Use(window, {}))
  {
    return false;
  }
  const int first[2] = { sizeIn[0], sizeIn[1] };
  const int second[2] = { sizeOut[0], sizeOut[1] };
  this->Spread.Set("sizeIn", first);
  this->Spread.Set("sizeOut", second);
  this->Spread.Set("pixelsOfBlock", pixelsOfBlock);
  BarrierBetweenScans();
  ComputeProgram::DispatchFor(std::int64_t(sizeOut[0]) * sizeOut[1], GroupSize);
  BarrierBetweenScans();
  return true;
}

//------------------------------------------------------------------------------
// Copies the opaque depth, and draws the depths of the last frame where they are nearer.
std::string HiddenDepths::DrawCut(
  vtkOpenGLRenderWindow* window, const RenderTarget& target, RenderTarget& fill)
{
  vtkOpenGLState* const state = window->GetState();
  std::string problem =
    this->Depth.Allocate(target.Depth.InternalFormat, target.Width, target.Height, 0);
  if (!problem.empty())
  {
    return problem;
  }
  fill.Depth = target.Depth;
  fill.Depth.Type = GL_TEXTURE;
  fill.Depth.Name = this->Depth.Handle();
  fill.Depth.TextureTarget = GL_TEXTURE_2D;
  fill.Depth.Level = 0;
  BindForReading(state, target.Framebuffer);
  BindForDrawing(state, this->Target.Handle());
  fill.AttachDepth();
  SetDrawBuffers(state, { GL_NONE });
  const PixelRegion& r = target.Region;
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglBlitFramebuffer(r.X, r.Y, r.X + r.Width, r.Y + r.Height, r.X, r.Y, r.X + r.Width,
    r.Y + r.Height, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  BindForFullScreenDraw(state, this->Target.Handle(), target.Width, target.Height, r);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglDepthMask(GL_TRUE);
  const BoundVertexArray vertexArray(this->VertexArray.Handle());
  const ScopedTextureUnit now(state, GL_TEXTURE_BUFFER, this->NowTexture());
  vtkShaderProgram* const program = this->Cut.Ready(
    window, "hidden cut", {}, shaders::FullScreenVertex, [] { return shaders::HiddenCut; });
  if (!program)
  {
    return ProgramFailure;
  }
  this->SetUniforms(program, now.Unit());
  BarrierBeforeReadingLists();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  state->vtkglDepthMask(GL_FALSE);
  return {};
}

//------------------------------------------------------------------------------
void HiddenDepths::SetUniforms(vtkShaderProgram* program, int unitOfNow) const
{
  if (program->IsUniformUsed("hiddenBlock"))
  {
    program->SetUniformi("hiddenNow", unitOfNow);
    program->SetUniformi("hiddenRow", this->Row);
    program->SetUniformi("hiddenBlock", this->Block);
  }
  if (program->IsUniformUsed("hiddenLight"))
  {
    program->SetUniformi("hiddenWidth", this->Size[0]);
    program->SetUniformf("hiddenLight", static_cast<float>(this->Light));
  }
}

//------------------------------------------------------------------------------
std::int64_t HiddenDepths::Bytes() const
{
  std::int64_t bytes = this->Depth.Bytes();
  for (int i = 0; i < 2; ++i)
  {
    bytes += this->Words[i].Bytes() + this->BlockWords[i].Bytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void HiddenDepths::Release()
{
  for (int i = 0; i < 2; ++i)
  {
    this->Words[i].Release();
    this->BlockWords[i].Release();
  }
  this->Size = {};
  this->HasLast = false;
  this->Block = 0;
  this->Now = nullptr;
  this->Spread.Release();
  this->Cut.Release();
  this->VertexArray.Release();
  this->Depth.Release();
  this->Target.Release();
}

//------------------------------------------------------------------------------
ScopedHiddenDepths::ScopedHiddenDepths(vtkOpenGLState* state, const HiddenDepths& depths)
  : Depths(depths)
  , Next(VITRINE_IMAGE_HIDDEN, depths.NextTexture())
  , Now(state, GL_TEXTURE_BUFFER, depths.NowTexture())
{
}

void ScopedHiddenDepths::SetUniforms(vtkShaderProgram* program) const
{
  this->Depths.SetUniforms(program, this->Now.Unit());
}

}
