/**
 * Where a device draws actors. These questions of the culler are neither facts of scene/ActorRules nor rules of
 * PropPolicy.
 */
#ifndef VITRINE_CULLING_PART_RULES_H
#define VITRINE_CULLING_PART_RULES_H

class vtkActor;
class vtkPolyDataMapper;

namespace vitrine
{

class PartGeometry;

/**
 * Returns true if the origin of the coordinates of a device is known. It is not known if the user or the camera sets
 * it.
 */
bool IsShiftKnown(vtkPolyDataMapper* mapper);

/**
 * Returns true if VTK by itself would give a device coordinates relative to the middle of the geometry. VTK does so if
 * the geometry is far from the origin for its size, very small, or very large
 * (vtkOpenGLVertexBufferObject::UpdateShiftScale()).
 */
bool IsSmallOrFarOff(const PartGeometry& geometry);

/**
 * Returns true if VTK gives a device coordinates relative to the middle of the geometry. That is so if
 * IsSmallOrFarOff() and the mapper has its usual settings.
 */
bool IsDrawnAboutMiddle(vtkPolyDataMapper* mapper, const PartGeometry& geometry);

/** Returns by how many pixels an actor is drawn wider than its points are. The actor may be hidden by others. */
float GrowthOf(vtkActor* actor, const PartGeometry& geometry);

/** Returns the most pixels by which an actor may be drawn wider, with all that VTK draws of it. */
float MostGrowthOf(vtkActor* actor);

/** Returns true if the user has marked the actor by vtkHierarchicalSBufferCuller::NON_OCCLUDING(). */
bool IsNonOccluding(vtkActor* actor);

/** Returns true if the actor is drawn as the edges of its faces. */
bool IsWireframe(vtkActor* actor);

}

#endif
