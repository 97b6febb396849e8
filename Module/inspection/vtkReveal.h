/**
 * @class   vtkReveal
 * @brief   fades what stands in front of a part, as little as it takes for the part to show
 *
 * A part shall show: in each of its pixels, at least a share of its light passes what is in front. The class finds the
 * opacities of the parts in front with which this holds and as much as possible of them remains, and sets them. Opaque
 * parts in front become translucent.
 *
 * @code
 * window->Render();
 * vtkNew<vtkReveal> reveal;
 * reveal->SetRenderer(renderer);
 * reveal->AddPart(gear);
 * reveal->SetShare(0.7);
 * if (reveal->Update())
 * {
 *   window->Render();
 * }
 * @endcode
 *
 * What is in front comes from the layers of the part's pixels, which are captured anew (vtkLayerPicker). The opacities
 * follow from a concave programme: the context is the sum over all parts in front of their opacity by their area on the
 * screen, which is half of that of their faces, and at most that of their box. Multipliers prove how near to the
 * optimum an answer is: GetProvedShare(). The share holds for exact methods of transparency with accurate nodes;
 * methods that round opacities to 1/255 miss it by that.
 *
 * Parts that would have less than LeastOpacity are hidden. When parts are no more in front, with PutBack(), and when
 * the renderer is deleted, they get the looks that they had. What was set meanwhile by others stays: another property,
 * or values of the copy of a property that a faded actor shows. At most one reveal fades the parts of a renderer at a
 * time. Those of several renderers may fade the same part, which then has the least of their opacities.
 *
 * With FollowCamera, opacities follow the camera before each frame. Then they change by ChangePerDegree at most for
 * each degree by which the eye turns around the part. The share takes precedence over that: parts that are newly in
 * front drop at once, and so do as few others as possible where parts come together in front of a pixel. They are
 * counted. Parts that may come together soon keep less opacity, which makes such drops rare; the context is smaller
 * then.
 *
 * @sa
 * vtkLayerPicker vtkPartOutlines vtkSeeThroughPass
 */
#ifndef vtkReveal_h
#define vtkReveal_h

#include "vtkObject.h"
#include "vtkVitrineRenderingModule.h" // for the export macro

#include <memory> // for the internals
#include <string> // for messages

class vtkPartOutlines;
class vtkProp;
class vtkRenderer;

