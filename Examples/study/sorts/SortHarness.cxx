#include "study/sorts/SortHarness.h"

#include "Core/geometry/Rounding.h"
#include "Shaders/SharedLayout.h"
#include "gl/Capabilities.h"
#include "gl/FullScreenDraw.h"
#include "gl/GLObjects.h"
#include "gl/MemoryBarriers.h"
#include "gl/ProgramCache.h"
#include "gl/ScopedState.h"
#include "shader/ShaderText.h"
#include "study/shaders/SortLayout.h"
#include "study/sorts/SortSources.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <chrono>

namespace vitrine
{
namespace
{

std::size_t RoundedUpToRows(std::size_t lists)
{
  return RoundedUp<std::size_t>(lists, VITRINE_SORT_ROW);
}

std::int64_t BytesOf(std::size_t elements)
{
  return static_cast<std::int64_t>(elements * sizeof(SortElement));
}

// Returns the milliseconds that `work` takes on the device.
template <class Work>
double Time(const Work& work)
{
  glFinish();
  const auto begin = std::chrono::steady_clock::now();
  work();
  glFinish();
  const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
  return passed.count();
}

enum class Output
{
  Checksums,
  Lists
};

}

struct SortHarness::Private
{
  std::string CheckLists(const std::vector<SortList>& lists, int capacity) const;
  std::string Upload(const std::vector<SortList>& lists);
  vtkShaderProgram* ReadyProgram(std::optional<ListSort> sort, Output output);
  std::optional<double> Draw(std::optional<ListSort> sort, Output output, int repeats);
  int Rows() const { return static_cast<int>(this->Lengths.size() / VITRINE_SORT_ROW); }

  vtkOpenGLRenderWindow* Window;
  int Capacity = 0;
  std::vector<std::uint32_t> Lengths; // List lengths, padded to whole rows of lists.
  std::size_t ListCount = 0;          // Number of lists without the padding of the last row.
  Buffer Lists;
  Buffer LengthBuffer;
  Buffer Sorted; // The sorted lists, in the layout of Lists. It is allocated once they are read.
  Image2D Checksums;
  Framebuffer Target;
  EmptyVertexArray VertexArray;
  ProgramCache Programs;
};

SortHarness::SortHarness(vtkOpenGLRenderWindow* window)
  : Impl(std::make_unique<Private>())
{
  this->Impl->Window = window;
}

SortHarness::~SortHarness()
{
  this->Impl->Window->MakeCurrent();
  this->Impl->Lists.Release();
  this->Impl->LengthBuffer.Release();
  this->Impl->Sorted.Release();
  this->Impl->Checksums.Release();
  this->Impl->Target.Release();
  this->Impl->VertexArray.Release();
  this->Impl->Programs.Release();
}

std::string SortHarness::FindMissingFeature() const
{
  this->Impl->Window->MakeCurrent();
  return MissingFeatures(4, 3, {});
}

//------------------------------------------------------------------------------
std::string SortHarness::SetLists(const std::vector<SortList>& lists, int capacity)
{
  this->Impl->Window->MakeCurrent();
  this->Impl->ListCount = 0;
  std::string problem = this->Impl->CheckLists(lists, capacity);
  if (!problem.empty())
  {
    return problem;
  }
  this->Impl->Capacity = capacity;
  this->Impl->Lengths.assign(RoundedUpToRows(lists.size()), 0u);
  for (std::size_t l = 0; l < lists.size(); ++l)
  {
    this->Impl->Lengths[l] = static_cast<std::uint32_t>(lists[l].size());
  }
  problem = this->Impl->Upload(lists);
  this->Impl->ListCount = problem.empty() ? lists.size() : 0;
  return problem;
}

std::string SortHarness::Private::CheckLists(const std::vector<SortList>& lists, int capacity) const
{
  if (capacity < 2 || capacity > LargestProvableNetwork || (capacity & (capacity - 1)) != 0)
  {
    return "storage for " + std::to_string(capacity) + " elements is no power of two from 2 to " +
      std::to_string(LargestProvableNetwork);
  }
  const std::size_t elements = RoundedUpToRows(lists.size()) * capacity;
  GLint rows = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &rows);
  if (lists.size() > static_cast<std::size_t>(rows) * VITRINE_SORT_ROW ||
    static_cast<std::int64_t>(elements) > LargestBufferTexture() ||
    BytesOf(elements) > LargestStorageBlock())
  {
    return std::to_string(lists.size()) + " lists are more than the driver's buffers hold";
  }
  for (const SortList& list : lists)
  {
    if (list.size() > static_cast<std::size_t>(capacity))
    {
      return "a list of " + std::to_string(list.size()) +
        " elements does not fit into storage for " + std::to_string(capacity);
    }
    if (std::any_of(list.begin(), list.end(), [](const SortElement& e) { return e.Key == NoKey; }))
    {
      return "the key 0xffffffff marks unused elements and cannot be sorted";
    }
  }
  return lists.empty() ? "there are no lists" : "";
}

