#ifndef VITRINE_CORE_ASSEMBLY_EXPLOSION_H
#define VITRINE_CORE_ASSEMBLY_EXPLOSION_H

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace vitrine
{

/** A part of an exploded view: its place in the tree, and its box in world coordinates (WC). */
struct ExplodedPart
{
  std::string
    Path; ///< names of the nodes from the root to the part, each after a slash; may be empty
  glm::dvec3 Min{ 0.0 };
  glm::dvec3 Max{ 0.0 };
};

/**
 * Returns by how much each part moves in an exploded view, in WC.
 *
 * A node of the tree moves with its parent, and away from the centre of the parent's box by `factor` times the distance
 * of the two centres. So groups move apart, and within them their own parts. With a factor of 1, centres of the
 * children of one node are twice as far from each other. Nodes without siblings, and nodes whose centre is that of
 * their parent, stay where the parent goes.
 *
 * A part whose box is empty or not finite moves with its parent. A part without a path is a child of the root.
 */
std::vector<glm::dvec3> ExplodedOffsets(const std::vector<ExplodedPart>& parts, double factor);

}

#endif
