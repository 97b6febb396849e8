/**
 * Where a device draws actors: what the culler asks of them, beside the facts of scene/ActorRules and the rules of PropPolicy.
 */
#ifndef VITRINE_CULLING_PART_RULES_H
#define VITRINE_CULLING_PART_RULES_H

class vtkActor;
class vtkPolyDataMapper;

namespace vitrine
{

class PartGeometry;

/** Whether it is known from where VTK has the device's coordinates count: not where users tell it to, or cameras. */
bool IsShiftKnown(vtkPolyDataMapper* mapper);

/** Whether it is far from the origin for its size, or so small or large, that VTK by itself gives a device coordinates from its middle (vtkOpenGLVertexBufferObject::UpdateShiftScale()). */
bool IsSmallOrFarOff(const PartGeometry& geometry);

/** Whether VTK gives the device coordinates from the geometry's middle: of those it does so by itself, unless the mapper is told otherwise. */
bool IsDrawnAboutMiddle(vtkPolyDataMapper* mapper, const PartGeometry& geometry);

/** By how many pixels an actor that may be behind others is drawn wider than its points are. */
float GrowthOf(vtkActor* actor, const PartGeometry& geometry);

/** By how many pixels any actor is at most. */
float MostGrowthOf(vtkActor* actor);

/** Whether the user has marked the actor with vtkHierarchicalSBufferCuller::NON_OCCLUDING(). */
bool IsNonOccluding(vtkActor* actor);

/** Whether the actor is drawn as the edges of its faces. */
bool IsWireframe(vtkActor* actor);

}

#endif
