#ifndef VITRINE_CULLING_BLENDED_PROPS_H
#define VITRINE_CULLING_BLENDED_PROPS_H

#include "culling/PropPolicy.h"

#include <cstdint>

class vtkActor;
class vtkProp;

namespace vitrine
{

/**
 * Describes whether VTK may blend an opaque prop with what was drawn before it. Such a prop hides nothing. But it
 * writes its depth like others. So props behind it that are drawn later do not cover what shines through it.
 */
struct Blending
{
  /** Index in PropRows() of the rule by which it blends, or NoPropRow if it does not. */
  std::uint8_t Why = NoPropRow;
  /** Index in PropRows() of the rule by which its place is not known, or NoPropRow if it is. */
  std::uint8_t Anywhere = NoPropRow;
  /** The distance in pixels outside of its bounds at which it may draw. It is infinite if that is not known. */
  float Beside = 0.0f;

  bool MayBlend() const { return this->Why != NoPropRow; }

  /** Returns true if the other prop lets more of the screen be drawn. */
  bool IsLessThan(const Blending& other) const
  {
    return this->MayBlend() ? this->Beside < other.Beside && other.MayBlend() : other.MayBlend();
  }
};

/**
 * Describes an actor.
 * @param areTexturesOpaque  the result of AreTexturesOpaque() for the actor
 */
Blending BlendingOf(vtkActor* actor, bool areTexturesOpaque);

/**
 * Describes any prop: an actor, an image, or one that consists of these. Other props are taken not to blend in the
 * opaque pass.
 */
Blending BlendingOf(vtkProp* prop);

}

#endif