class VTKVITRINERENDERING_EXPORT vtkReveal : public vtkObject
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkReveal* New();
  vtkTypeMacro(vtkReveal, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Set/Get the renderer. It is not kept alive. The default is null.
   */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /**
   * Add a part that shall show, or remove all. A part is a prop, or a block of a prop whose mapper draws composite
   * data, by its flat index. Block 0 stands for all blocks of a prop. Parts that shall show do not hide each other.
   */
  void AddPart(vtkProp* prop, unsigned int block = 0);
  void RemoveAllParts();
  ///@}

  ///@{
  /**
   * Set/Get the least share of the part's light that passes what is in front, in each of its pixels. The range is 0.01
   * to 1; with 1, all that is in front is hidden. The default is 0.7.
   */
  void SetShare(double share);
  vtkGetMacro(Share, double);
  ///@}

  ///@{
  /**
   * Set/Get the opacity below which parts in front are hidden. The range is 0 to 1. The default is 1/255.
   */
  void SetLeastOpacity(double opacity);
  vtkGetMacro(LeastOpacity, double);
  ///@}

  ///@{
  /**
   * Set/Get the share of its opacity below which a part in front is cut away along the view, in place of being faded.
   * It gets a hole around the parts that shall show, with caps, and keeps its opacity around that. A vtkSection cuts
   * the hole, of which a renderer can have one. Only actors can be cut. The range is 0 to 1. The default is 0: none is
   * cut.
   */
  void SetCutawayOpacity(double opacity);
  vtkGetMacro(CutawayOpacity, double);
  ///@}

  ///@{
  /**
   * Set/Get whether a part in front counts for as much as its area in the picture, or all count alike. By area, many
   * small parts vanish so that large ones keep more. The default is true.
   */
  void SetWeightByArea(bool byArea);
  vtkGetMacro(WeightByArea, bool);
  vtkBooleanMacro(WeightByArea, bool);
  ///@}

  ///@{
  /**
   * Set/Get by how much opacities may change for each degree, where the camera is followed. The range is 0 to 1. The
   * default is 0.05.
   */
  void SetChangePerDegree(double change);
  vtkGetMacro(ChangePerDegree, double);
  ///@}

  ///@{
  /**
   * Set/Get whether opacities follow the camera before each frame. What the renderer shows and the size of the viewport
   * are followed too: where these change, opacities change at once. The default is false.
   */
  void SetFollowCamera(bool follow);
  vtkGetMacro(FollowCamera, bool);
  vtkBooleanMacro(FollowCamera, bool);
  ///@}

  ///@{
  /**
   * Set/Get an object that draws outlines of the faded parts, or null. The reveal attaches it to the renderer and
   * chooses its parts. Colour, width and opacity are the object's. Hidden parts have outlines, too. Over the parts that
   * shall show there are none, so the share holds. The default is null.
   */
  void SetOutlines(vtkPartOutlines* outlines);
  vtkPartOutlines* GetOutlines();
  ///@}

  /**
   * Set the opacities that are the best for the camera as it is, at once. Returns false, with a reason in GetProblem(),
   * if it cannot; then nothing is faded. The renderer has drawn a frame before. The next frame shows the opacities.
   */
  bool Update();

  /**
   * The same within the limits of change since the last Update() or Follow(). FollowCamera calls it before each frame.
   */
  bool Follow();

  /**
   * Put back all looks that were changed, and stop following the camera.
   */
  void PutBack();

  /**
   * Get why the last update failed. The string is empty if it did not.
   */
  std::string GetProblem();

  ///@{
  /**
   * Get the parts that are faded: how many, and for each its prop, the flat index of its block, the opacity that it has
   * now and the one that it had. An opacity of 0 means that it is hidden. The prop is null out of range.
   */
  int GetNumberOfFadedParts();
  vtkProp* GetFadedProp(int i);
  unsigned int GetFadedBlock(int i);
  double GetFadedOpacity(int i);
  double GetOriginalOpacity(int i);
  ///@}

  ///@{
  /**
   * Get the parts that are cut away: how many, and for each its prop and the flat index of its block. They are not
   * among the faded ones. The prop is null out of range.
   */
  int GetNumberOfCutParts();
  vtkProp* GetCutProp(int i);
  unsigned int GetCutBlock(int i);
  ///@}

  ///@{
  /**
   * Get what the last update found: the number of pixels of the part, of parts in front, of pixels' different stacks,
   * and the largest number of layers in front.
   */
  vtkIdType GetNumberOfPixels();
  vtkIdType GetNumberOfPartsInFront();
  vtkIdType GetNumberOfStacks();
  vtkIdType GetNumberOfLayersInFront();
  ///@}

  /**
   * Get the least share of the part's light that passes what is in front, over all of its pixels.
   */
  double GetLeastShare();

  /**
   * Get the mean opacity of the parts in front, weighted by their areas on the screen unless they count alike. Hidden
   * parts count as 0. Parts that are cut away do not count.
   */
  double GetContext();

  /**
   * Get the share of the best context within the limits that is proved to be reached, 0 to 1. It is that of the
   * opacities before faint parts were hidden.
   */
  double GetProvedShare();

  ///@{
  /**
   * Get what the last update changed: the number of parts that are newly in front, of these that dropped by more than
   * the limit of change, of other parts that had to, and the largest change of all others.
   */
  vtkIdType GetNumberOfPartsNewlyInFront();
  vtkIdType GetNumberOfDroppedParts();
  vtkIdType GetNumberOfForcedParts();
  double GetLargestChange();
  ///@}

  /**
   * Release what the object holds in the context of its window.
   */
  void ReleaseGraphicsResources();

protected:
  vtkReveal();
  ~vtkReveal() override;

  double Share = 0.7;
  double LeastOpacity = 1.0 / 255.0;
  double CutawayOpacity = 0.0;
  bool WeightByArea = true;
  double ChangePerDegree = 0.05;
  bool FollowCamera = false;

private:
  vtkReveal(const vtkReveal&) = delete;
  void operator=(const vtkReveal&) = delete;

  bool UpdateWithin(double degrees);
  std::string FindOpacities(double degrees);
  void BeforeFrame();
  void AfterFrame();
  void WhenRendererIsDeleted();

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
