/** Finds the mapper that draws an actor. */
#ifndef VITRINE_SCENE_DRAWING_MAPPER_H
#define VITRINE_SCENE_DRAWING_MAPPER_H

class vtkActor;
class vtkDataSetMapper;
class vtkMapper;
class vtkPolyDataMapper;

namespace vitrine
{

/** Returns true if the mapper is VTK's own for composite data, whose blocks are parts (scene/PartNumbers.h). */
bool IsCompositeMapperOfVTK(vtkMapper* mapper);

/** Returns true if the mapper is of a class that draws polydata at its points, or delegates to such a mapper. */
bool IsKnownMapper(vtkMapper* mapper);

/**
 * Returns the actor's mapper if it is a vtkDataSetMapper, which has another mapper draw the surface of its data. Else
 * returns null.
 */
vtkDataSetMapper* SurfaceMapperOf(vtkActor* actor);

/**
 * Returns the mapper that draws an actor of a known mapper: the actor's mapper itself, or the internal mapper of a
 * vtkDataSetMapper.
 * The result is null if the internal mapper does not have the current input yet. It gets it when the actor is drawn, so
 * it lacks it before the first frame. The result is also null if the mapper has several pieces or sub-pieces.
 */
vtkPolyDataMapper* DrawingMapperOf(vtkActor* actor);

}

#endif
