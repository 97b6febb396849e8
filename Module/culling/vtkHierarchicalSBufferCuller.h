/**
 * @class   vtkHierarchicalSBufferCuller
 * @brief   leaves out the actors that others hide, without changing a pixel
 *
 * It is added to a renderer like any other culler. It leaves out what lies outside of the view, too, so that VTK's own
 * need not stand before it, which takes longer:
 *
 *     vtkNew<vtkHierarchicalSBufferCuller> culler;
 *     renderer->GetCullers()->RemoveAllItems();
 *     renderer->AddCuller(culler);
 *
 * An octree of the actors' bounding boxes is walked from front to back. What lies outside of the view or wholly behind
 * what is drawn in front is left out of the frame. Cover is kept in an s-buffer. A line of it stands for all pixels in
 * it, and counts as covered only where an occluder surely covers all of their samples.
 *
 * Opaque surfaces that vtkPolyDataMapper draws hide others. Actors of that mapper are hidden, and so are blocks of
 * vtkCulledCompositePolyDataMapper and pieces of vtkCulledPolyDataMapper, one by one. All other props are drawn as
 * always. GetCullingMode() and GetReason() tell what keeps the culler from leaving out all that is hidden, and
 * GetReason(prop) why a prop is drawn. docs/culling.md lists all that they may tell.
 *
 * What hides too little to be worth its time, screws and cables, can be marked by NON_OCCLUDING(). The picture is the
 * same. The order of actors does not change. Culled actors build no buffers until they show.
 *
 * A. V. Boreskov: hierarchical s-buffer; N. Greene, M. Kass, G. Miller: Hierarchical Z-buffer visibility, SIGGRAPH
 * 1993.
 */
#ifndef vtkHierarchicalSBufferCuller_h
#define vtkHierarchicalSBufferCuller_h

#include "vtkCuller.h"
#include "vtkVitrineRenderingModule.h" // for the export macro

#include <memory> // for std::unique_ptr
#include <string> // for texts

class vtkImageData;
class vtkInformationIntegerKey;

class VTKVITRINERENDERING_EXPORT vtkHierarchicalSBufferCuller : public vtkCuller
{
public:
  static vtkHierarchicalSBufferCuller* New();
  vtkTypeMacro(vtkHierarchicalSBufferCuller, vtkCuller);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Set/Get whether anything is left out. Default is on. */
  vtkSetMacro(Culling, bool);
  vtkGetMacro(Culling, bool);
  vtkBooleanMacro(Culling, bool);
  ///@}

  ///@{
  /**
   * Set/Get how many lines the s-buffer has at most, 0 to 4096. A viewport of fewer pixels has a line for each, or
   * several if pixels have several samples. More lines hide more, and take longer: they pay where there are many parts.
   * Default is 0, which stands for 270 lines, 540 from 16,384 parts on, and 1,080 from twice as many on.
   */
  vtkSetClampMacro(BufferLines, int, 0, 4096);
  vtkGetMacro(BufferLines, int);
  ///@}

  /**
   * A key of props: those with a value other than 0 are culled like others, but hide nothing. It is asked for in each
   * frame. Each prop needs keys of its own, since passes write there:
   *
   *     vtkNew<vtkInformation> keys;
   *     keys->Set(vtkHierarchicalSBufferCuller::NON_OCCLUDING(), 1);
   *     screw->SetPropertyKeys(keys);
   */
  static vtkInformationIntegerKey* NON_OCCLUDING();

  /**
   * Say that passes of a class, which is derived from one of VTK's or Vitrine's, draw what that one draws: with its
   * depth test, no more than the camera sees, and into pixels no larger than the window's. Nothing is left out below
   * passes of other classes that are not known.
   */
  void AddKnownPass(const char* className);

  /** What may be left out of a frame: each mode leaves out more than the ones before it. */
  enum CullingModes
  {
    OFF,       ///< Nothing is left out.
    VIEW_ONLY, ///< Only what lies outside of the view is left out.
    AROUND_BLENDED, ///< Hidden parts are left out, too, unless they may shine through a prop that is blended.
    OCCLUSION ///< All that lies outside of the view or is hidden is left out.
  };

  ///@{
  /**
   * Get what was left out of the last frame: one of CullingModes, or its name, as "view only". Where the culler serves
   * several renderers, it is that of the renderer that was drawn last. OFF before the first frame, and in frames
   * without visible props.
   */
  int GetCullingMode();
  const char* GetCullingModeAsString();
  ///@}

  /**
   * Get why the mode of the last frame was not OCCLUSION. Empty if it was. The string is the culler's, and is good
   * until the next frame.
   */
  const char* GetReason();

  /**
   * Get why a prop was drawn in the last frame, or that it was left out: "visible", "left out: hidden by others", "left
   * out: outside of the view", or a text that begins with "always drawn: ", "drawn: ", "drawn, as ", or "not drawn: ".
   * "visible; hides nothing: " is followed by the reason for which others are not hidden by it. It is found out when it
   * is asked for. The string is the culler's, and is good until the next call.
   */
  const char* GetReason(vtkProp* prop);

  /** Get all reasons as tables of Markdown: where each applies, what it has the culler do, and why. */
  static std::string DescribeLimits();

  /**
   * Get how many lines the s-buffer of the last frame had. As all counts below it is that of the last renderer, or eye;
   * it is 0 in frames without visible props.
   */
  vtkGetMacro(NumberOfBufferLines, int);

  /** Get how many props were left to be drawn. */
  vtkGetMacro(NumberOfDrawnProps, int);

  /**
   * Get how many parts of them were left. A prop is one part, unless its mapper is vtkCulledCompositePolyDataMapper or
   * vtkCulledPolyDataMapper, and unless nothing is culled.
   */
  vtkGetMacro(NumberOfDrawnParts, int);

  /**
   * Get how many parts were tested. From 2,048 parts on the screen is culled in four bands of lines at a time: what
   * lies in several counts in each, as it does in the counts below.
   */
  vtkGetMacro(NumberOfTestedParts, int);

  /** Get how many parts were left out. Each counts once. */
  vtkGetMacro(NumberOfCulledParts, int);

  /** Get how many nodes of the octree were tested. */
  vtkGetMacro(NumberOfTestedNodes, int);

  /** Get how many parts were put into the s-buffer. */
  vtkGetMacro(NumberOfOccluders, int);

  /** Get how many spans the s-buffer was given. */
  vtkGetMacro(NumberOfSpans, vtkTypeInt64);

  /** Get how many comparisons of depths that took. */
  vtkGetMacro(NumberOfComparisons, vtkTypeInt64);

  /** Get the time that the culler took, in seconds. */
  vtkGetMacro(CullTime, double);

  /**
   * Get what a renderer's s-buffer held at the end of its last frame, of the last eye: floats named "ReversedDepth", as
   * many as it has columns and lines, the bottom line first. 0 where nothing is sure to cover all of the place;
   * elsewhere 1 minus the greatest depth that a z-buffer may hold there. Null where that frame was not culled, or by
   * the view alone, or where there was none.
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
  void CullHidden(vtkRenderer* renderer, vtkProp** propList, int& listLength);
  void KeepShown(vtkRenderer* renderer, vtkProp** propList, int& listLength);

  struct State; // of each renderer
  std::unique_ptr<State> Renderers;
};

#endif
