/**
 * @class   vtkPartXRay
 * @brief   shows chosen parts as an x-ray does: faces towards the eye nearly vanish, and rims stay
 *
 * The opacity of a fragment of a chosen part is multiplied by floor + (1 - floor) * (1 - |n.v|)^falloff, where n is the
 * normal and v the direction to the eye. Opaque parts become translucent for it. So other passes and transparency
 * methods draw them in order with all others. Where a mapper has no normals, those of flat faces count.
 *
 * @code
 * vtkNew<vtkPartXRay> xray;
 * xray->AddPart(housing);
 * xray->Attach(renderer);
 * @endcode
 *
 * A part is an actor, or a block of an actor whose mapper draws composite data. Parts get their looks back when they
 * are removed, and when the object is detached. What others set meanwhile stays.
 *
 * @sa
 * vtkSeeThroughPass vtkPartOutlines vtkReveal
 */
#ifndef vtkPartXRay_h
#define vtkPartXRay_h

#include "vtkObject.h"
#include "vtkVitrineRenderingModule.h" // export macro

#include <memory> // for the internals

class vtkProp;
class vtkRenderer;

class VTKVITRINERENDERING_EXPORT vtkPartXRay : public vtkObject
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkPartXRay* New();
  vtkTypeMacro(vtkPartXRay, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * Returns true if parts of a prop can be added: of an actor.
   */
  static bool CanChoose(vtkProp* prop);

  ///@{
  /**
   * Add a part that is shown so, or remove all. A prop's block is given by its flat index, and stands for all blocks
   * below it, too. A negative block stands for the whole prop. Props of which CanChoose() is false are errors.
   */
  void AddPart(vtkProp* prop, int block = -1);
  void RemoveAllParts();
  ///@}

  /**
   * Get the number of parts that have been added.
   */
  int GetNumberOfParts();

  ///@{
  /**
   * Get/Set the share of its opacity that a face keeps which is turned towards the eye. The range is 0 to 1, the
   * default is 0.05.
   */
  void SetFloor(double floor);
  double GetFloor();
  ///@}

  ///@{
  /**
   * Get/Set the power of the falloff. The larger it is, the narrower are the rims. The range is 0 to 16, the default is
   * 2. With 0 all faces keep their opacity.
   */
  void SetFalloff(double falloff);
  double GetFalloff();
  ///@}

  ///@{
  /**
   * Attach to a renderer, which shows the parts so from its next frame on, or undo that. The object is attached to one
   * renderer at a time, which keeps it alive. A renderer has one x-ray at a time; an earlier one is detached.
   */
  void Attach(vtkRenderer* renderer);
  void Detach();
  ///@}

  /**
   * Get the renderer to which the object is attached, or null.
   */
  vtkRenderer* GetRenderer();

  /**
   * Get the x-ray that is attached to a renderer, or null.
   */
  static vtkPartXRay* GetAttached(vtkRenderer* renderer);

protected:
  vtkPartXRay();
  ~vtkPartXRay() override;

private:
  vtkPartXRay(const vtkPartXRay&) = delete;
  void operator=(const vtkPartXRay&) = delete;

  void WhenRendererIsDeleted();

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
