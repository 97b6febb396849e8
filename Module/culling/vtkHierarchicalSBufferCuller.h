/**
 * @class   vtkHierarchicalSBufferCuller
 * @brief   leaves out the actors that others hide, without changing a pixel
 *
 * Added to a renderer like any other culler. It leaves out what lies outside of the view, too, so that VTK's own need not
 * stand before it, which takes longer:
 *
 *     vtkNew<vtkHierarchicalSBufferCuller> culler;
 *     renderer->GetCullers()->RemoveAllItems();
 *     renderer->AddCuller(culler);
 *
 * An octree of the actors' bounding boxes is walked from front to back. What lies outside of the view or wholly behind what is
 * drawn in front is left out of the frame. Cover is kept in an s-buffer; a line stands for all
 * pixels in it, and counts as covered only where an occluder surely covers all of their samples.
 *
 * What hides: opaque surfaces that vtkPolyDataMapper draws from triangles and convex polygons, with no shader code of the user's, no
 * clipping planes, no texture but one of plain colours. What is hidden: all actors of that mapper. Blocks of
 * vtkCulledCompositePolyDataMapper and pieces of vtkCulledPolyDataMapper hide and are hidden one by one. Everything else is left to
 * the renderer as it is: 2D actors, volumes, assemblies, followers, levels of detail, mappers of other classes, actors in
 * coordinates of the room or the device, geometry that is not finite.
 *
 * While a selector renders, only what lies outside of the view is left out. In a view of a camera of another class, while stereo
 * rendering is being switched, with UseShadowsOn(), below a pass that may look beyond the view (vtkEDLShading, blurs) or is of a class that is not known, derived ones included, and where
 * passes draw no opaque parts, nothing is, nor in frames in which drawing makes images of textures. Wireframes are left out only outside of the view, and so is everything in windows that smooth lines, points or polygons, and with ambient
 * occlusion (UseSSAOOn()).
 * Where something is on the screen that VTK blends among what is opaque (ForceOpaqueOn()), all parts are drawn.
 *
 * What hides too little to be worth its time, screws and cables, can be marked by NON_OCCLUDING(). The picture is the same.
 *
 * The order of actors does not change. Culled actors build no buffers until they show.
 *
 * A. V. Boreskov: hierarchical s-buffer; N. Greene, M. Kass, G. Miller: Hierarchical Z-buffer visibility, SIGGRAPH 1993.
 */
#ifndef vtkHierarchicalSBufferCuller_h
#define vtkHierarchicalSBufferCuller_h

#include "vtkCuller.h"
#include "vtkVitrineRenderingModule.h" // for the export macro

#include <memory> // for std::unique_ptr

class vtkImageData;
class vtkInformationIntegerKey;

class VTKVITRINERENDERING_EXPORT vtkHierarchicalSBufferCuller : public vtkCuller
{
public:
  static vtkHierarchicalSBufferCuller* New();
  vtkTypeMacro(vtkHierarchicalSBufferCuller, vtkCuller);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Whether anything is left out. On by default. */
  vtkSetMacro(Culling, bool);
  vtkGetMacro(Culling, bool);
  vtkBooleanMacro(Culling, bool);
  ///@}

  ///@{
  /**
   * How many lines the s-buffer has at most, up to 4096. A viewport of fewer pixels has a line for each, or several if pixels have several samples. More lines hide more, and take longer: they pay
   * where there are many parts. So 0, the default, stands for 270 lines, 540 from 16,384 parts on, and 1,080 from twice as many on.
   */
  vtkSetClampMacro(BufferLines, int, 0, 4096);
  vtkGetMacro(BufferLines, int);
  ///@}

  /**
   * A key of props: those with a value other than 0 are culled like others, but hide nothing. It is asked for in each frame. Each
   * prop needs keys of its own, since passes write there:
   *
   *     vtkNew<vtkInformation> keys;
   *     keys->Set(vtkHierarchicalSBufferCuller::NON_OCCLUDING(), 1);
   *     screw->SetPropertyKeys(keys);
   */
  static vtkInformationIntegerKey* NON_OCCLUDING();

  /**
   * Says that passes of a class, which is derived from one of VTK's or Vitrine's, draw what that one draws: with its depth test, no more than the camera sees, and into pixels no larger than the window's. Below passes of
   * other classes than theirs that are not known nothing is left out.
   */
  void AddKnownPass(const char* className);

