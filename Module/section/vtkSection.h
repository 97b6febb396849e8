/**
 * @class   vtkSection
 * @brief   cuts the parts of a renderer by planes, with caps
 *
 * A section removes what lies on the negative side of its planes, and fills the cuts of closed parts with caps. It
 * works with every render pass and transparency method, in every viewport, and with hardware selection. Caps have the
 * colour and the opacity of their part, or a hatch. They are drawn as other actors are, so translucent caps are in the
 * exact order of the method.
 *
 * @code
 * vtkNew<vtkPlane> plane; // keeps what lies on the side of the normal, as clipping planes of mappers do
 * vtkNew<vtkSection> section;
 * section->AddPlane(plane);
 * section->Attach(renderer);
 * @endcode
 *
 * A plane may be moved at any time. The next frame shows it. Points at distance 0 or more are kept, within the rounding
 * of coordinates, so planes may lie in faces, edges and vertices of parts.
 *
 * A part is an actor, or a block of an actor whose mapper draws composite data. A part is closed if each edge has an
 * even number of faces, after equal points are merged. The cuts of other parts are filled only where the faces towards
 * the eye and those away from it agree that the point is inside. IsCutPartClosed() tells which parts are closed. Where
 * several parts contain the same point of a plane, they interfere. The cap shows a warning pattern there, and
 * GetInterferingParts() tells the pairs.
 *
 * A section reads the geometry of the parts that its planes cut, and keeps it on the device a second time. Clipping
 * planes of mappers do not cut caps. Actors within a vtkAssembly are cut, and have no caps. Data
 * other than vtkPolyData have caps from the second frame on in which their vtkDataSetMapper draws them.
 *
 * @sa
 * vtkSeeThroughPass vtkPlane vtkMapper::AddClippingPlane()
 */
#ifndef vtkSection_h
#define vtkSection_h

#include "vtkObject.h"
#include "vtkVitrineRenderingModule.h" // export macro

#include <memory> // for the section's internals

class vtkIdList;
class vtkPlane;
class vtkProp;
class vtkRenderer;

