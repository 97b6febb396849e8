/**
 * @class   vtkVitrineRenderView
 * @brief   ParaView's render view, with exact transparency
 *
 * The view draws what vtkPVRenderView draws, by a vtkSeeThroughPass. Opaque geometry, volumes, annotations and
 * selections are as in ParaView's own view. Where ParaView peels volumes and translucent geometry together, it peels
 * until nothing is left. Ray tracing draws without this view's pass.
 *
 * A process that draws together with other ranks, on a tiled display or in a CAVE, draws as ParaView does, and tells
 * why: fragments are not exchanged between ranks yet.
 *
 * @sa
 * vtkSeeThroughPass
 */
#ifndef vtkVitrineRenderView_h
#define vtkVitrineRenderView_h

#include "vtkPVRenderView.h"
#include "vtkVitrineParaViewViewsModule.h" // export macro

#include <memory> // for the view's internals
#include <string> // for texts

class VTKVITRINEPARAVIEWVIEWS_EXPORT vtkVitrineRenderView : public vtkPVRenderView
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkVitrineRenderView* New();
  vtkTypeMacro(vtkVitrineRenderView, vtkPVRenderView);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * Set the name of the method for translucent geometry, one of vtkTransparencyPass::GetMethods(). The default is
   * "linked-list". Another name is an error and is ignored.
   */
  void SetTransparencyMethod(const char* name);

  /**
   * Set the greatest error of a channel of the 8-bit picture, in [0, 1], that the method "automatic" keeps. The range
   * is 0.6 / 255 to 1, the default is 1 / 255. Other methods ignore it.
   */
  void SetErrorBudget(double budget);

  /**
   * Set how the colours of fragments are stored, one of vtkABufferTransparencyPass::ColorStorageType. The default is
   * HALF_FLOAT. The methods "automatic", "stencil-routed" and "truth" ignore it.
   */
  void SetColorStorage(int storage);

  /**
   * Set the maximum GPU memory for fragments, in MiB. Frames that need more are drawn in bands of the screen. The
   * default is 0, which means no limit. Methods without lists ignore it.
   */
  void SetMemoryLimit(int mebibytes);

  ///@{
  /**
   * Set the tolerance within which fragments have no order: in steps of 2^-24 of the window's depth, and as a multiple
   * of the depth's change to the next pixel. Both are 0 by default, which is no tolerance.
   */
  void SetCoincidenceSteps(double steps);
  void SetCoincidenceSlope(double slope);
  ///@}

  /**
   * Set whether lights are assigned to clusters of the view, which takes less time with many lights. The picture is the
   * same. The default is false.
   */
  void SetClusteredLights(bool clustered);

  /**
   * ParaView's limit of peels has no effect on this view: it would leave layers out beside volumes.
   */
  void SetMaximumNumberOfPeels(int peels) override;

  /**
   * Get why the last frame was not drawn exactly in this process. The string is empty if it was. It is valid until the
   * next call.
   */
  const char* GetFallbackReason();

  ///@{
  /**
   * Get figures of the last frame in this process: translucent fragments, and the most of them in a pixel.
   */
  vtkIdType GetNumberOfFragments();
  vtkIdType GetMaximumNumberOfLayers();
  ///@}

protected:
  vtkVitrineRenderView();
  ~vtkVitrineRenderView() override;

  void AboutToRenderOnLocalProcess(bool interactive) override;

private:
  vtkVitrineRenderView(const vtkVitrineRenderView&) = delete;
  void operator=(const vtkVitrineRenderView&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