  /** What may be left out of a frame: each mode leaves out more than the ones before it. */
  enum CullingModes
  {
    OFF,       ///< Nothing is left out.
    VIEW_ONLY, ///< Only what lies outside of the view is left out.
    AROUND_BLENDED, ///< What is hidden is left out, too, unless it may shine through a prop that VTK blends.
    OCCLUSION ///< All that lies outside of the view or is hidden is left out.
  };

  ///@{
  /**
   * Get what was left out of the last frame: one of CullingModes, or its name, as "view only". Where the culler serves several
   * renderers, it is that of the renderer that was drawn last. OFF before the first frame, and in frames without visible props.
   */
  int GetCullingMode();
  const char* GetCullingModeAsString();
  ///@}

  /**
   * Get why the mode of the last frame was not OCCLUSION. Empty if it was. The string is the culler's, and is good until the
   * next frame. docs/culling.md lists all reasons.
   */
  const char* GetReason();

  /**
   * Get why a prop was drawn in the last frame, or that it was left out: "visible", "left out: hidden by others",
   * "left out: outside of the view", or a text that begins with "always drawn: ", "drawn: ", "drawn, as ", or "not drawn: ".
   * "visible; hides nothing: " is followed by the reason for which others are not hidden by it. It is found out when it is asked
   * for; the string is the culler's, and is good until the next call.
   */
  const char* GetReason(vtkProp* prop);

  ///@{
  /**
   * Of the last frame, or of its last renderer or eye: lines of the s-buffer; props that were left to be drawn, and the parts that show of them; parts that
   * were tested, and those that were left out; nodes of the octree that were tested; parts whose cover went into the
   * s-buffer; spans that it was given, and comparisons of depths there; seconds that all of it took. From 2,048 parts on the
   * screen is culled in four bands of lines at a time: what lies in several counts in each. A prop is a part, unless
   * its mapper is vtkCulledCompositePolyDataMapper or vtkCulledPolyDataMapper; where nothing is culled each prop counts as one. In a frame without visible
   * props all of them are 0.
   */
  vtkGetMacro(NumberOfBufferLines, int);
  vtkGetMacro(NumberOfDrawnProps, int);
  vtkGetMacro(NumberOfDrawnParts, int);
  vtkGetMacro(NumberOfTestedParts, int);
  vtkGetMacro(NumberOfCulledParts, int);
  vtkGetMacro(NumberOfTestedNodes, int);
  vtkGetMacro(NumberOfOccluders, int);
  vtkGetMacro(NumberOfSpans, vtkTypeInt64);
  vtkGetMacro(NumberOfComparisons, vtkTypeInt64);
  vtkGetMacro(CullTime, double);
  ///@}

  /**
   * What a renderer's s-buffer held at the end of its last frame, of the last eye: floats named "ReversedDepth", as many as it has
   * columns and lines, the bottom line first. 0 where nothing is sure to cover all of the place; elsewhere 1 minus the greatest
   * depth that a z-buffer may hold there. Null where that frame was not culled, or by the view alone, or there was none.
   *
   * Each call makes a new image, which the culler holds until the next one.
   */
  vtkImageData* GetBufferImage(vtkRenderer* renderer);

  double Cull(
    vtkRenderer* renderer, vtkProp** propList, int& listLength, int& initialized) override;

protected:
  vtkHierarchicalSBufferCuller();
  ~vtkHierarchicalSBufferCuller() override;

  bool Culling = true;
  int BufferLines = 0;
  int NumberOfBufferLines = 0;
  int NumberOfDrawnProps = 0;
  int NumberOfDrawnParts = 0;
  int NumberOfTestedParts = 0;
  int NumberOfCulledParts = 0;
  int NumberOfTestedNodes = 0;
  int NumberOfOccluders = 0;
  vtkTypeInt64 NumberOfSpans = 0;
  vtkTypeInt64 NumberOfComparisons = 0;
  double CullTime = 0.0;

private:
  vtkHierarchicalSBufferCuller(const vtkHierarchicalSBufferCuller&) = delete;
  void operator=(const vtkHierarchicalSBufferCuller&) = delete;

  void ForgetFrame();
  void DropHidden(vtkRenderer* renderer, vtkProp** propList, int& listLength);
  void KeepShown(vtkRenderer* renderer, vtkProp** propList, int& listLength);

  struct State; // of each renderer
  std::unique_ptr<State> Renderers;
};

#endif
