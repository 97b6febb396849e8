/** The boxes of a renderer's props against the planes of a section. */
#ifndef VITRINE_SECTION_PROP_BOXES_H
#define VITRINE_SECTION_PROP_BOXES_H

#include "Core/section/CutPlane.h"
#include "section/CutParts.h"
#include "section/SectionPlanes.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <limits>
#include <unordered_map>
#include <vector>

class vtkProp;
class vtkRenderer;

namespace vitrine
{

/** A box in WC. */
struct WorldBox
{
  glm::dvec3 Min{ std::numeric_limits<double>::infinity() };
  glm::dvec3 Max{ -std::numeric_limits<double>::infinity() };

  bool IsEmpty() const { return !(this->Min.x <= this->Max.x); }
  void Add(const WorldBox& other)
  {
    this->Min = glm::min(this->Min, other.Min);
    this->Max = glm::max(this->Max, other.Max);
  }

  /** Returns the margin of a plane for points of the box, in coordinates from its middle. */
  double MarginOf(const CutPlane& plane) const;

  /** Returns true if the plane cuts the box or lies in a face of it, but for roundings. */
  bool IsMetBy(const CutPlane& plane) const;
};

class PropBoxes
{
public:
  /**
   * Read the boxes of visible props but caps, and move each plane by the margin that those need that it meets. Props
   * far from a plane have no say.
   * @param planes  the planes in WC
   * @param parts   those that were cut last, whose sums have a center of their own
   * @param scene   a box that has a say in place of those, if it is not empty
   */
  SectionPlanes Place(vtkRenderer* renderer, const std::vector<CutPlane>& planes,
    const CutParts& parts, const WorldBox& scene);

  /** Returns true unless no plane cuts the box of a prop, nor any box in it. */
  bool IsMet(vtkProp* prop, const SectionPlanes& planes) const;

  /** Returns true unless all of a prop to which `masks` apply is certainly kept. */
  bool MayRemoveFrom(vtkProp* prop, const PlaneMasks& masks, const SectionPlanes& planes) const;

private:
  std::vector<WorldBox> ReadBoxesMetBy(vtkRenderer* renderer, const std::vector<CutPlane>& planes);

  std::unordered_map<vtkProp*, WorldBox> Boxes;
};

}

#endif
