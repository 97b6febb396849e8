#ifndef VITRINE_CULLING_BLENDED_PROPS_H
#define VITRINE_CULLING_BLENDED_PROPS_H

#include "culling/PropPolicy.h"

#include <cstdint>

class vtkActor;
class vtkProp;

namespace vitrine
{

/**
 * Whether what VTK draws of a prop among what is opaque may be blended with what was drawn before it. It hides nothing; but
 * since it is as near as anything for the depth test, what is drawn later behind it does not cover what shines through.
 */
struct Blending
{
  std::uint8_t Why =
    NoPropRow; ///< the rule by which it may, of PropRows(); NoPropRow if it does not
  std::uint8_t Anywhere =
    NoPropRow; ///< the rule by which it is not known where; NoPropRow if it is
  float Beside =
    0.0f; ///< how many pixels beside its bounds may be drawn, too; infinite if that is not known

  bool MayBlend() const { return this->Why != NoPropRow; }

  /** Whether the other one has more of the screen drawn. */
  bool IsLessThan(const Blending& other) const
  {
    return this->MayBlend() ? this->Beside < other.Beside && other.MayBlend() : other.MayBlend();
  }
};

/** @param areTexturesOpaque  as AreTexturesOpaque() tells of the actor */
Blending BlendingOf(vtkActor* actor, bool areTexturesOpaque);

/** Of any prop: an actor, an image, or what is made of such; others are taken to blend nothing among what is opaque. */
Blending BlendingOf(vtkProp* prop);

}

#endif
