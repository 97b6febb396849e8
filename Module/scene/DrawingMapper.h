#ifndef VITRINE_SCENE_DRAWING_MAPPER_H
#define VITRINE_SCENE_DRAWING_MAPPER_H

class vtkActor;
class vtkDataSetMapper;
class vtkMapper;
class vtkPolyDataMapper;

namespace vitrine
{

/** Whether a mapper is of a class that draws polydata where its points are, or has such a one do so. */
bool IsKnownMapper(vtkMapper* mapper);

/** The actor's mapper if it has another one draw the surface of its data; null for all others. */
vtkDataSetMapper* SurfaceMapperOf(vtkActor* actor);

/**
 * The mapper that draws an actor of a known mapper: that one itself, or the one that a vtkDataSetMapper has for it. That one gets the other's input whenever it
 * draws, so it is null where it has another one still, as before the first frame; and where it draws one of several pieces, or each of them.
 */
vtkPolyDataMapper* DrawingMapperOf(vtkActor* actor);

}

#endif
