/** Finds which representations and blocks lie under a pixel of a view, from front to back. */
#ifndef VITRINE_PARAVIEW_LAYERS_UNDER_PIXEL_H
#define VITRINE_PARAVIEW_LAYERS_UNDER_PIXEL_H

#include "FrameAnswers.h"

#include "vtkLayerPicker.h"
#include "vtkNew.h"
#include "vtkProp.h"
#include "vtkWeakPointer.h"

#include <array>
#include <map>
#include <string>

class vtkMultiProcessController;
class vtkPVDataRepresentation;
class vtkRenderer;

namespace vitrine
{

class LayersUnderPixel
{
public:
  std::array<int, 2> Pixel{ -1, -1 }; ///< from the lower left corner; negative for none

  /** Notes that a representation has added the props of the renderer that are new. */
  void Note(vtkPVDataRepresentation* representation, vtkRenderer* renderer);

  /** Returns the unique identifier of the representation that shows a prop, or 0. */
  unsigned int RepresentationOf(vtkProp* prop) const;

  /**
   * Fills in the layers of the last frame, or the reason why they cannot be told. With several `ranks` all call this.
   * Those of other ranks have no names then.
   */
  void Find(vtkRenderer* renderer, vtkMultiProcessController* ranks, FrameAnswers& answers);

private:
  struct Shown
  {
    vtkWeakPointer<vtkProp>
      Prop; ///< a prop that is gone may have its address in common with a new one
    unsigned int Representation = 0;
  };

  std::map<vtkProp*, Shown> Props;
  vtkNew<vtkLayerPicker> Picker;
};

/** Returns the name that the source of a representation has in the client's pipeline. It is empty if it has none. */
std::string NameOfSource(vtkPVDataRepresentation* representation);

}

#endif
