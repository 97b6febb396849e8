/** The section of a view: planes, a box and caps, as properties of ParaView set them one by one. */
#ifndef VITRINE_PARAVIEW_SECTION_OF_VIEW_H
#define VITRINE_PARAVIEW_SECTION_OF_VIEW_H

#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkSection.h"
#include "vtkSmartPointer.h"

#include <array>
#include <utility>
#include <vector>

class vtkActor;
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

  /** Returns the props and blocks with faces that are cut, are to have caps, and are not closed in this process. */
  std::vector<std::pair<vtkActor*, int>> FindOpenParts() const;

  /** Gives the planes and the box to the section, which is attached to the renderer where there are any. */
  void Update(vtkRenderer* renderer);
};

}

#endif
