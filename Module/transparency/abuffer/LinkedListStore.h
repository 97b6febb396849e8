/** Store of linked lists: shaders allocate pages from a node pool, and an image holds the heads. */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_LINKED_LIST_STORE_H
#define VITRINE_TRANSPARENCY_ABUFFER_LINKED_LIST_STORE_H

#include "transparency/abuffer/FragmentStore.h"
#include "transparency/abuffer/NodePool.h"

namespace vitrine
{

class LinkedListStore : public FragmentStore
{
public:
  std::string BeginFrame(vtkOpenGLState* state, const RenderTarget& target, std::int64_t limit,
    ListLayout& layout) override;
  std::string BeginFill(
    vtkOpenGLRenderWindow* window, const PixelRegion& region, ListLayout& layout) override;
  void SetFillUniforms(vtkShaderProgram* program) const override;
  FitType Fit(const FragmentStatistics& needed) override { return this->Pool.Fit(needed); }
  bool HasRoomFor(const FragmentStatistics& needed) const override
  {
    return this->Pool.MayHold(needed);
  }
  std::int64_t CapacityUnits() const override { return this->Pool.CapacityPages(); }
  int UnitNodes() const override { return this->Pool.PageSize(); }
  std::int64_t UnitBytes() const override { return this->Pool.PageBytes(); }
  std::string DescribeLimit() const override { return this->Pool.DescribeLimit(); }
  std::vector<std::uint32_t> ReadCounts(vtkOpenGLState* state) override;
  void EndFrame(const FragmentStatistics& used, int bands) override;
  const NodeBuffers& Nodes() const override { return this->Pool.NodeMemory(); }
  GLuint LinkTexture() const override { return this->Pool.LinkTexture(); }
  std::int64_t NodeBytes() const override { return this->Pool.Bytes(); }
  void Release() override;

private:
  NodePool Pool;
};

}
#endif
