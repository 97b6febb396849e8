/** The resolve pass of the A-buffer methods: sorts and composites the lists of a FragmentStore. */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_LIST_RESOLVER_H
#define VITRINE_TRANSPARENCY_ABUFFER_LIST_RESOLVER_H

#include "Core/lists/SortPlan.h"
#include "gl/GLObjects.h"
#include "gl/ProgramCache.h"
#include "gl/RenderTarget.h"
#include "transparency/abuffer/ListLayout.h"
#include "transparency/abuffer/SampleImages.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkShaderProgram;

namespace vitrine
{

class ErrorBounds;
class FragmentStore;
class HiddenDepths;

/** What the resolve finds out besides the picture. Null is not found out; the layout says the same. */
struct ResolveFindings
{
  const ErrorBounds* Bounds = nullptr;
  const HiddenDepths* Hidden = nullptr;
};

class ListResolver
{
public:
  /**
   * Make room for the tiles and the samples of the target. Call this before all else. Changes the framebuffer binding.
   * Returns an error message, empty on success.
   */
  std::string Prepare(vtkOpenGLState* state, const RenderTarget& target, const ListLayout& layout);

  /** Find each tile's longest list, and add what the lists in `region` need to the store's counters. */
  void Classify(vtkOpenGLRenderWindow* window, const ListLayout& layout, FragmentStore& store,
    const ResolveFindings& findings, const RenderTarget& target, const PixelRegion& region);

  /**
   * Returns why a list of `longest` fragments cannot be resolved here, or an empty string. llvmpipe silently ends a
   * shader's loops after 65,535 rounds, and the merge of long runs takes at least two rounds per fragment.
   */
  static std::string FindProblemOfLength(std::int64_t longest);

  /**
   * Sort the lists of `region` and composite them over the backdrop into the target. `tileBins` are the bins that
   * Classify() found. Returns false, with nothing drawn, if a shader does not
   * compile.
   */
  bool Resolve(vtkOpenGLRenderWindow* window, const ListLayout& layout, FragmentStore& store,
    const ResolveFindings& findings, const Image2D& backdrop, const RenderTarget& target,
    const PixelRegion& region, std::uint32_t tileBins);

  /** Returns true if a shader did not compile. Nothing was drawn by it. */
  bool HasFailed() const { return this->Programs.HasFailed(); }

  std::int64_t Bytes() const { return this->TileMax.Bytes() + this->Samples.Colors().Bytes(); }

  void Release();

private:
  // One draw: the program of a bin, for lists longer than `Longer` and no longer than the bin's limit.
  struct BinDraw
  {
    SortBin Bin;
    int Longer;
  };
  std::vector<BinDraw> PlanDraws(
    const ListLayout& layout, const SortPlan& plan, std::uint32_t tileBins) const;
  bool ReadyPrograms(vtkOpenGLRenderWindow* window, const ListLayout& layout, const SortPlan& plan,
    const SortBin& bin);
  void BindForSort(vtkOpenGLState* state, const RenderTarget& target);
  vtkShaderProgram* ReadyClassify(vtkOpenGLRenderWindow* window, const ListLayout& layout);
  vtkShaderProgram* ReadySortRuns(vtkOpenGLRenderWindow* window, const ListLayout& layout,
    const SortPlan& plan, const SortBin& bin);
  vtkShaderProgram* ReadySamples(vtkOpenGLRenderWindow* window, const ListLayout& layout);
  vtkShaderProgram* ReadyResolve(vtkOpenGLRenderWindow* window, const ListLayout& layout,
    const SortPlan& plan, const SortBin& bin);

  Image2D TileMax;
  Framebuffer TileFramebuffer;
  Framebuffer SortFramebuffer; // Has no images.
  SampleImages Samples; // If lists are composited into all samples at once, else without images.
  EmptyVertexArray VertexArray;
  ProgramCache Programs;
};

}
#endif
