/** Serves the render passes around a pass that draws props into its own framebuffers. */
#ifndef VITRINE_OUTER_PASSES_H
#define VITRINE_OUTER_PASSES_H

#include "gl/VitrineOpenGL.h"
#include "vtkSmartPointer.h"

#include <utility>
#include <vector>

class vtkInformation;
class vtkObjectBase;
class vtkOpenGLRenderWindow;
class vtkRenderState;

namespace vitrine
{

/**
 * Before each draw, VTK's mappers let all render passes of a prop set their uniforms and state. There a pass may set
 * the draw buffers of its own framebuffer, as vtkSSAOPass does, which assumes that this framebuffer is bound. Within a
 * Scope it is bound at that time. The framebuffer that is drawn into is bound again before the draw.
 */
class OuterPasses
{
public:
  OuterPasses();
  ~OuterPasses();
  OuterPasses(const OuterPasses&) = delete;
  void operator=(const OuterPasses&) = delete;

  /**
   * Tell that shaders of mappers have outputs beside the colour. An outer pass then relies on its draw buffers, even if
   * the target has only one.
   */
  void ExpectFurtherOutputs();

  /**
   * While a Scope lives, outer passes see the framebuffer that was bound for drawing at its construction. Its draw
   * buffers after the first are GL_NONE until the destructor restores them. A Scope does nothing if the window's own
   * framebuffer is bound.
   */
  class Scope
  {
  public:
    Scope(OuterPasses& passes, const vtkRenderState* s, vtkOpenGLRenderWindow* window);
    ~Scope();
    Scope(const Scope&) = delete;
    void operator=(const Scope&) = delete;

  private:
    OuterPasses& Passes;
  };

private:
  struct Target;
  class Enter;
  class Leave;
  using PassList = std::vector<vtkSmartPointer<vtkObjectBase>>;

  void Surround(const vtkRenderState* s);
  void Restore();

  vtkSmartPointer<Enter> First;
  vtkSmartPointer<Leave> Last;
  std::vector<std::pair<vtkSmartPointer<vtkInformation>, PassList>> Lists;
};

}
#endif
