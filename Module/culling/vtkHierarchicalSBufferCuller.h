/**
 * @class   vtkHierarchicalSBufferCuller
 * @brief   occlusion culler, which never changes a pixel
 *
 * The culler leaves out props that other props hide, and props outside of the view. So it replaces VTK's own culler,
 * which does less and takes longer:
 *
 * @code
 * vtkNew<vtkHierarchicalSBufferCuller> culler;
 * renderer->GetCullers()->RemoveAllItems();
 * renderer->AddCuller(culler);
 * @endcode
 *
 * The culler walks an octree of the props' bounding boxes from front to back. It leaves out each box that is outside
 * of the view or entirely behind occluders drawn before it. The occluders' depths are kept in an s-buffer. One line
 * of the s-buffer stands for all pixels in it. A place counts as covered only if an occluder surely covers all
 * samples there.
 *
 * Opaque surfaces drawn by vtkPolyDataMapper are occluders. Actors of that mapper are culled. Blocks of
 * vtkCulledCompositePolyDataMapper and runs of vtkCulledPolyDataMapper are culled one by one. Blocks of VTK's own
 * composite mapper hide others one by one, and are left out together. All other props are drawn as always.
 * GetCullingMode() and GetReason() tell what keeps the culler from leaving out all hidden props. GetReason(prop) tells
 * why a prop is drawn. docs/reference/culler-limits.md lists all reasons.
 *
 * Parts that hide too little to be worth their time, such as screws and cables, can be marked by NON_OCCLUDING(). The
 * order of actors does not change. Culled actors build no buffers until they are visible.
 *
 * Sources: A. V. Boreskov, hierarchical s-buffer; N. Greene, M. Kass, G. Miller: Hierarchical Z-buffer visibility,
 * SIGGRAPH 1993.
 *
 * @sa
 * vtkCulledCompositePolyDataMapper vtkCulledPolyDataMapper vtkFrustumCoverageCuller
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
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkHierarchicalSBufferCuller* New();
  vtkTypeMacro(vtkHierarchicalSBufferCuller, vtkCuller);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Get/Set whether hidden props and props outside of the view are left out. If off, all visible props are drawn. The
   * default is on.
   */
  vtkSetMacro(Culling, bool);
  vtkGetMacro(Culling, bool);
  vtkBooleanMacro(Culling, bool);
  ///@}

  ///@{
  /**
   * Get/Set the maximum number of lines of the s-buffer. A viewport with fewer rows of pixels has one line for each
   * row, or several lines if pixels have several samples. More lines hide more and take longer. They pay off where
   * there are many parts. 0 means 270 lines, 540 lines from 16,384 parts on, and 1,080 lines from 32,768 parts on,
   * but fewer lines in very wide viewports. The range is 0 to 4096, the default is 0. A value out of range is an
   * error.
   */
  void SetBufferLines(int lines);
  vtkGetMacro(BufferLines, int);
  ///@}

  /**
   * A key of props. A prop whose value is not 0 is culled as usual but is no occluder. The key is read in each frame.
   * Each prop needs an information object of its own, since render passes write there:
   *
   * @code
   * vtkNew<vtkInformation> keys;
   * keys->Set(vtkHierarchicalSBufferCuller::NON_OCCLUDING(), 1);
   * screw->SetPropertyKeys(keys);
   * @endcode
   */
  static vtkInformationIntegerKey* NON_OCCLUDING();

  /**
   * Declare that render passes of a class, which derives from a class of VTK or of this module, draw as their base
   * class does: they use its depth test, draw only what the camera sees, and draw into pixels no larger than the
   * window's. Nothing is left out below passes of other unknown classes. A null name is an error.
   */
  void AddKnownPass(const char* className);

  /** The modes of culling a frame. Each mode leaves out more than the modes before it. */
  enum CullingModeType
  {
    /** Nothing is left out. */
    OFF,
    /** Only parts outside of the view are left out. */
    VIEW_ONLY,
    /** Hidden parts are left out too, unless they may be visible through a blended prop. */
    AROUND_BLENDED,
    /** All parts that are hidden or outside of the view are left out. */
    OCCLUSION
  };

  /**
   * Get the mode of the last frame, one of CullingModeType. If the culler serves several renderers, this is the mode
   * of the renderer drawn last. The mode is OFF before the first frame and in frames without visible props.
   */
  int GetCullingMode();

  /**
   * Get the name of the mode of the last frame: "off", "view only", "around blended" or "occlusion".
   */
  const char* GetCullingModeAsString();

  /**
   * Get the reason why the mode of the last frame was not OCCLUSION. The string is empty if it was. The culler owns
   * the string, which is valid until the next frame.
   */
  const char* GetReason();

  /**
   * Get the reason why a prop was drawn or left out in the last frame. It is one of these texts:
   * - "visible", or "visible; hides nothing: " and the reason why the prop is no occluder,
   * - "left out: hidden by others" or "left out: outside of the view",
   * - "always drawn: ", "drawn: ", "drawn, as " or "not drawn: ", and the reason.
   *
   * Each call computes the reason anew. The culler owns the string, which is valid until the next call.
   */
  const char* GetReason(vtkProp* prop);

  /**
   * Get all reasons as tables in Markdown: the condition, the effect on the culler, and the explanation.
   */
  static std::string DescribeLimits();

  /**
   * Get the number of lines of the s-buffer in the last frame. All statistics of this class are of the renderer and
   * the eye drawn last, and are 0 in frames without visible props.
   */
  vtkGetMacro(NumberOfBufferLines, int);

  /**
   * Get the number of props that were left to be drawn in the last frame.
   */
  vtkGetMacro(NumberOfDrawnProps, int);

  /**
   * Get the number of parts that were left to be drawn in the last frame. Blocks of vtkCulledCompositePolyDataMapper
   * and runs of vtkCulledPolyDataMapper are parts. Any other prop is one part, and so is every prop if nothing is
   * culled.
   */
  vtkGetMacro(NumberOfDrawnParts, int);

  /**
   * Get the number of parts that were tested in the last frame. From 2,048 parts on, the screen is culled in four
   * bands of lines in parallel. A part that lies in several bands counts once in each of them, here and in the
   * statistics of nodes, occluders, spans and comparisons.
   */
  vtkGetMacro(NumberOfTestedParts, int);

  /**
   * Get the number of parts that were left out of the last frame. Each part counts once.
   */
  vtkGetMacro(NumberOfCulledParts, int);

  /**
   * Get the number of octree nodes that were tested in the last frame.
   */
  vtkGetMacro(NumberOfTestedNodes, int);

  /**
   * Get the number of parts that were inserted into the s-buffer in the last frame.
   */
  vtkGetMacro(NumberOfOccluders, int);

  /**
   * Get the number of spans that were inserted into the s-buffer in the last frame.
   */
  vtkGetMacro(NumberOfSpans, vtkTypeInt64);

  /**
   * Get the number of depth comparisons that inserting the spans took in the last frame.
   */
  vtkGetMacro(NumberOfComparisons, vtkTypeInt64);

  /**
   * Get the time that the culler took in the last frame, in seconds.
   */
  vtkGetMacro(CullTime, double);

  /**
   * Get the s-buffer of a renderer at the end of its last frame, in stereo of its last eye. The image has one float,
   * "ReversedDepth", for each column and line, with the bottom line first. The value is 0 where no occluder surely
   * covers the whole place. Elsewhere it is 1 minus the greatest window depth that a z-buffer may hold there. Returns
   * null if there was no frame, or if its mode was OFF or VIEW_ONLY.
   *
   * Each call makes a new image, which the culler holds until the next call for the same renderer.
   */
  vtkImageData* GetBufferImage(vtkRenderer* renderer);

  /**
   * Remove the hidden props from the list and update the statistics. The renderer calls this method once per frame and
   * eye. Returns the sum of the render time multipliers of all props, including those left out.
   */
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
