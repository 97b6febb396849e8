/** The planes and the box of a section, and the parts that each of them cuts. */
#ifndef VITRINE_SECTION_SECTION_CUTTERS_H
#define VITRINE_SECTION_SECTION_CUTTERS_H

#include "scene/ExactParts.h"
#include "section/SectionPlanes.h"

#include "vtkPlane.h"
#include "vtkProp.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace vitrine
{

/** Stands for all blocks of a prop. It is less than any flat index. */
constexpr int EveryBlock = -1;

/** A plane and the parts that are chosen for it. */
struct Cutter
{
  vtkSmartPointer<vtkPlane> Plane;
  int Parts = 0; ///< vtkSection::PartsType
  /** Props, with a block or EveryBlock. A prop that is gone may have its address in common with a new one. */
  std::map<std::pair<vtkProp*, int>, vtkWeakPointer<vtkProp>> Chosen;

  bool Cuts(vtkProp* prop, int block) const;

  /** Returns true if blocks of the prop are chosen one by one. */
  bool HasBlocksOf(vtkProp* prop) const;

private:
  bool IsChosen(vtkProp* prop, int block) const;
};

struct SectionCutters
{
  std::vector<Cutter> Cutters;
  bool RemoveBeyondAll = false;
  bool HasBox = false;
  bool BoxKeepsInside = true;
  std::array<double, 6> Box{};

  /** Returns the cutter of a plane, or null. */
  Cutter* Find(vtkPlane* plane);

  /** Returns the planes in WC, first those of the user, then the faces of the box. Bad ones keep everything. */
  std::vector<CutPlane> Planes() const;

  /** The planes that apply to a block of a prop, or to the rest of it. */
  PlaneMasks MasksOf(vtkProp* prop, int block = EveryBlock) const;

  /** The planes that apply to each block of a prop, or none if they apply to all alike. */
  std::vector<PlaneMasks> MasksOfBlocks(vtkProp* prop) const;

  /** Adds the planes, and props with chosen parts, as which others cannot be cut. */
  void AddExact(ExactParts& parts) const;

  /** Returns the planes that apply to any block of a prop. */
  PlaneMasks MasksOfAnyBlock(vtkProp* prop) const;
};

}

#endif
