// Depth peeling draws other things too if nothing is translucent. So one translucent part must stay, even if it is
// hidden or beside the view.
#include "CullerScene.h"
#include "DividedActor.h"
#include "TestPasses.h"
#include "TestVolume.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkOverlayPass.h"
#include "vtkPoints.h"
#include "vtkPolarAxesActor.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty.h"
#include "vtkProperty2D.h"
#include "vtkTranslucentPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{

class CullerPeeling : public CullerTest
{
protected:
  CullerPeeling()
  {
    Scene.Window->AlphaBitPlanesOn();
    Scene.Renderer->UseDepthPeelingOn();
    Scene.AddMesh(MeshOf({ Rectangle(-0.8, -0.8, 0.8, 0.8, 0.0) }));
    Scene.LookAhead();
  }

  vtkSmartPointer<vtkActor> AddTranslucent(const Point3& middle)
  {
    const vtkSmartPointer<vtkActor> box = Scene.AddBox(middle, { 0.2, 0.2, 0.2 });
    box->GetProperty()->SetOpacity(0.5);
    return box;
  }

  // Over a corner of the wall, and of what is beside it.
  void AddOverlay()
  {
    vtkNew<vtkPoints> points;
    const double right = 0.4 * GetParam().Width, top = 0.4 * GetParam().Height;
    for (const Point3& corner :
      { Point3{ 0, 0, 0 }, Point3{ right, 0, 0 }, Point3{ right, top, 0 }, Point3{ 0, top, 0 } })
    {
      points->InsertNextPoint(corner.data());
    }
    vtkNew<vtkCellArray> quads;
    quads->InsertNextCell({ 0, 1, 2, 3 });
    vtkNew<vtkPolyData> plate;
    plate->SetPoints(points);
    plate->SetPolys(quads);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(plate);
    vtkNew<vtkActor2D> overlay;
    overlay->SetMapper(mapper);
    overlay->GetProperty()->SetOpacity(0.5);
    Scene.Renderer->AddActor2D(overlay);
  }

  void AddVolume()
  {
    vtkNew<vtkGPUVolumeRayCastMapper> mapper;
    mapper->AutoAdjustSampleDistancesOff(); // by time
    const vtkSmartPointer<vtkImageData> voxels =
      VoxelsOf(10, { 0.15, 0.15, 0.06 }, { -0.7, -0.7, 0.1 }, [](int i) { return i * 97 % 256; });
    Scene.Renderer->UseDepthPeelingForVolumesOn();
    Scene.Renderer->AddVolume(VolumeOf(voxels, mapper, 0.2));
  }

  // Expects that all but one of some translucent parts, hidden or beside the view, are culled. While another
  // translucent part is visible, all of them are culled.
  void ExpectOneKept()
  {
    for (const double beside : { 0.0, 9.0 })
    {
      SCOPED_TRACE(beside);
      const std::vector<vtkSmartPointer<vtkActor>> parts{ this->AddTranslucent(
                                                            { beside, 0.0, -0.4 }),
        this->AddTranslucent({ beside, 0.3, -0.4 }), this->AddTranslucent({ beside, -0.3, -0.4 }) };
      EXPECT_EQ(Scene.ExpectSame(), 2);
      const vtkSmartPointer<vtkActor> before = this->AddTranslucent({ 0.5, 0.5, 0.4 });
      EXPECT_EQ(Scene.ExpectSame(), 3);
      Scene.Renderer->RemoveActor(before);
      for (const vtkSmartPointer<vtkActor>& part : parts)
      {
        Scene.Renderer->RemoveActor(part);
      }
    }
  }
};

TEST_P(CullerPeeling, OneTranslucentPartStays)
{
  this->ExpectOneKept();
}

TEST_P(CullerPeeling, OneStaysBelowOverlays)
{
  this->AddOverlay();
  this->ExpectOneKept();
}

TEST_P(CullerPeeling, OneStaysBesideVolumes)
{
  this->AddVolume();
  this->ExpectOneKept();
}

TEST_P(CullerPeeling, OneStaysBelowAPassThatPeels)
{
  vtkNew<vtkTranslucentPass> translucent;
  vtkNew<vtkDualDepthPeelingPass> peeling;
  peeling->SetTranslucentPass(translucent);
  Scene.Renderer->SetPass(ByCamera(InSequence(
    { vtkNew<vtkLightsPass>(), vtkNew<vtkOpaquePass>(), peeling, vtkNew<vtkOverlayPass>() })));
  Scene.Renderer->UseDepthPeelingOff();
  this->AddOverlay();
  this->ExpectOneKept();
}

// Of blocks of an actor that is opaque as a whole.
TEST_P(CullerPeeling, ABlockStays)
{
  this->AddOverlay();
  vtkNew<vtkActor> actor;
  const vtkSmartPointer<vtkMapper> mapper = DividedMapperOf(Division::Blocks,
    { { Rectangle(-0.3, -0.3, 0.0, 0.3, -0.4) }, { Rectangle(0.1, -0.3, 0.4, 0.3, -0.4) } });
  auto* const composite = static_cast<vtkCulledCompositePolyDataMapper*>(mapper.Get());
  composite->SetCompositeDataDisplayAttributes(vtkNew<vtkCompositeDataDisplayAttributes>());
  composite->SetBlockOpacity(2, 0.5);
  actor->SetMapper(mapper);
  Scene.Renderer->AddActor(actor);
  EXPECT_EQ(Scene.ExpectSame(), 0);
  const vtkSmartPointer<vtkActor> before = this->AddTranslucent({ 0.5, 0.5, 0.4 });
  EXPECT_EQ(Scene.ExpectSame(), 2);
}

// The axes draw themselves once more where VTK draws what is translucent.
TEST_P(CullerPeeling, OneStaysBesideOtherProps)
{
  Scene.Renderer->UseDepthPeelingOff();
  vtkNew<vtkPolarAxesActor> axes;
  axes->SetCamera(Scene.Renderer->GetActiveCamera());
  axes->SetBounds(-0.6, 0.6, -0.6, 0.6, 0.3, 0.4);
  Scene.Renderer->AddViewProp(axes);
  Scene.Render(); // which puts them in order
  this->ExpectOneKept();
}

TEST_P(CullerPeeling, WithoutPeelingNoneStays)
{
  Scene.Renderer->UseDepthPeelingOff();
  this->AddTranslucent({ 0.0, 0.0, -0.4 });
  EXPECT_EQ(Scene.ExpectSame(), 1);
}

// VTK's peeling copies depths from windows of several samples to textures of another format, which OpenGL refuses.
INSTANTIATE_TEST_SUITE_P(
  Settings, CullerPeeling, testing::ValuesIn(CullerSettingsOfOneSample()), CullerSettingName);

}
