#ifndef VITRINE_SCENE_LISTED_PASS_H
#define VITRINE_SCENE_LISTED_PASS_H

#include "vtkSmartPointer.h"

#include <vector>

class vtkOpenGLRenderPass;
class vtkProp;

namespace vitrine
{

/**
 * A pass that draws nothing, listed among the passes of props (vtkOpenGLRenderPass::RenderPasses()) while their
 * renderer draws a frame. So it changes the shaders of their mappers, whatever pass draws the frame.
 */
class ListedPass
{
public:
  explicit ListedPass(vtkOpenGLRenderPass* pass)
    : Pass(pass)
  {
  }
  ~ListedPass() { this->Unlist(); }
  ListedPass(const ListedPass&) = delete;
  void operator=(const ListedPass&) = delete;

  /** List the pass for a prop, after those that are listed already. */
  void List(vtkProp* prop);

  /** Take the pass from all props that List() was called with. */
  void Unlist();

private:
  vtkOpenGLRenderPass* Pass;
  std::vector<vtkSmartPointer<vtkProp>> Props;
};

}

#endif
