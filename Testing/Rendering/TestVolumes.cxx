// Volumes beside translucent geometry are drawn as VTK draws them, after it and over it.
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkActor.h"
#include "vtkColorTransferFunction.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderStepsPass.h"
#include "vtkTranslucentPass.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <gtest/gtest.h>

namespace
{

void AddVolume(TestScene& scene, vtkVolumeMapper* mapper)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(12, 12, 12);
  image->SetSpacing(0.08, 0.08, 0.08);
  image->SetOrigin(-0.4, -0.4, -0.4);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxels = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 12 * 12 * 12; ++i)
  {
    voxels[i] = static_cast<unsigned char>(i % 12 * 20);
  }
  mapper->SetInputDataObject(image);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.1, 0.1, 0.9);
  color->AddRGBPoint(255.0, 0.9, 0.9, 0.1);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(255.0, 0.1);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(color);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.1);
  scene.Renderer->AddVolume(volume);
}

class Volumes : public testing::TestWithParam<Method>
{
protected:
  static void ExpectAsVTK(vtkVolumeMapper* mapper)
  {
    TestScene scene(48, 36);
    AddVolume(scene, mapper);
    // One layer, behind the volume, which VTK itself blends rightly.
    scene.AddRectangle(-0.9, -0.3, 0.6, 0.7, -0.6, { 0.2, 0.9, 0.2, 0.5 });
    vtkNew<vtkTranslucentPass> blending;
    scene.Use(blending);
    const Picture expected = scene.Render();
    const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
    scene.Use(pass);
    for (int frame = 0; frame < 2; ++frame)
    {
      EXPECT_LE(LargestDifference(scene.Render(), expected, GetParam().EdgeShare),
        2); // either rounds before the volume's blending
    }
    EXPECT_EQ(pass->GetLayersMax(), 1);
    scene.Renderer->RemoveAllViewProps();
    EXPECT_FALSE(scene.Render() == expected);
  }
};

TEST_P(Volumes, OfTheGPUAreAsVTKDrawsThem)
{
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  ExpectAsVTK(mapper);
}

TEST_P(Volumes, OfTheCPUAreAsVTKDrawsThem)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  ExpectAsVTK(mapper);
}

INSTANTIATE_TEST_SUITE_P(Methods, Volumes, testing::ValuesIn(AllMethods()), MethodName());

}
