/**
 * The second half of the methods that store lists: what those hold becomes a picture.
 */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_LIST_RESOLVER_H
#define VITRINE_TRANSPARENCY_ABUFFER_LIST_RESOLVER_H

#include "gl/GLObjects.h"
#include "gl/ProgramCache.h"
#include "gl/RenderTarget.h"
#include "transparency/abuffer/ListLayout.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkShaderProgram;

namespace vitrine
{

class FragmentStore;

class ListResolver
{
public:
  /**
   * Make room for the tiles of the target, before the rest. Changes the framebuffer binding. Returns an empty
   * string, or why the driver cannot.
   */
  std::string PrepareTiles(vtkOpenGLState* state, const RenderTarget& target);

  /**
   * Count what the lists in `region` need into the store's counters, and each tile's longest list.
   */
  void Classify(vtkOpenGLRenderWindow* window, const ListLayout& layout, FragmentStore& store,
    const RenderTarget& target, const PixelRegion& region);

  /**
   * Empty, or why a list of `longest` fragments cannot be resolved here: llvmpipe ends the loops of a shader after 65,535
   * rounds, in silence, and the merge of long runs takes two and more for each fragment.
   */
  static std::string FindProblemOfLength(std::int64_t longest);

  /**
   * Sort and composite the lists of `region` over the backdrop, into the target. `tileBins` are the bins that
   * Classify() found. Returns false, with nothing drawn, if a shader does not compile.
   */
  bool Resolve(vtkOpenGLRenderWindow* window, const ListLayout& layout, FragmentStore& store,
    const Image2D& backdrop, const RenderTarget& target, const PixelRegion& region,
    std::uint32_t tileBins);

  /** Whether a shader did not compile, so that nothing was drawn by it. */
  bool HasFailed() const { return this->Programs.HasFailed(); }

  std::int64_t Bytes() const { return this->TileMax.Bytes(); }

  void Release();

private:
  // One draw: the program of a bin, for lists longer than `Longer` and no longer than the bin allows.
  struct BinDraw
  {
    int Bin;
    int Longer;
  };
  std::vector<BinDraw> PlanDraws(const ListLayout& layout, std::uint32_t tileBins) const;
  bool ReadyPrograms(vtkOpenGLRenderWindow* window, const ListLayout& layout, int bin);
  void BindForSort(vtkOpenGLState* state, const RenderTarget& target);
  vtkShaderProgram* ReadyClassify(vtkOpenGLRenderWindow* window, const ListLayout& layout);
  vtkShaderProgram* ReadySortRuns(vtkOpenGLRenderWindow* window, const ListLayout& layout, int bin);
  vtkShaderProgram* ReadyResolve(vtkOpenGLRenderWindow* window, const ListLayout& layout, int bin);

  Image2D TileMax;
  Framebuffer TileFramebuffer;
  Framebuffer SortFramebuffer; // without images
  EmptyVertexArray VertexArray;
  ProgramCache Programs;
};

}
#endif
