/**
 * Questions among those who change how a renderer draws its parts in a frame: which parts have to be drawn as they are,
 * and which props are hidden since others stand for them.
 */
#ifndef VITRINE_SCENE_EXACT_PARTS_H
#define VITRINE_SCENE_EXACT_PARTS_H

#include "Core/section/CutPlane.h"

#include <unordered_set>
#include <vector>

class vtkProp;
class vtkRenderer;

namespace vitrine
{

/** What has to be drawn as it is, even where fewer triangles would do. */
struct ExactParts
{
  std::vector<CutPlane> Planes;       ///< in WC: the parts that they meet
  std::unordered_set<vtkProp*> Props; ///< all of their parts, as they have looks of their own
};

/** Asks those who cut or mark parts of a renderer. */
ExactParts ExactPartsOf(vtkRenderer* renderer);

/** The event of ExactPartsOf(). Observers add to the ExactParts that it has. */
extern const unsigned long AskForExactParts;

/** Props that others stand for in a frame. */
struct StandIns
{
  std::unordered_set<vtkProp*> Hidden; ///< not visible in the frame, though their parts are shown
  std::unordered_set<vtkProp*> Shown;  ///< visible in the frame, and no parts themselves

  /** Returns true if the parts of a prop are seen in the frame, if only by others. */
  bool IsSeen(vtkProp* prop) const;
};

/** Asks for the stand-ins of the frame that a renderer draws. There are none between frames. */
const StandIns& StandInsOf(vtkRenderer* renderer);

/** The event of StandInsOf(). The observer sets the const StandIns* that the event has. */
extern const unsigned long AskForStandIns;

}

#endif
