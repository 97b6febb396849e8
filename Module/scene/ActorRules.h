/** Rules about props: whether they are drawn at their data's points, and whether they are opaque. */
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

/**
 * A reason why a prop may be drawn elsewhere than at its data's points. It is tested only if no earlier row applies.
 */
struct DrawnElsewhereRow
{
  const char* Condition; ///< When it applies, as a clause.
  const char* Why;       ///< Why it matters, as a clause.
  bool (*Applies)(vtkProp*);
  std::string (*Detail)(vtkProp*) = nullptr; ///< The unknown class.
};

/** All such reasons, in the order in which they are tested. */
const std::vector<DrawnElsewhereRow>& DrawnElsewhereRows();

/**
 * Returns the prop as an actor if no row of DrawnElsewhereRows() applies, so that other props or the
 * view can hide it. Else returns null.
 */
vtkActor* AsHideable(vtkProp* prop);

/** Returns the result of vtkProp::GetShaderProperty(), or null if that would create one. */
vtkShaderProperty* ShaderPropertyOf(vtkProp* prop);

/** Returns true if the actor's shaders have code of the user, or if an observer of its mapper may set uniforms. */
bool HasShaderCode(vtkActor* actor);

/**
 * Returns true if the drawing mapper has an observer of UpdateShaderEvent, which may set uniforms. No modification time
 * tells of them.
 */
bool MaySetUniforms(vtkMapper* mapper);

/** Returns true if back faces have their own property, and it is translucent. */
bool HasTranslucentBack(vtkActor* actor);

/** Returns true if the mapper may take translucent colours from its data. */
bool MayHaveTranslucentColors(vtkMapper* mapper);

/**
 * Returns true if the images of all textures of the actor are made, so that drawing executes no pipeline for them.
 * Executes none itself.
 */
bool AreTexturesMade(vtkActor* actor);

/**
 * Returns true if all textures of the actor are known to be opaque. A texture whose image is not made yet is not known.
 */
bool AreTexturesOpaque(vtkActor* actor);

}

#endif
