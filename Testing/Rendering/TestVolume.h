/**
 * Small volumes, from blue to yellow.
 */
#ifndef VITRINE_TEST_VOLUME_H
#define VITRINE_TEST_VOLUME_H

#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <array>

/** So many voxels in each direction. `valueAt` tells each, 0 to 255, by its number. */
template <class Value>
vtkSmartPointer<vtkImageData> VoxelsOf(int count, const std::array<double, 3>& spacing,
  const std::array<double, 3>& origin, const Value& valueAt)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(count, count, count);
  image->SetSpacing(spacing.data());
  image->SetOrigin(origin.data());
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxels = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < count * count * count; ++i)
  {
    voxels[i] = static_cast<unsigned char>(valueAt(i));
  }
  return image;
}

/** What a mapper draws of voxels. `mostOpaque` is how opaque those of 255 are. */
inline vtkSmartPointer<vtkVolume> VolumeOf(
  vtkImageData* voxels, vtkVolumeMapper* mapper, double mostOpaque)
{
  mapper->SetInputDataObject(voxels);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.1, 0.1, 0.9);
  color->AddRGBPoint(255.0, 0.9, 0.9, 0.1);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(255.0, mostOpaque);
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(color);
  volume->GetProperty()->SetScalarOpacity(opacity);
  return volume;
}

#endif