std::string SortHarness::Private::Upload(const std::vector<SortList>& lists)
{
  const std::size_t stride = this->Lengths.size();
  std::vector<SortElement> elements(stride * this->Capacity, { NoKey, 0u });
  for (std::size_t l = 0; l < lists.size(); ++l)
  {
    for (std::size_t i = 0; i < lists[l].size(); ++i)
    {
      elements[i * stride + l] = lists[l][i];
    }
  }
  const std::int64_t bytes = BytesOf(elements.size());
  const auto lengthBytes = static_cast<std::int64_t>(stride * sizeof(std::uint32_t));
  if (!this->Lists.Allocate(bytes, GL_RG32UI) ||
    !this->LengthBuffer.Allocate(lengthBytes, GL_R32UI))
  {
    return "the driver has no memory for the lists";
  }
  this->Lists.Write(0, bytes, elements.data());
  this->LengthBuffer.Write(0, lengthBytes, this->Lengths.data());
  return this->Checksums.Allocate(GL_RG32UI, VITRINE_SORT_ROW, this->Rows(), 0);
}

//------------------------------------------------------------------------------
std::optional<double> SortHarness::Sort(ListSort sort, int repeats)
{
  return this->Impl->Draw(sort, Output::Checksums, repeats);
}

std::optional<double> SortHarness::Copy(int repeats)
{
  return this->Impl->Draw(std::nullopt, Output::Checksums, repeats);
}

//------------------------------------------------------------------------------
vtkShaderProgram* SortHarness::Private::ReadyProgram(std::optional<ListSort> sort, Output output)
{
  std::vector<std::string> defines = SortDefines(this->Capacity);
  if (output == Output::Lists)
  {
    defines.emplace_back("VITRINE_SORT_STORE");
  }
  return this->Programs.Ready(this->Window, sort ? NameOf(*sort) : "copy", defines,
    shaders::FullScreenVertex, [&] { return SortSource(sort, this->Capacity); });
}

std::optional<double> SortHarness::Private::Draw(
  std::optional<ListSort> sort, Output output, int repeats)
{
  if (this->ListCount == 0)
  {
    return std::nullopt;
  }
  this->Window->MakeCurrent();
  vtkOpenGLState* state = this->Window->GetState();
  const ScopedTrackedState trackedState(state);
  const ScopedShaderProgram shaderProgram(this->Window);
  const ScopedVertexArray vertexArray(this->VertexArray.Handle());
  const ScopedStorageBuffer sorted(VITRINE_BINDING_CAPTURE, this->Sorted.Handle());
  const ScopedTextureUnit lists(state, GL_TEXTURE_BUFFER, this->Lists.Texture());
  const ScopedTextureUnit lengths(state, GL_TEXTURE_BUFFER, this->LengthBuffer.Texture());
  BindForFullScreenDraw(state, this->Target.Handle(), VITRINE_SORT_ROW, this->Rows());
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Checksums.Handle(), 0);

  vtkShaderProgram* program = this->ReadyProgram(sort, output);
  if (!program)
  {
    return std::nullopt;
  }
  program->SetUniformi("lists", lists.Unit());
  program->SetUniformi("lengths", lengths.Unit());
  program->SetUniformi("listCount", static_cast<int>(this->Lengths.size()));
  program->SetUniformi("repeats", repeats);
  BarrierBeforeFilling();
  return Time([] { glDrawArrays(GL_TRIANGLES, 0, 3); });
}

//------------------------------------------------------------------------------
std::vector<std::array<std::uint32_t, 2>> SortHarness::ReadChecksums()
{
  this->Impl->Window->MakeCurrent();
  std::vector<std::array<std::uint32_t, 2>> checksums(this->Impl->Lengths.size());
  if (this->Impl->ListCount > 0)
  {
    vtkOpenGLState* state = this->Impl->Window->GetState();
    const ScopedTrackedState trackedState(state);
    state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->Impl->Target.Handle());
    const ScopedReadBuffer readBuffer(state, GL_COLOR_ATTACHMENT0);
    const ScopedPixelTransfer transfer(ScopedPixelTransfer::FROM_DEVICE);
    glReadPixels(
      0, 0, VITRINE_SORT_ROW, this->Impl->Rows(), GL_RG_INTEGER, GL_UNSIGNED_INT, checksums.data());
  }
  checksums.resize(this->Impl->ListCount);
  return checksums;
}

std::optional<std::vector<SortList>> SortHarness::SortAndRead(ListSort sort)
{
  this->Impl->Window->MakeCurrent();
  const std::size_t stride = this->Impl->Lengths.size();
  std::vector<SortElement> elements(stride * this->Impl->Capacity);
  const std::int64_t bytes = BytesOf(elements.size());
  if (this->Impl->ListCount == 0 || !this->Impl->Sorted.Allocate(bytes) ||
    !this->Impl->Draw(sort, Output::Lists, 1))
  {
    return std::nullopt;
  }
  BarrierBeforeReadingBuffers();
  this->Impl->Sorted.Read(0, bytes, elements.data());
  std::vector<SortList> lists(this->Impl->ListCount);
  for (std::size_t l = 0; l < lists.size(); ++l)
  {
    for (std::size_t i = 0; i < this->Impl->Lengths[l]; ++i)
    {
      lists[l].push_back(elements[i * stride + l]);
    }
  }
  return lists;
}

}
