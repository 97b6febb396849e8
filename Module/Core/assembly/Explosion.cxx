#include "Core/assembly/Explosion.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_map>

namespace vitrine
{

namespace
{

struct Node
{
  std::size_t Parent = 0;
  glm::dvec3 Min{ std::numeric_limits<double>::infinity() };
  glm::dvec3 Max{ -std::numeric_limits<double>::infinity() };

  glm::dvec3 Center() const { return 0.5 * this->Min + 0.5 * this->Max; }
  bool HasBox() const
  {
    return this->Min.x <= this->Max.x && this->Min.y <= this->Max.y && this->Min.z <= this->Max.z;
  }
};

bool HasFiniteBox(const ExplodedPart& part)
{
  bool isFinite = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    isFinite = isFinite && std::isfinite(part.Min[axis]) && std::isfinite(part.Max[axis]) &&
      part.Min[axis] <= part.Max[axis];
  }
  return isFinite;
}

/** The nodes of all paths. A parent comes before its children; the first is the root. */
class Tree
{
public:
  std::vector<Node> Nodes{ Node{} };

  /** Returns the node of a path, which is made with those above it if it is not there yet. */
  std::size_t NodeOf(const std::string& path)
  {
    std::size_t node = 0;
    for (std::size_t end = 0; end < path.size();)
    {
      end = std::min(path.find('/', end + 1), path.size());
      const auto [found, isNew] =
        this->NodesByPath.emplace(path.substr(0, end), this->Nodes.size());
      if (isNew)
      {
        this->Add(node);
      }
      node = found->second;
    }
    return node;
  }

  std::size_t Add(std::size_t parent)
  {
    this->Nodes.emplace_back();
    this->Nodes.back().Parent = parent;
    return this->Nodes.size() - 1;
  }

  /** Has the boxes of all nodes contain those of their children. */
  void JoinBoxes()
  {
    for (std::size_t i = this->Nodes.size() - 1; i > 0; --i)
    {
      Node& parent = this->Nodes[this->Nodes[i].Parent];
      parent.Min = glm::min(parent.Min, this->Nodes[i].Min);
      parent.Max = glm::max(parent.Max, this->Nodes[i].Max);
    }
  }

private:
  std::unordered_map<std::string, std::size_t> NodesByPath;
};
}

std::vector<glm::dvec3> ExplodedOffsets(const std::vector<ExplodedPart>& parts, double factor)
{
  Tree tree;
  std::vector<std::size_t> nodes;
  nodes.reserve(parts.size());
  for (const ExplodedPart& part : parts)
  {
    nodes.push_back(part.Path.empty() ? tree.Add(0) : tree.NodeOf(part.Path));
    Node& node = tree.Nodes[nodes.back()];
    if (HasFiniteBox(part))
    {
      node.Min = glm::min(node.Min, part.Min);
      node.Max = glm::max(node.Max, part.Max);
    }
  }
  tree.JoinBoxes();

  std::vector<glm::dvec3> offsets(tree.Nodes.size(), glm::dvec3(0.0));
  for (std::size_t i = 1; i < tree.Nodes.size(); ++i)
  {
    const Node& node = tree.Nodes[i];
    offsets[i] = offsets[node.Parent];
    if (node.HasBox())
    {
      offsets[i] += factor * (node.Center() - tree.Nodes[node.Parent].Center());
    }
  }
  std::vector<glm::dvec3> moved;
  moved.reserve(parts.size());
  for (const std::size_t node : nodes)
  {
    moved.push_back(offsets[node]);
  }
  return moved;
}

}
