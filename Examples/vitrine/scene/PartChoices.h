/** What is asked of parts that are chosen by name: opacity, colour, and which are drawn; and of where all are drawn. */
#ifndef VITRINE_PART_CHOICES_H
#define VITRINE_PART_CHOICES_H

#include "scene/Scene.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace program
{

/** The texts of options, in the order in which they were given. Core/assembly/PartPattern.h tells what a GLOB is. */
struct PartChoices
{
  std::vector<std::string>
    Opacity; ///< A, multiplied into all opacities, or GLOB=A, which sets it; A is in [0, 1]
  std::vector<std::string> Color;     ///< GLOB=COLOR: a name of CSS, #RRGGBB, or rgb(R,G,B)
  std::vector<std::string> Hide;      ///< GLOB
  std::vector<std::string> Only;      ///< GLOB; parts that none of them chooses are not drawn
  std::vector<std::string> XRay;      ///< GLOB; parts that none of them chooses become faint
  std::optional<double> XRayFalloff;  ///< their opacity falls off by this power instead
  std::vector<std::string> Highlight; ///< GLOB; parts whose outlines are drawn through all others
  std::vector<std::string> Hatch;     ///< NAME of the caps of all parts, or GLOB=NAME
  std::vector<std::string> KeepWhole; ///< GLOB; parts that planes of sections do not cut
  double Explode = 0.0;               ///< factor of an exploded view (Core/assembly/Explosion.h)
};

/**
 * Change a scene as its user asks: first the places of an exploded view, then faint parts, then opacities and colours,
 * of which later ones win, and then which parts are drawn. Throws InputError if a text cannot be read, chooses no part,
 * or if no part is left.
 */
void Apply(const PartChoices& choices, Scene& scene);

/** By how much each part moves in an exploded view (Core/assembly/Explosion.h), in world coordinates. */
std::vector<std::array<double, 3>> ExplodedOffsets(const Scene& scene, double factor);

/** A place, the identity for null, after a move in world coordinates. */
vtkSmartPointer<vtkMatrix4x4> MovedBy(const std::array<double, 3>& offset, vtkMatrix4x4* place);

/** The product of all numbers that are multiplied into all opacities. */
double CommonOpacity(const PartChoices& choices);

}
#endif
