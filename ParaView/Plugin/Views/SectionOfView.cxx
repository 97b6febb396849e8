#include "SectionOfView.h"

#include "vtkActor.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkMapper.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

namespace vitrine
{

namespace
{

bool HasFaces(vtkDataObject* data)
{
  if (auto* const blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkSmartPointer<vtkCompositeDataIterator> at;
    at.TakeReference(blocks->NewIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    {
      if (HasFaces(at->GetCurrentDataObject()))
      {
        return true;
      }
    }
    return false;
  }
  auto* const faces = vtkPolyData::SafeDownCast(data);
  return faces && faces->GetNumberOfPolys() + faces->GetNumberOfStrips() > 0;
}

bool HasFaces(vtkActor* actor)
{
  vtkMapper* const mapper = actor->GetMapper();
  return actor->GetProperty()->GetRepresentation() == VTK_SURFACE && mapper &&
    mapper->GetNumberOfInputConnections(0) > 0 && HasFaces(mapper->GetInputDataObject(0, 0));
}
}

std::vector<std::pair<vtkActor*, int>> SectionOfView::FindOpenParts() const
{
  std::vector<std::pair<vtkActor*, int>> parts;
  if (!this->Section->GetRenderer() || !this->Section->GetCaps())
  {
    return parts;
  }
  const int count = this->Section->GetNumberOfCutParts();
  for (int i = 0; i < count; ++i)
  {
    auto* const actor = vtkActor::SafeDownCast(this->Section->GetCutProp(i));
    if (actor && !this->Section->IsCutPartClosed(i) && HasFaces(actor))
    {
      parts.emplace_back(actor, this->Section->GetCutBlock(i));
    }
  }
  return parts;
}

void SectionOfView::Update(vtkRenderer* renderer)
{
  this->Section->RemoveAllPlanes();
  if (this->HasPlane)
  {
    this->Section->AddPlane(this->Plane);
  }
  for (const auto& plane : this->Others)
  {
    this->Section->AddPlane(plane);
  }
  this->Section->RemoveBox();
  if (this->Box != NO_BOX)
  {
    const std::array<double, 6>& b = this->Bounds;
    this->Section->SetBox(b[0], b[1], b[2], b[3], b[4], b[5], this->Box == KEEP_INSIDE);
  }
  const bool cuts = this->Section->GetNumberOfPlanes() > 0 || this->Section->HasBox();
  if (!cuts)
  {
    this->Section->Detach();
  }
  else if (this->Section->GetRenderer() != renderer)
  {
    this->Section->Attach(renderer);
  }
}

}
