#ifndef VITRINE_CULLING_BLENDED_PROPS_H
#define VITRINE_CULLING_BLENDED_PROPS_H

class vtkActor;
class vtkProp;

namespace vitrine
{

struct PropRow;

/**
 * Whether what VTK draws of a prop among what is opaque may be blended with what was drawn before it. It hides nothing; but since it is as near as anything for the depth test,
 * what is drawn later behind it does not cover what shines through.
 */
struct Blending
{
  const PropRow* Why = nullptr; ///< the rule by which it may; null if it does not
  float Beside =
    0.0f; ///< how many pixels beside its bounds may be drawn, too; infinite if that is not known
};

/** @param areTexturesOpaque  as AreTexturesOpaque() tells of the actor */
Blending BlendingOf(vtkActor* actor, bool areTexturesOpaque);

/** Of any prop: an actor, an image, or what is made of such; others are taken to blend nothing among what is opaque. */
Blending BlendingOf(vtkProp* prop);

}

#endif
