/**
 * The render passes around one that draws props into framebuffers of its own.
 */
#ifndef VITRINE_OUTER_PASSES_H
#define VITRINE_OUTER_PASSES_H

#include "gl/VitrineOpenGL.h"
#include "vtkSmartPointer.h"

#include <utility>
#include <vector>

class vtkInformation;
class vtkObjectBase;
class vtkOpenGLState;
class vtkRenderState;

namespace vitrine
{

/**
 * VTK's mappers ask all render passes of a prop to set what they need before each draw. A pass may set the draw buffers of its own
 * framebuffer then, as vtkSSAOPass does, which takes for granted that this framebuffer is bound. Within a Scope it is bound at
 * that time, and the one that is drawn into is bound again before the draw.
 */
class OuterPasses
{
public:
  OuterPasses();
  ~OuterPasses();
  OuterPasses(const OuterPasses&) = delete;
  void operator=(const OuterPasses&) = delete;

  /** Shaders of mappers have outputs beside the colour: a pass around counts on its draw buffers, even if the target has one. */
  void ExpectFurtherOutputs();

  /**
   * For as long as it lives, outer passes have the framebuffer that is bound for drawing when it is made, if it is not the
   * window's. Its draw buffers, but for the first, are GL_NONE until the end, when they are what they were.
   */
  class Scope
  {
  public:
    Scope(OuterPasses& passes, const vtkRenderState* s, vtkOpenGLState* state);
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
