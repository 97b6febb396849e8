/** Fades parts, and puts back the looks that they had. */
#ifndef VITRINE_SCENE_FADED_LOOKS_H
#define VITRINE_SCENE_FADED_LOOKS_H

#include "scene/PartNumbers.h"

#include <cstdint>
#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

class vtkActor;
class vtkDataObject;

namespace vitrine
{

/** A node of composite data, and what it has of the nodes above it. */
struct BlockNode
{
  vtkDataObject* Data;
  double Opacity;
};

/** Returns the nodes of a prop's composite data, by flat indices. Empty ones have no data. */
std::vector<BlockNode> BlockNodesOf(vtkActor* actor);

/**
 * Opacities in place of those of parts. Actors show copies of their properties in the meantime, since a property may be
 * that of other actors, too. Blocks get opacities of their own. A prop that has no opacity is hidden.
 *
 * Several of these objects may fade the same part, as in two viewports. The part has the least of their opacities, and
 * gets its look back from the last of them. Values that were set meanwhile by others stay: they become the part's own,
 * also if they were set on the copy of its property. It is not noticed if others hide what is hidden already.
 */
class FadedLooks
{
public:
  ~FadedLooks() { this->PutBackAll(); }

  /** Forget what was read of blocks, before opacities are set. */
  void ForgetNodes() { this->Nodes.clear(); }

  /** Returns the opacity that a part has without being faded, from 0 to 1. It is 1 for props that have none. */
  double OriginalOf(const ShownPart& part);

  /** Returns BlockNodesOf(), kept until the next ForgetNodes(). */
  const std::vector<BlockNode>& NodesOf(vtkActor* actor);

  /** Set the opacity of a part. With 0 it is hidden. */
  void Set(std::uint32_t number, const ShownPart& part, double opacity);

  /** Show the parts that Set() has hidden, with the opacities that they had before, until the next Set(). */
  void ShowHidden();

  /** Put back the look of a part, or of all. */
  void PutBack(std::uint32_t number);
  void PutBackAll();

private:
  struct Look;
  struct Registry;

  std::shared_ptr<Look> Read(const ShownPart& part);
  void Drop(const std::shared_ptr<Look>& look);

  std::unordered_map<vtkActor*, std::vector<BlockNode>> Nodes;
  std::map<std::uint32_t, std::shared_ptr<Look>> Looks; ///< what this object fades
};

}

#endif
