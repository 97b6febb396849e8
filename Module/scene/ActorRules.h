#ifndef VITRINE_SCENE_ACTOR_RULES_H
#define VITRINE_SCENE_ACTOR_RULES_H

#include <string>
#include <vector>

class vtkActor;
class vtkMapper;
class vtkProp;
class vtkShaderProperty;

namespace vitrine
{

/** A reason for which a prop may be drawn elsewhere than where its data's points are. It is asked only where no row above it applies. */
struct DrawnElsewhereRow
{
  const char* Condition; ///< where it applies, as a clause
  const char* Why;       ///< as a clause
  bool (*Applies)(vtkProp*);
  std::string (*Detail)(vtkProp*) = nullptr; ///< the class that is not known
};

/** All of them. */
const std::vector<DrawnElsewhereRow>& DrawnElsewhereRows();

/** The prop as an actor, if no row of DrawnElsewhereRows() applies to it, so that others or the view can hide it; null otherwise. */
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
