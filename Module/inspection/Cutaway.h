/** A hole that is cut along the view before a part. */
#ifndef VITRINE_INSPECTION_CUTAWAY_H
#define VITRINE_INSPECTION_CUTAWAY_H

#include "Core/geometry/PixelRegion.h"
#include "inspection/PartOnScreen.h"
#include "inspection/PixelRays.h"
#include "scene/PartNumbers.h"
#include "vtkSection.h"

#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>

#include <array>
#include <string>
#include <vector>

class vtkRenderer;

namespace vitrine
{

/**
 * Cuts chosen parts by five planes, which remove what lies beyond all of them: what is not behind a depth, and within a
 * rectangle of pixels. The four planes of its sides open towards the eye, so that their caps are seen. The planes
 * belong to a section of its own, of which a renderer can have one.
 */
class Cutaway
{
public:
  Cutaway();
  ~Cutaway() { this->Remove(); }

  /** Returns why the renderer cannot have a cutaway, or an empty string. */
  std::string ProblemOf(vtkRenderer* renderer) const;

  /** Choose nothing, so that nothing is cut. */
  void Suspend();

  /**
   * Cut parts in a rectangle down to a depth.
   * @param region  in pixels of the window
   * @param depth   distance from the eye along the view, in WC
   */
  void Cut(vtkRenderer* renderer, const PixelRays& rays, const PixelRegion& region, double depth,
    const std::vector<ShownPart>& parts);

  void Remove();

  /** Returns the greatest distance of some points from the eye along the view. */
  static double DepthOf(vtkRenderer* renderer, const std::vector<BoxCorners>& boxes);

private:
  vtkNew<vtkSection> Section;
  std::array<vtkSmartPointer<vtkPlane>, 5> Planes;
};

}

#endif
