#ifndef VITRINE_SCENE_ACTOR_RULES_H
#define VITRINE_SCENE_ACTOR_RULES_H

class vtkActor;
class vtkMapper;
class vtkProp;
class vtkShaderProperty;

namespace vitrine
{

/**
 * The prop as an actor that is drawn where its data's points are, so that others or the view can hide it; null for all others: other
 * classes, other mappers, coordinates of the room or the device, shader code of the user's.
 */
vtkActor* AsHideable(vtkProp* prop);

/** What vtkProp::GetShaderProperty() tells, null where that would make one. */
vtkShaderProperty* ShaderPropertyOf(vtkProp* prop);

/** Whether the actor's shaders have code of the user's, or uniforms. */
bool HasShaderCode(vtkActor* actor);

/** Whether somebody is told when the mapper that draws sets uniforms, who may set others then. No time tells of that. */
bool MaySetUniforms(vtkMapper* mapper);

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
