#include "transparency/abuffer/ListHeads.h"

#include "Core/geometry/Rounding.h"
#include "gl/FullScreenDraw.h"
#include "gl/MemoryBarriers.h"
#include "gl/ScopedState.h"
#include "gl/StateRecord.h"
#include "vtkOpenGLState.h"

namespace vitrine
{
namespace
{

// Turns alternating rows of first words and second words into rows of pairs.
std::vector<std::uint32_t> Interleaved(const std::vector<std::uint32_t>& words, std::size_t width)
{
  std::vector<std::uint32_t> pairs(words.size());
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    const std::size_t row = i / width;
    pairs[row / 2 * 2 * width + i % width * 2 + row % 2] = words[i];
  }
  return pairs;
}

// The reverse of Interleaved().
std::vector<std::uint32_t> Separated(const std::vector<std::uint32_t>& pairs, std::size_t width)
{
  std::vector<std::uint32_t> words(pairs.size());
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    const std::size_t row = i / width;
    words[i] = pairs[row / 2 * 2 * width + i % width * 2 + row % 2];
  }
  return words;
}

}

std::string ListHeads::Prepare(vtkOpenGLState* state, const RenderTarget& target,
  bool framebufferFetch, GLuint emptyFirst, int multiple)
{
  const std::uint64_t previous = this->Heads.Number();
  this->Fetched = framebufferFetch;
  this->EmptyFirst = framebufferFetch ? emptyFirst : 0u;
  this->Width = RoundedUp(target.Width, multiple);
  this->Height = RoundedUp(target.Height, multiple);
  // Image atomics need one value per texel, so each row of pixels has two rows of texels: first words, then second
  // words.
  std::string problem = framebufferFetch
    ? this->Heads.Allocate(GL_RG32UI, this->Width, this->Height, 0)
    : this->Heads.Allocate(GL_R32UI, this->Width, 2 * this->Height, 0);
  if (problem.empty())
  {
    this->Attach(state, target);
    if (this->Heads.Number() != previous)
    {
      // Frames clear their regions only. No head outside of these shall ever lead to a list.
      this->Clear(state, { 0, 0, this->Width, this->Height });
    }
  }
  return problem;
}

// The target's depth is attached anew each frame, since new images may have old names.
void ListHeads::Attach(vtkOpenGLState* state, const RenderTarget& target)
{
  this->WriteTarget.Attach(state, this->Heads);
  BindForDrawing(state, this->FillTarget.Handle());
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
    this->Fetched ? GLuint(this->Heads.Handle()) : 0u, 0);
  target.AttachDepth();
  // The mappers' shaders themselves write a colour to location 0.
  SetDrawBuffers(
    state, { GL_NONE, this->Fetched ? GLenum(GL_COLOR_ATTACHMENT0) : GLenum(GL_NONE) });
}

void ListHeads::Clear(vtkOpenGLState* state, const PixelRegion& r)
{
  const int rows = this->Fetched ? 1 : 2;
  BarrierBeforeFramebufferAccess();
  BindForDrawing(state, this->WriteTarget.Handle());
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(r.X, rows * r.Y, r.Width, rows * r.Height);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const GLuint empty[4] = { this->EmptyFirst, 0u, 0u, 0u };
  glClearBufferuiv(GL_COLOR, 0, empty);
}

void ListHeads::BindForWriting(vtkOpenGLState* state, const PixelRegion& r)
{
  const int rows = this->Fetched ? 1 : 2;
  BarrierBeforeFramebufferAccess();
  BindForFullScreenDraw(state, this->WriteTarget.Handle(), this->Width, rows * this->Height,
    { r.X, rows * r.Y, r.Width, rows * r.Height });
}

std::vector<std::uint32_t> ListHeads::Read(vtkOpenGLState* state)
{
  const auto width = static_cast<std::size_t>(this->Width);
  std::vector<std::uint32_t> words(2 * width * this->Height);
  const ScopedPixelTransfer pixelTransfer(ScopedPixelTransfer::FROM_DEVICE);
  BarrierBeforeFramebufferAccess();
  BindForReading(state, this->WriteTarget.Handle());
  glReadPixels(0, 0, this->Width, this->Height * (this->Fetched ? 1 : 2),
    this->Fetched ? GL_RG_INTEGER : GL_RED_INTEGER, GL_UNSIGNED_INT, words.data());
  return this->Fetched ? words : Interleaved(words, width);
}

void ListHeads::Write(vtkOpenGLState* state, const std::vector<std::uint32_t>& pairs)
{
  const ScopedPixelTransfer pixelTransfer(ScopedPixelTransfer::TO_DEVICE);
  const ScopedTextureUnit texture(state, GL_TEXTURE_2D, this->Heads.Handle());
  const std::vector<std::uint32_t> words =
    this->Fetched ? std::vector<std::uint32_t>() : Separated(pairs, this->Width);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, this->Width, this->Height * (this->Fetched ? 1 : 2),
    this->Fetched ? GL_RG_INTEGER : GL_RED_INTEGER, GL_UNSIGNED_INT,
    this->Fetched ? pairs.data() : words.data());
}

void ListHeads::Release()
{
  this->Heads.Release();
  this->FillTarget.Release();
  this->WriteTarget.Release();
}

}
