#ifndef VITRINE_SCENE_ACTOR_RULES_H
#define VITRINE_SCENE_ACTOR_RULES_H

#include "vtkType.h"

class vtkActor;
class vtkMapper;
class vtkPolyDataMapper;
class vtkProp;
class vtkShaderProperty;

namespace vitrine
{

class PartGeometry;

/**
 * The prop as an actor that is drawn where its data's points are, so that others or the view can hide it; null for all others: other
 * classes, other mappers, coordinates of the room or the device, shader code of the user's.
 */
vtkActor* AsHideable(vtkProp* prop);

/**
 * Whether others may hide the actor, and not the view alone: not where depths are offset for what is coincident, nor with edges, vertices, spheres, tubes or a selection, which have depths of their own.
 * @param drawing  the mapper that draws it
 */
bool MayBeBehindOthers(vtkActor* actor, vtkMapper* drawing);

/** What vtkProp::GetShaderProperty() tells, null where that would make one. */
vtkShaderProperty* ShaderPropertyOf(vtkProp* prop);

/** Whether the actor's shaders have code of the user's, or uniforms. */
bool HasShaderCode(vtkActor* actor);

/** Whether somebody is told when the mapper that draws sets uniforms, who may set others then. No time tells of that. */
bool MaySetUniforms(vtkMapper* mapper);

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

/** Whether all of the actor surely is opaque, textures and colours of single blocks aside. */
bool IsOpaque(vtkActor* actor);

/** Whether the surface of the actor surely hides what lies behind it, likewise. */
bool IsOpaqueSurface(vtkActor* actor);

/** Whether back faces have a property of their own that is translucent. */
bool HasTranslucentBack(vtkActor* actor);

/** Whether a mapper may take colours from its data that let anything through. */
bool MayHaveTranslucentColors(vtkMapper* mapper);

/** Whether drawing the actor makes no image of its textures anew. Makes none. */
bool AreTexturesMade(vtkActor* actor);

/** Whether the actor has no texture that could let anything through, one whose image is yet to be made among them. */
bool AreTexturesOpaque(vtkActor* actor);

}

#endif
