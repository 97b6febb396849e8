/** The section of a view: planes, a box and caps, as properties of ParaView set them one by one. */
#ifndef VITRINE_PARAVIEW_SECTION_OF_VIEW_H
#define VITRINE_PARAVIEW_SECTION_OF_VIEW_H

#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkSection.h"
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkBoundingBox;
class vtkRenderer;

namespace vitrine
{

class SectionOfView
{
public:
  SectionOfView() = default;
  SectionOfView(const SectionOfView&) = delete;
  void operator=(const SectionOfView&) = delete;
  ~SectionOfView() { this->Section->Detach(); }

  enum BoxType
  {
    NO_BOX,
    KEEP_INSIDE,
    REMOVE_INSIDE
  };

  bool HasPlane = false;
  vtkNew<vtkPlane> Plane; ///< that of the handle in ParaView's window
  std::vector<vtkSmartPointer<vtkPlane>> Others;
  int Box = NO_BOX;
  std::array<double, 6> Bounds{ 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  vtkNew<vtkSection> Section;

  /** Set the bounds of what the view shows on all ranks, which then cut alike. */
  void SetSceneBounds(const vtkBoundingBox& bounds);

  /** Returns how many parts the last frame cut that are to have caps, and are not closed in this process. */
  int CountOpenParts() const;

  /** Gives the planes and the box to the section, which is attached to the renderer where there are any. */
  void Update(vtkRenderer* renderer);
};

}

#endif
