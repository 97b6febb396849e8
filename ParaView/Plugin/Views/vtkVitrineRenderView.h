/**
 * @class   vtkVitrineRenderView
 * @brief   ParaView's render view, with exact transparency
 *
 * The view draws what vtkPVRenderView draws, by a vtkSeeThroughPass. Opaque geometry, volumes, annotations and
 * selections are as in ParaView's own view. Where ParaView peels volumes and translucent geometry together, it peels
 * until nothing is left. Ray tracing draws without this view's pass.
 *
 * The planes and the box of a section cut what the view shows. Each frame tells which sources and blocks lie under a
 * pixel. A server that draws sends its answers to its client with the picture.
 *
 * Several ranks of a server or of pvbatch draw a frame together, by a vtkDistributedTransparencyPass in place of the
 * view's method and of ParaView's compositing. No geometry is moved. The layers under a pixel are those of all ranks.
 * Caps of a section are drawn on parts that are whole on one rank. With volumes, on tiled displays and in a CAVE ranks
 * draw as ParaView does, and tell why.
 *
 * @sa
 * vtkSeeThroughPass vtkDistributedTransparencyPass vtkSection vtkLayerPicker
 */
#ifndef vtkVitrineRenderView_h
#define vtkVitrineRenderView_h

#include "vtkPVRenderView.h"
#include "vtkVitrineParaViewViewsModule.h" // export macro

#include <memory> // for the view's internals
#include <string> // for names

class vtkDoubleArray;
class vtkStringArray;

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
   * "linked-list". Another name is an error and is ignored. Several ranks have a method of their own.
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

  ///@{
  /**
   * Set whether a vtkHierarchicalSBufferCuller leaves out what others hide. The picture is the same. The default is
   * false. Get why it left out less than all of that in the last frame, and how many parts it left out.
   */
  void SetCulling(bool culls);
  const char* GetCullingReason();
  vtkIdType GetNumberOfCulledParts();
  ///@}

  ///@{
  /**
   * Set whether the view is cut by the plane through `origin`, which keeps the side of the normal, and by further
   * planes, six in all. The defaults are false, the origin, and the x axis; a normal need not have length 1. See
   * vtkSection.
   */
  void SetSectionPlane(bool cuts);
  void SetSectionOrigin(double x, double y, double z);
  void SetSectionNormal(double x, double y, double z);
  void AddSectionPlane(
    double originX, double originY, double originZ, double normalX, double normalY, double normalZ);
  void RemoveSectionPlanes();
  ///@}

  ///@{
  /**
   * Set whether a box cuts: 0 for none, which is the default, 1 to keep what lies inside, 2 to remove it. Its bounds
   * are xmin, xmax, ymin, ymax, zmin, zmax in world coordinates, and 0 to 1 by default.
   */
  void SetSectionBox(int box);
  void SetSectionBounds(
    double xmin, double xmax, double ymin, double ymax, double zmin, double zmax);
  ///@}

  ///@{
  /**
   * Set how cuts look, as vtkSection does: whether planes remove only what lies beyond all of them (false), caps
   * (true), stripes where parts interfere (true), the hatch (vtkSection::NO_HATCH), the distance of its lines (0, which
   * means automatic), and the width of edges in pixels (1).
   */
  void SetSectionRemoveBeyondAll(bool all);
  void SetSectionCaps(bool caps);
  void SetSectionInterference(bool stripes);
  void SetSectionHatch(int hatch);
  void SetSectionHatchSpacing(double spacing);
  void SetSectionEdgeWidth(int width);
  ///@}

  /**
   * Set the pixel whose layers each frame tells, from the lower left corner. The default is -1, -1, which means none.
   */
  void SetLayersPixel(int x, int y);

  ///@{
  /**
   * Get the layers of the pixel in the last frame, from front to back down to the nearest opaque one: the names of the
   * sources in the client's pipeline, the names of blocks with slashes between, the depths in the window in [0, 1], the
   * distances along the ray, and the shares of the picture in [0, 1]. The arrays are the view's until the next call.
   */
  vtkStringArray* GetLayerSources();
  vtkStringArray* GetLayerBlocks();
  vtkDoubleArray* GetLayerDepths();
  vtkDoubleArray* GetLayerDistances();
  vtkDoubleArray* GetLayerShares();
  ///@}

  /**
   * Get why the layers cannot be told. The string is empty if they are, or if no pixel is set. It is valid until the
   * next frame.
   */
  const char* GetLayersProblem();

  /**
   * ParaView's limit of peels has no effect on this view: it would leave layers out beside volumes.
   */
  void SetMaximumNumberOfPeels(int peels) override;

  /**
   * Capture the depths of the last frame for GetCapturedZBuffer(), in [0, 1], by rows from the bottom, as
   * vtkPVRenderView does. On several ranks they are those of the opaque geometry of all.
   */
  void CaptureZBuffer();

  /**
   * Set how a server compresses pictures for its client, as vtkPVRenderView does.
   */
  void ConfigureCompressor(const char* configuration);

  /**
   * Get why the last frame was not drawn exactly, also where a server drew it. The string is empty if it was. It is
   * valid until the next frame.
   */
  const char* GetFallbackReason();

  ///@{
  /**
   * Get figures of the last frame, also where a server drew it: translucent fragments, and the most of them in a pixel.
   */
  vtkIdType GetNumberOfFragments();
  vtkIdType GetMaximumNumberOfLayers();
  ///@}

protected:
  vtkVitrineRenderView();
  ~vtkVitrineRenderView() override;

  void AddRepresentationInternal(vtkDataRepresentation* representation) override;
  void AboutToRenderOnLocalProcess(bool interactive) override;
  void Render(bool interactive, bool skipRendering) override;

private:
  vtkVitrineRenderView(const vtkVitrineRenderView&) = delete;
  void operator=(const vtkVitrineRenderView&) = delete;

  bool IsDistributed(bool interactive);
  std::string FindHindranceOfRanks(bool interactive);
  void RenderTogether(bool interactive);
  void RenderInNoOrder(bool interactive, bool skipRendering);
  void UpdateSection();
  std::string NameOfSource(unsigned int representation);

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
