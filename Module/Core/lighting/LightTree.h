/**
 * Finds the lights that may be in a view.
 */
#ifndef VITRINE_CORE_LIGHTING_LIGHT_TREE_H
#define VITRINE_CORE_LIGHTING_LIGHT_TREE_H

#include "Core/geometry/Bits.h"
#include "Core/geometry/BoxLanes.h"
#include "Core/lighting/LightVolume.h"
#include "Core/lighting/LinklessTree.h"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** One bit for each light. Lights without a mark are skipped. */
class LightMarks
{
public:
  explicit LightMarks(std::size_t lights = 0)
    : Words((lights + 63) / 64, 0)
  {
  }

  void Add(std::uint32_t light) { this->Words[light / 64] |= std::uint64_t{ 1 } << light % 64; }
  bool Has(std::uint32_t light) const { return (this->Words[light / 64] >> light % 64 & 1) != 0; }

  /** Returns the bits of lights 64 * `block` and following. The first light has the lowest bit. */
  std::uint64_t Block(std::size_t block) const { return this->Words[block]; }

  std::size_t Count() const;

private:
  std::vector<std::uint64_t> Words;
};

/**
 * A bounding volume hierarchy over lights in Morton order. A leaf has eight lights and a node has eight children, so no
 * links are needed (O. Olsson, M. Billeter, U. Assarsson: Clustered deferred and forward shading, HPG 2012, with 32
 * children). It is built in linear time. For lights that do not move it is built once, in world coordinates (WC), and
 * queried for each view.
 */
class LightTree
{
public:
  explicit LightTree(const std::vector<LightVolume>& volumes);

  /** Calls visit(light) for each light whose bounding box touches a box, in no particular order. */
  template <class Visit>
  void ForEachTouching(const Box& box, const Visit& visit) const
  {
    this->Walk(visit,
      [&](const BoxLanes& boxes)
      {
        unsigned bits = 0;
        for (int lane = 0; lane < LaneCount; ++lane)
        {
          bits |= (Touches(boxes.At(lane), box) ? 1u : 0u) << lane;
        }
        return bits;
      });
  }

  /**
   * Marks the lights that may lie within some planes. A light without a mark certainly lies outside one of them.
   * @param sides  planes such as ClusterGrid::OuterSides(), in the coordinates of the lights
   */
  LightMarks Within(const std::array<glm::vec4, 5>& sides) const;

private:
  template <class Visit, class Test>
  void Walk(const Visit& visit, const Test& test) const;

  std::size_t Lights;                 ///< number of all lights
  std::vector<std::uint32_t> Endless; ///< lights without a finite box
  std::vector<std::uint32_t> Order;   ///< the other lights, in Morton order
  LinklessTree Shape;
  std::vector<BoxLanes> Nodes;
};

/** Transforms planes from view coordinates (VC) back to the source coordinates of `toView`, which must be rigid. */
std::array<glm::vec4, 5> SidesBefore(
  const std::array<glm::vec4, 5>& sides, const glm::dmat4& toView);

template <class Visit, class Test>
void LightTree::Walk(const Visit& visit, const Test& test) const
{
  for (const std::uint32_t light : this->Endless)
  {
    visit(light);
  }
  this->Shape.Walk(
    [&](const LinklessTree::Place& place)
    {
      unsigned bits = test(this->Nodes[this->Shape.IndexOf(place)]);
      for (; place.Level == 0 && bits != 0; bits &= bits - 1)
      {
        visit(this->Order[place.ChildAt(static_cast<std::size_t>(LowestBit(bits)))]);
      }
      return bits;
    });
}

}

#endif
