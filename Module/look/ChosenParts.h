/** The parts that a user has chosen, with a number for each. */
#ifndef VITRINE_LOOK_CHOSEN_PARTS_H
#define VITRINE_LOOK_CHOSEN_PARTS_H

#include "vtkWeakPointer.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <vector>

class vtkProp;
class vtkRenderer;

namespace vitrine
{

/**
 * A part is a prop, or a node of its composite data with all nodes below it that are not chosen themselves. Numbers are
 * from 1 in the order of choice. Props may be deleted while they are chosen.
 */
class ChosenParts
{
public:
  /** Returns true if a prop draws parts: an actor, or a group of actors, but no volume, image or 2D prop. */
  static bool IsOfParts(vtkProp* prop);

  /** Choose a part by the flat index of its block. 0 and less stand for the whole prop. */
  void Add(vtkProp* prop, int block);
  void RemoveAll();

  std::size_t Size() const { return this->Count; }
  bool IsEmpty() const { return this->Count == 0; }

  bool Has(vtkProp* prop) const;

  /** Adds the props that have chosen parts. */
  void AddPropsTo(std::unordered_set<vtkProp*>& props) const;

  /** Returns the visible props of a renderer that have chosen parts, in the renderer's order. */
  std::vector<vtkProp*> PropsIn(vtkRenderer* renderer) const;

  /** Returns the number of each block of a prop by its flat index, 0 if it is not chosen. Other props have one. */
  std::vector<std::uint32_t> NumbersOf(vtkProp* prop) const;

private:
  /** The chosen parts of a prop. A prop that is gone may have its address in common with a new one. */
  struct PartsOfProp
  {
    vtkWeakPointer<vtkProp> Prop;
    std::map<unsigned int, std::uint32_t> NumberOf; ///< by flat index
  };

  std::unordered_map<vtkProp*, PartsOfProp> Props;
  std::size_t Count = 0;
};

}

#endif
