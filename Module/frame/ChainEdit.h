/** Inserts Vitrine's steps into a chain of render passes of the application. */
#ifndef VITRINE_FRAME_CHAIN_EDIT_H
#define VITRINE_FRAME_CHAIN_EDIT_H

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkClusteredLightsPass;
class vtkRenderPass;
class vtkSequencePass;

namespace vitrine
{

/**
 * Changes a chain of passes while it lives. The destructor restores the chain, so the application finds it unchanged
 * between frames.
 */
class ChainEdit
{
public:
  explicit ChainEdit(vtkRenderPass* root);
  ~ChainEdit();
  ChainEdit(const ChainEdit&) = delete;
  void operator=(const ChainEdit&) = delete;

  /**
   * Make `step` draw the translucent geometry. It replaces the chain's last translucent pass, and the others draw
   * nothing. If opaque geometry is drawn later, or nothing translucent is drawn, it comes behind the last pass that
   * draws opaque geometry, as chains with shadows often need. Returns false if the chain has no place for it, and
   * changes nothing then.
   */
  bool PutTranslucentStep(vtkRenderPass* step);

  /** Make `lights` light what the chain draws. It goes below all passes that process a picture. */
  void PutLights(vtkClusteredLightsPass* lights);

  /** The pass that draws the chain. */
  vtkRenderPass* Root() const { return this->RootPass; }

private:
  using Passes = std::vector<vtkSmartPointer<vtkRenderPass>>;

  /** Puts `step` into `pass`, if that is a vtkRenderStepsPass, or else in its place. */
  void PutAt(vtkRenderPass* parent, vtkRenderPass* pass, vtkRenderPass* step);
  /** Replaces the last occurrence of a delegate of `parent`, or the root if `parent` is null. */
  void Replace(vtkRenderPass* parent, vtkRenderPass* before, vtkRenderPass* after);
  void SetPasses(vtkSequencePass* sequence, const Passes& passes);

  vtkSmartPointer<vtkRenderPass> RootPass;
  /** Functions in the order of the changes that they undo. */
  std::vector<std::function<void()>> Undo;
};

}

#endif
