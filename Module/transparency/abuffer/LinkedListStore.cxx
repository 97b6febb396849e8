#include "transparency/abuffer/LinkedListStore.h"

#include "gl/MemoryBarriers.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

namespace vitrine
{

std::string LinkedListStore::BeginFrame(
  vtkOpenGLState* state, const RenderTarget& target, std::int64_t limit, ListLayout& layout)
{
  layout.Packed = false;
  this->Pool.SetLayout(layout.NodeBytes(), layout.PartNumbers, layout.FramebufferFetch);
  this->Pool.SetLimit(limit);
  // Heads set by atomics hold the page's number plus one, so 0 is none.
  return this->ListsOfPixels.Prepare(state, target, layout.FramebufferFetch, VITRINE_END);
}

std::string LinkedListStore::BeginFill(
  vtkOpenGLRenderWindow* window, const PixelRegion& region, ListLayout& layout)
{
  layout.PageSize = this->Pool.PageSize();
  this->ListsOfPixels.Clear(window->GetState(), region);
  return this->Counters.Reset() && this->Pool.Ensure()
    ? std::string()
    : "the driver has no memory for the smallest node pool";
}

void LinkedListStore::SetFillUniforms(vtkShaderProgram* program) const
{
  program->SetUniformi("vitrinePages", static_cast<int>(this->Pool.CapacityPages()));
  if (program->IsUniformUsed("vitrineSubPoolPages"))
  {
    program->SetUniformi("vitrineSubPoolPages", static_cast<int>(this->Pool.SubPoolPages()));
  }
  if (program->IsUniformUsed("vitrinePageSize"))
  {
    program->SetUniformi("vitrinePageSize", this->Pool.PageSize());
  }
}

std::vector<std::uint32_t> LinkedListStore::ReadCounts(vtkOpenGLState* state)
{
  const std::vector<std::uint32_t> heads = this->ListsOfPixels.Read(state);
  std::vector<std::uint32_t> counts(heads.size() / 2);
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    counts[i] = heads[2 * i + 1];
  }
  return counts;
}

void LinkedListStore::EndFrame(const FragmentStatistics& used, int)
{
  this->Pool.EndFrame(used);
}

void LinkedListStore::Release()
{
  this->FragmentStore::Release();
  this->Pool.Release();
}

}
