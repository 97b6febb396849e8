/** Props of which a section may remove a piece. They hide less than their geometry tells. */
#ifndef VITRINE_SCENE_CUT_PROPS_H
#define VITRINE_SCENE_CUT_PROPS_H

class vtkProp;

namespace vitrine
{

/** Mark a prop while a frame is drawn in which pieces of it may be missing, or take the mark away. */
void MarkAsCut(vtkProp* prop, bool isCut);

/** Returns true if the prop is marked. */
bool IsMarkedAsCut(vtkProp* prop);

}

#endif
