#include "assembly/PartPoints.h"

#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(PartPoints);

//------------------------------------------------------------------------------
void PartPoints::ComputeBounds()
{
  vtkFloatArray* const array = vtkFloatArray::FastDownCast(this->Data);
  if (!array || this->GetMTime() <= this->ComputeTime)
  {
    this->Superclass::ComputeBounds();
    return;
  }
  vtkMath::UninitializeBounds(this->Bounds);
  const float* const values = array->GetPointer(0);
  const vtkIdType count = array->GetNumberOfValues();
  for (int axis = 0; count > 0 && axis < 3; ++axis)
  {
    float lowest = VTK_FLOAT_MAX;
    float highest = VTK_FLOAT_MIN;
    for (vtkIdType i = axis; i < count; i += 3)
    {
      lowest = values[i] < lowest ? values[i] : lowest; // A NaN is in no comparison.
      highest = values[i] > highest ? values[i] : highest;
    }
    this->Bounds[2 * axis] = lowest;
    this->Bounds[2 * axis + 1] = highest;
  }
  this->ComputeTime.Modified();
}
