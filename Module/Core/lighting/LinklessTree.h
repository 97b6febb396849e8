#ifndef VITRINE_CORE_LIGHTING_LINKLESS_TREE_H
#define VITRINE_CORE_LIGHTING_LINKLESS_TREE_H

#include "Core/geometry/Bits.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace vitrine
{

/**
 * The shape of a tree over items in a given order. A node has eight items or eight child nodes, so no links are needed.
 */
class LinklessTree
{
public:
  static constexpr std::size_t Width = 8;

  /** A node. Nodes of level 0 hold items. */
  struct Place
  {
    std::size_t Level;
    std::size_t Number;

    std::size_t ChildAt(std::size_t lane) const { return this->Number * Width + lane; }
  };

  /**
   * Makes the nodes of all levels up to the root.
   * @param nodes     receives the nodes of level 0 and then of each level above; must be empty
   * @param count     the number of items
   * @param putThing  putThing(node, lane, item number)
   * @param putNode   putNode(node, lane, child)
   */
  template <class Node, class PutThing, class PutNode>
  void Build(
    std::vector<Node>& nodes, std::size_t count, const PutThing& putThing, const PutNode& putNode)
  {
    this->Things = count;
    nodes.reserve(count / (Width - 1) + 16);
    nodes.resize(NodesFor(count));
    for (std::size_t i = 0; i < count; ++i)
    {
      putThing(nodes[i / Width], static_cast<int>(i % Width), i);
    }
    this->Begins = { 0, nodes.size() };
    while (this->CountOn(this->Begins.size() - 2) > 1)
    {
      const std::size_t begin = *(this->Begins.end() - 2), end = nodes.size();
      nodes.resize(end + NodesFor(end - begin));
      for (std::size_t i = 0; i < end - begin; ++i)
      {
        putNode(nodes[end + i / Width], static_cast<int>(i % Width), nodes[begin + i]);
      }
      this->Begins.push_back(nodes.size());
    }
  }

  /** Returns the index of a node in `nodes`. */
  std::size_t IndexOf(const Place& place) const { return this->Begins[place.Level] + place.Number; }

  /** Calls look(place) for the root, and for each child whose bit look() returned for its parent. */
  template <class Look>
  void Walk(const Look& look) const
  {
    std::vector<Place> stack;
    if (this->Things > 0)
    {
      stack.push_back({ this->Begins.size() - 2, 0 });
    }
    while (!stack.empty())
    {
      const Place place = stack.back();
      stack.pop_back();
      for (unsigned bits = look(place); bits != 0; bits &= bits - 1)
      {
        stack.push_back(
          { place.Level - 1, place.ChildAt(static_cast<std::size_t>(LowestBit(bits))) });
      }
    }
  }

private:
  std::size_t CountOn(std::size_t level) const
  {
    return this->Begins[level + 1] - this->Begins[level];
  }

  static std::size_t NodesFor(std::size_t things) { return (things + Width - 1) / Width; }

  std::size_t Things = 0;
  std::vector<std::size_t> Begins; ///< the first node of each level, and the end of the last level
};

}

#endif
