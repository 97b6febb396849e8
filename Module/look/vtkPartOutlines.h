/**
 * @class   vtkPartOutlines
 * @brief   draws outlines of chosen parts over a renderer's picture, through all that hides them
 *
 * After each frame of the renderer, the chosen parts are drawn once more into an image of their own. A pixel of a part
 * gets the colour of the outline if another part, or none, is within the width. The rest of a part may get a tint. So a
 * part is seen where others hide it. It works with every render pass and transparency method, and in every viewport.
 *
 * @code
 * vtkNew<vtkPartOutlines> outlines;
 * outlines->AddPart(actor);
 * outlines->SetColor(1.0, 0.6, 0.0);
 * outlines->Attach(renderer);
 * @endcode
 *
 * A part is an actor, or a block of an actor whose mapper draws composite data. Parts are drawn as their mappers draw
 * them: clipping planes and sections cut them, and hidden parts have no outline. Actors within a vtkAssembly cannot be
 * chosen. A renderer may have several of these objects. They draw in the order in which they were attached.
 *
 * Nothing is drawn while a hardware selector renders. While no chosen part is visible, a frame costs nothing.
 *
 * @sa
 * vtkReveal vtkLayerPicker vtkSection
 */
#ifndef vtkPartOutlines_h
#define vtkPartOutlines_h

#include "vtkObject.h"
#include "vtkVitrineRenderingModule.h" // export macro

#include <memory> // for the internals

class vtkProp;
class vtkRenderer;

class VTKVITRINERENDERING_EXPORT vtkPartOutlines : public vtkObject
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkPartOutlines* New();
  vtkTypeMacro(vtkPartOutlines, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * Returns true if parts of a prop can be added: of an actor, or of another vtkProp3D that draws actors.
   */
  static bool CanChoose(vtkProp* prop);

  ///@{
  /**
   * Add a part to those that have an outline, or remove all. A prop's block is given by its flat index, and stands for
   * all blocks below it, too. A negative block stands for the whole prop. Each added part has an outline of its own.
   * Props of which CanChoose() is false are errors.
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
   * Add a part over which no outline and no tint is drawn, or remove all. It is given as in AddPart().
   */
  void AddExcludedPart(vtkProp* prop, int block = -1);
  void RemoveAllExcludedParts();
  ///@}

  ///@{
  /**
   * Get/Set the colour of outlines and tints. Each number is from 0 to 1. The default is (1, 0.5, 0).
   */
  void SetColor(double red, double green, double blue);
  const double* GetColor() VTK_SIZEHINT(3);
  ///@}

  ///@{
  /**
   * Get/Set the opacity of outlines. The range is 0 to 1, the default is 1.
   */
  void SetOpacity(double opacity);
  double GetOpacity();
  ///@}

  ///@{
  /**
   * Get/Set the width of outlines in pixels. They are inside of their part. The range is 0 to 8, the default is 2.
   */
  void SetWidth(int width);
  int GetWidth();
  ///@}

  ///@{
  /**
   * Get/Set the opacity of the tint, which covers a part inside of its outline. The range is 0 to 1, the default is 0:
   * no tint.
   */
  void SetFillOpacity(double opacity);
  double GetFillOpacity();
  ///@}

  ///@{
  /**
   * Attach to a renderer, which shows the outlines from its next frame on, or undo that. The object is attached to one
   * renderer at a time, which keeps it alive.
   */
  void Attach(vtkRenderer* renderer);
  void Detach();
  ///@}

  /**
   * Get the renderer to which the object is attached, or null.
   */
  vtkRenderer* GetRenderer();

  /**
   * Get the number of bytes that are held on the device.
   */
  vtkTypeInt64 GetBytes();

  /**
   * Get the reason why the outlines of the last frame were not drawn. The string is empty if they were.
   */
  const char* GetFallbackReason();

protected:
  vtkPartOutlines();
  ~vtkPartOutlines() override;

private:
  vtkPartOutlines(const vtkPartOutlines&) = delete;
  void operator=(const vtkPartOutlines&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
