#include "SectionOfView.h"

#include "vtkBoundingBox.h"
#include "vtkRenderer.h"

namespace vitrine
{

void SectionOfView::SetSceneBounds(const vtkBoundingBox& bounds)
{
  double b[6];
  bounds.GetBounds(b);
  this->Section->SetSceneBounds(b[0], b[1], b[2], b[3], b[4], b[5]);
}

int SectionOfView::CountOpenParts() const
{
  int count = 0;
  const bool haveCaps = this->Section->GetRenderer() && this->Section->GetCaps();
  for (int i = 0; haveCaps && i < this->Section->GetNumberOfCutParts(); ++i)
  {
    count += this->Section->IsCutPartClosed(i) ? 0 : 1;
  }
  return count;
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
