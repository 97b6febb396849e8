/** When what a renderer shows has changed. */
#ifndef VITRINE_SCENE_SCENE_TIME_H
#define VITRINE_SCENE_SCENE_TIME_H

#include "vtkType.h"

class vtkProp;
class vtkRenderer;

namespace vitrine
{

/** Returns when a prop, its mapper or its data changed last. It updates nothing. */
vtkMTimeType NewestTimeOf(vtkProp* prop);

/**
 * Returns when the renderer's list of props, a prop, its mapper or its data changed last. Caps of sections do not
 * count. It updates no pipeline, so a change of a source shows when the data is made.
 */
vtkMTimeType NewestTimeOf(vtkRenderer* renderer);

}

#endif