class VTKVITRINERENDERING_EXPORT vtkSection : public vtkObject
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkSection* New();
  vtkTypeMacro(vtkSection, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * Get the largest number of planes besides the box, which is 6.
   */
  static int GetMaximumNumberOfPlanes() { return 6; }

  ///@{
  /**
   * Add or remove a plane. It cuts all parts, unless parts are chosen for it. A normal need not have length 1. A plane
   * with a normal that is 0 or has no finite numbers cuts nothing. A plane beyond the sixth, or null, is an error. The
   * order of planes stays.
   */
  bool AddPlane(vtkPlane* plane);
  void RemovePlane(vtkPlane* plane);
  void RemoveAllPlanes();
  int GetNumberOfPlanes();
  vtkPlane* GetPlane(int index);
  ///@}

  ///@{
  /**
   * Choose parts for a plane. With ONLY_CHOSEN it cuts these alone, and with ALL_BUT_CHOSEN all others. The default is
   * ALL_PARTS. A part is a prop, or one of its blocks by flat index. A negative block stands for the whole prop.
   */
  enum PartsType
  {
    ALL_PARTS,
    ONLY_CHOSEN,
    ALL_BUT_CHOSEN
  };
  void SetParts(vtkPlane* plane, int parts);
  int GetParts(vtkPlane* plane);
  void ChoosePart(vtkPlane* plane, vtkProp* prop, int block = -1);
  void ClearChosenParts(vtkPlane* plane);
  ///@}

  ///@{
  /**
   * Get/Set whether planes remove what lies beyond any of them, or only what lies beyond all of them. With the latter,
   * two planes cut out a quarter. The default is false: any plane removes.
   */
  void SetRemoveBeyondAll(bool all);
  bool GetRemoveBeyondAll();
  vtkBooleanMacro(RemoveBeyondAll, bool);
  ///@}

  ///@{
  /**
   * Set a box in world coordinates. Its faces cut as six further planes, with caps. `keepInside` tells whether it keeps
   * what lies inside, or removes it. An empty box is an error. A box that removes its inside counts among the planes of
   * RemoveBeyondAll.
   */
  void SetBox(
    double xmin, double xmax, double ymin, double ymax, double zmin, double zmax, bool keepInside);
  void RemoveBox();
  bool HasBox();
  ///@}

  ///@{
  /**
   * Set/Get bounds in world coordinates that hold all that may be cut, and no more. Roundings of planes, and the places
   * of caps and hatches, then follow from them, and not from what the renderer shows near a plane. So several ranks cut
   * alike, to the bit, with the bounds of all: vtkDistributedTransparencyPass::ComputeVisiblePropBounds(). A plane that
   * meets them moves towards what it removes, by at most 2^-21 (5e-7) of their width along its normal: in bounds of 1e6
   * units by 0.5 or less. The default is none, for which xmin > xmax stands. Other bounds that have a minimum above the
   * maximum or are not finite are an error.
   */
  void SetSceneBounds(double xmin, double xmax, double ymin, double ymax, double zmin, double zmax);
  double* GetSceneBounds() VTK_SIZEHINT(6);
  ///@}

  ///@{
  /**
   * Get/Set whether cuts are filled. The default is true.
   */
  void SetCaps(bool caps);
  bool GetCaps();
  vtkBooleanMacro(Caps, bool);
  ///@}

  ///@{
  /**
   * Get/Set the hatch of caps. The default is NO_HATCH. Lines of neighbouring parts differ in direction or distance.
   */
  enum HatchType
  {
    NO_HATCH,
    LINES,  ///< general use, cast iron (ANSI 31)
    PAIRS,  ///< steel (ANSI 32)
    DASHES, ///< bronze, brass, copper (ANSI 33)
    CROSS,  ///< plastic, rubber (ANSI 37)
    LEVEL,  ///< fluids, glass
    DOTS    ///< insulation
  };
  void SetHatch(int hatch);
  int GetHatch();
  ///@}

  /**
   * Set the hatch of the caps of a prop, or of one of its blocks by flat index, in place of the general one. A negative
   * hatch removes it. A negative block stands for the whole prop.
   */
  void SetHatchOf(vtkProp* prop, int hatch, int block = -1);

  ///@{
  /**
   * Get/Set whether caps show a warning pattern where parts interfere. Without it, such a point has the cap of one of
   * these parts. The default is true.
   */
  void SetInterferenceStripes(bool stripes);
  bool GetInterferenceStripes();
  vtkBooleanMacro(InterferenceStripes, bool);
  ///@}

  ///@{
  /**
   * Get/Set the distance of a hatch's lines, in world coordinates. The default is 0: a fortieth of the diagonal of the
   * box around the cut parts.
   */
  void SetHatchSpacing(double spacing);
  double GetHatchSpacing();
  ///@}

  ///@{
  /**
   * Get/Set the width of the lines around each cut, in pixels. They are inside of the caps. The range is 0 to 4, the
   * default is 1.
   */
  void SetEdgeWidth(int width);
  int GetEdgeWidth();
  ///@}

  ///@{
  /**
   * Get/Set the colour of edges and hatches. The default is black.
   */
  void SetEdgeColor(double red, double green, double blue);
  const double* GetEdgeColor() VTK_SIZEHINT(3);
  ///@}

  ///@{
  /**
   * Attach to a renderer, which is cut from its next frame on, or undo that. A section is attached to one renderer at a
   * time. A renderer has one section at a time; an earlier one is detached.
   */
  void Attach(vtkRenderer* renderer);
  void Detach();
  ///@}

  /**
   * Get the renderer to which the section is attached, or null.
   */
  vtkRenderer* GetRenderer();

  /**
   * Get the section that is attached to a renderer, or null.
   */
  static vtkSection* GetAttached(vtkRenderer* renderer);

  ///@{
  /**
   * Get the parts that planes cut, by the boxes of parts, as of now: the prop and the flat index of the block, or 0.
   * GetNumberOfCutParts() brings the list up to date.
   */
  int GetNumberOfCutParts();
  vtkProp* GetCutProp(int index);
  int GetCutBlock(int index);
  ///@}

  /**
   * Returns true if the part of GetCutProp(index) is closed. Otherwise its cut is filled only where that is safe.
   */
  bool IsCutPartClosed(int index);

  /**
   * Get the pairs of parts that interfere in the last frame, as indices of GetCutProp(): two for each pair. It reads
   * the pixels of the caps back, as they were when the frame was drawn, with those that others hide.
   */
  void GetInterferingParts(vtkIdList* pairs);

  /**
   * Get the number of bytes that the section holds on the device.
   */
  vtkTypeInt64 GetBytes();

  /**
   * Get the reason why the caps of the last frame were not drawn. The string is empty if they were.
   */
  const char* GetFallbackReason();

protected:
  vtkSection();
  ~vtkSection() override;

private:
  vtkSection(const vtkSection&) = delete;
  void operator=(const vtkSection&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
