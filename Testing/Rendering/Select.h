/**
 * What a hardware selector finds.
 */
#ifndef VITRINE_TESTING_SELECT_H
#define VITRINE_TESTING_SELECT_H

#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkNew.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSmartPointer.h"

#include <map>
#include <set>

using Picked = std::map<vtkProp*, std::set<vtkIdType>>;

/** Ids of cells or points by prop, in a rectangle of pixels. */
inline Picked Select(vtkRenderer* renderer, int association, int x0, int y0, int x1, int y1)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetFieldAssociation(association);
  selector->SetArea(x0, y0, x1, y1);
  const vtkSmartPointer<vtkSelection> selection = vtk::TakeSmartPointer(selector->Select());
  Picked picked;
  for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    auto* prop = vtkProp::SafeDownCast(node->GetProperties()->Get(vtkSelectionNode::PROP()));
    auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
    for (vtkIdType k = 0; k < ids->GetNumberOfValues(); ++k)
    {
      picked[prop].insert(ids->GetValue(k));
    }
  }
  return picked;
}

#endif
