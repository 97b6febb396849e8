/** Fades parts, and puts back the looks that they had. */
#ifndef VITRINE_INSPECTION_FADED_LOOKS_H
#define VITRINE_INSPECTION_FADED_LOOKS_H

#include "scene/PartNumbers.h"

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

class vtkActor;
class vtkDataObject;
class vtkProperty;
class vtkRenderer;

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
 * Opacities in place of those of parts. An actor whose property is that of other actors, too, gets a copy of it in the
 * meantime. Blocks get opacities of their own. A prop that has no opacity is hidden.
 */
class FadedLooks
{
public:
  ~FadedLooks() { this->PutBackAll(); }

  /** Note the properties of a renderer's actors, and forget what was read of blocks, before opacities are set. */
  void Read(vtkRenderer* renderer);

  /** Returns the opacity that a part has without being faded, from 0 to 1. It is 1 for props that have none. */
  double OriginalOf(std::uint32_t number, const ShownPart& part);

  /** Returns BlockNodesOf(), kept until the next Read(). */
  const std::vector<BlockNode>& NodesOf(vtkActor* actor);

  /** Set the opacity of a part. With 0 it is hidden. */
  void Set(std::uint32_t number, const ShownPart& part, double opacity);

  /** Show the parts that Set() has hidden, with the opacities that they had before. */
  void ShowHidden();

  bool IsHidden(std::uint32_t number) const;

  /** Put back the look of a part, or of all. */
  void PutBack(std::uint32_t number);
  void PutBackAll();

private:
  /** What a part had before, and has now. */
  struct Look
  {
    vtkWeakPointer<vtkProp> Prop;
    unsigned int Block = 0;
    double Original = 1.0;
    bool IsSet = false;
    bool IsHidden = false;

    // Of actors.
    vtkSmartPointer<vtkProperty>
      Front; ///< the property, of which a copy is shown if it is others' too
    vtkSmartPointer<vtkProperty> Back;
    double FrontOpacity = 1.0;
    double BackOpacity = 1.0;
    bool IsCopy = false;
    bool IsForcedOpaque = false;

    // Of blocks: what they had of their own.
    vtkSmartPointer<vtkDataObject> Data;
    std::optional<double> Opacity;
    std::optional<bool> Visibility;
  };

  Look& LookOf(std::uint32_t number, const ShownPart& part);
  void Fade(Look& look, vtkActor* actor, double opacity);
  static void Show(Look& look, bool isVisible);
  static void PutBack(Look& look);

  std::unordered_map<vtkProperty*, int> Users; ///< the number of actors that a property is of
  std::unordered_map<vtkActor*, std::vector<BlockNode>> Nodes;
  std::map<std::uint32_t, Look> Looks;
};

}

#endif
