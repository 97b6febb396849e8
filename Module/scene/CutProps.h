/** Props of which a section may remove a piece, which hide less than their geometry tells, and the caps of sections. */
#ifndef VITRINE_SCENE_CUT_PROPS_H
#define VITRINE_SCENE_CUT_PROPS_H

class vtkProp;

namespace vitrine
{

/** Mark a prop while a frame is drawn in which pieces of it may be missing, or take the mark away. */
void MarkAsCut(vtkProp* prop, bool isCut);

/** Returns true if the prop is marked. */
bool IsMarkedAsCut(vtkProp* prop);

/** Mark a prop as a cap of a section, for good. */
void MarkAsCap(vtkProp* prop);

/** Returns true if the prop is a cap of a section. It shows other props' parts and is no part itself. */
bool IsCap(vtkProp* prop);

}

#endif
