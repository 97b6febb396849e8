// Volumes beside translucent geometry are drawn as VTK draws them, after it and over it.
#include "TestMethods.h"
#include "TestScene.h"
#include "TestVolume.h"
#include "vtkActor.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkRenderStepsPass.h"
#include "vtkTranslucentPass.h"

#include <gtest/gtest.h>

namespace
{

void AddVolume(TestScene& scene, vtkVolumeMapper* mapper)
{
  const vtkSmartPointer<vtkImageData> voxels =
    VoxelsOf(12, { 0.08, 0.08, 0.08 }, { -0.4, -0.4, -0.4 }, [](int i) { return i % 12 * 20; });
  const vtkSmartPointer<vtkVolume> volume = VolumeOf(voxels, mapper, 0.1);
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
      EXPECT_TRUE(Matches(scene.Render(), expected, 2,
        GetParam().EdgeShare)); // either rounds before the volume's blending
    }
    EXPECT_EQ(pass->GetMaximumNumberOfLayers(), 1);
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
