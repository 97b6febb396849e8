/**
 * Vitrine's steps within a chain of passes that somebody else has put together.
 */
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
 * Changes a chain of passes while it lives. The destructor puts the chain back as it was, so that whoever owns the
 * chain finds it untouched between frames.
 */
class ChainEdit
{
public:
  explicit ChainEdit(vtkRenderPass* root);
  ~ChainEdit();
  ChainEdit(const ChainEdit&) = delete;
  void operator=(const ChainEdit&) = delete;

  /**
   * Has `step` draw what is translucent, in place of the pass of the chain that does, and after all passes that draw
   * opaque geometry. A chain that draws opaque geometry alone, as one with shadows often does, draws the step as well
   * then. Returns false, and changes nothing, if the chain has no place for it.
   */
  bool PutTranslucentStep(vtkRenderPass* step);

  /** Has `lights` light what the chain draws, below all passes that process a picture. */
  void PutLights(vtkClusteredLightsPass* lights);

  /** The pass that draws the chain. */
  vtkRenderPass* Root() const { return this->RootPass; }

private:
  using Passes = std::vector<vtkSmartPointer<vtkRenderPass>>;

  bool PutInPlace(vtkRenderPass* step, vtkRenderPass* pass, vtkRenderPass* parent);
  bool PutIntoSequence(vtkRenderPass* step, vtkSequencePass* sequence);
  void Replace(vtkRenderPass* parent, vtkRenderPass* before, vtkRenderPass* after);
  void SetPasses(vtkSequencePass* sequence, const Passes& passes);

  vtkSmartPointer<vtkRenderPass> RootPass;
  std::vector<std::function<void()>> Undo; ///< in the order of what they undo
};

}

#endif
