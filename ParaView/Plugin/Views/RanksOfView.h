/** Draws a view on several ranks together, in place of ParaView's compositing. */
#ifndef VITRINE_PARAVIEW_RANKS_OF_VIEW_H
#define VITRINE_PARAVIEW_RANKS_OF_VIEW_H

#include "vtkDistributedTransparencyPass.h"
#include "vtkNew.h"
#include "vtkPVSynchronizedRenderer.h"
#include "vtkProp.h"
#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkFloatArray;
class vtkPVSession;
class vtkRenderer;

namespace vitrine
{

/**
 * ParaView's IceT blends or compares pictures of ranks. Here ranks exchange fragments while they draw, and what rank 0
 * has drawn is the picture. So these frames have a synchronizer of their own, which takes that picture as it is. Where
 * ranks could not draw a frame together, the synchronizer takes the nearest of their pixels.
 */
class RanksOfView
{
public:
  /** The class of the pass that draws `frame` on all ranks. It sees what that one does. */
  static constexpr const char* ClassOfPass = "SameCamera";

  /** The session is that of the view, and `frame` draws its frames. */
  RanksOfView(vtkPVSession* session, vtkRenderPass* frame);

  /** Returns true if a view with this synchronizer of ParaView is drawn by several ranks of this process. */
  static bool Draw(vtkPVSynchronizedRenderer* synchronizer);

  /** Returns the translucent pass of frames that all ranks draw. */
  vtkDistributedTransparencyPass* Pass() { return this->Transparency; }

  /** Returns the depths of the last frame that ranks drew, by rows from the bottom. Null before the first. */
  vtkFloatArray* Depths();

  /** Set how pictures are compressed on the way to the client. */
  void ConfigureCompressor(const char* configuration);

  /**
   * Called within a Frame before the renderer draws. On ranks but 0 hides props that all ranks show alike until the
   * frame ends.
   */
  void PrepareToDraw(vtkRenderer* renderer);

  /** As long as it lives, ranks draw the renderer's frames together, by a synchronizer in place of ParaView's. */
  class Frame
  {
  public:
    Frame(RanksOfView& ranks, vtkRenderer* renderer, vtkPVSynchronizedRenderer*& synchronizer);
    ~Frame();
    Frame(const Frame&) = delete;
    void operator=(const Frame&) = delete;

  private:
    RanksOfView& Ranks;
    vtkRenderer* Renderer;
    vtkPVSynchronizedRenderer*& Synchronizer;
    vtkPVSynchronizedRenderer* Own;
    vtkSmartPointer<vtkRenderPass> OwnPass;
  };

private:
  vtkNew<vtkDistributedTransparencyPass> Transparency;
  vtkNew<vtkPVSynchronizedRenderer> Together;
  std::vector<vtkSmartPointer<vtkProp>> Hidden; ///< on this rank, in this frame
};

}

#endif
