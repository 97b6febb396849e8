// Props that the culler does not treat, and VTK's passes: all is drawn as it is without culling.
#include "CullerScene.h"
#include "TestPasses.h"
#include "TestVolume.h"
#include "vtkActor2D.h"
#include "vtkAssembly.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkCamera.h"
#include "vtkClearZPass.h"
#include "vtkCubeSource.h"
#include "vtkEDLShading.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkFollower.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkGaussianBlurPass.h"
#include "vtkImageData.h"
#include "vtkLODProp3D.h"
#include "vtkLight.h"
#include "vtkLightsPass.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLFXAAPass.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPanoramicProjectionPass.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkPropAssembly.h"
#include "vtkProperty2D.h"
#include "vtkRenderStepsPass.h"
#include "vtkSeeThroughPass.h"
#include "vtkSobelGradientMagnitudePass.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"
#include "vtkTranslucentPass.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <utility>

namespace
{

class CullerProps : public CullerTest
{
protected:
  // A wall over most of the view and what lies behind it, lit, and translucent parts on both sides.
  void AddParts()
  {
    Scene.AddMesh(MeshOf({ Rectangle(-0.35, -2.0, 2.0, 2.0, 0.0) }))->GetProperty()->LightingOn();
    for (const vtkSmartPointer<vtkActor>& box : Scene.AddHidden())
    {
      box->GetProperty()->LightingOn();
    }
    for (const double z : { -0.7, 0.3 })
    {
      Scene.AddSphere(-0.3, 0.1, z, 0.25, { 0.2, 0.6, 0.9, 0.5 });
      Scene.AddSphere(-0.1, -0.2, z, 0.25, { 0.9, 0.6, 0.2, 0.4 });
    }
    Scene.AddSphere(0.6, 0.2, -0.3, 0.1, { 0.9, 0.6, 0.9, 0.4 }); // hidden
  }
};

vtkSmartPointer<vtkPolyDataMapper> MapperOf(vtkAlgorithm* source)
{
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputConnection(source->GetOutputPort());
  return mapper;
}

vtkSmartPointer<vtkVolume> MakeVolume()
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff(); // by time
  const vtkSmartPointer<vtkImageData> voxels =
    VoxelsOf(10, { 0.09, 0.09, 0.09 }, { -0.7, -0.4, -0.4 }, [](int i) { return i % 10 * 25; });
  return VolumeOf(voxels, mapper, 0.2);
}

TEST_P(CullerProps, PartsOfProps)
{
  this->AddParts();
  vtkNew<vtkCubeSource> cube;
  const vtkSmartPointer<vtkPolyDataMapper> mapper = MapperOf(cube);
  vtkNew<vtkActor> left, right;
  left->SetMapper(mapper);
  right->SetMapper(mapper);
  left->SetPosition(-3.0, 0.0, -0.2);
  right->SetPosition(0.5, 1.0, 0.1);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(left);
  assembly->AddPart(right);
  assembly->SetScale(0.2);
  Scene.Renderer->AddActor(assembly);
  vtkNew<vtkActor> one;
  one->SetMapper(mapper);
  one->SetScale(0.1);
  one->SetPosition(0.3, -0.4, -0.9);
  vtkNew<vtkPropAssembly> props;
  props->AddPart(one);
  props->AddPart(left); // it is in both
  Scene.Renderer->AddActor(props);
  Scene.Renderer->AddActor(right); // and by itself
  right->SetScale(0.3);
  Scene.ExpectHidden(230);
  EXPECT_EQ(Scene.Renderer->GetViewProps()->IsItemPresent(props) > 0, true);
}

TEST_P(CullerProps, FollowersAndLevelsOfDetail)
{
  this->AddParts();
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkFollower> follower;
  follower->SetMapper(MapperOf(cube));
  follower->SetCamera(Scene.Renderer->GetActiveCamera());
  follower->SetScale(0.5, 0.3, 0.01);
  follower->SetPosition(-0.5, -0.5, 0.2);
  Scene.Renderer->AddActor(follower);
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkLODProp3D> levels;
  levels->AddLOD(MapperOf(cube), 0.0);
  const int fine = levels->AddLOD(MapperOf(sphere), 0.0);
  levels->AutomaticLODSelectionOff(); // by time
  levels->SetSelectedLODID(fine);
  levels->SetScale(0.4);
  levels->SetPosition(-0.6, 0.5, 0.0);
  Scene.Renderer->AddViewProp(levels);
  Scene.ExpectHidden(231);
}

TEST_P(CullerProps, LevelsOfDetailHaveTheSameTime)
{
  Scene.AddWall();
  Scene.AddHidden();
  const vtkSmartPointer<vtkActor> before = Scene.AddBox({ 0.0, 0.0, 0.3 }, { 0.2, 0.2, 0.1 });
  vtkNew<vtkFrustumCoverageCuller> coverage;
  for (const bool isBehindAnother : { false, true })
  {
    if (isBehindAnother)
    {
      Scene.Renderer->RemoveCuller(Scene.Culler);
      Scene.Renderer->AddCuller(coverage);
      Scene.Renderer->AddCuller(Scene.Culler);
    }
    EXPECT_GT(Scene.ExpectSame(), 0); // at last without culling
    const double time = before->GetAllocatedRenderTime();
    Scene.Culler->CullingOn();
    Scene.Render();
    EXPECT_EQ(before->GetAllocatedRenderTime(), time);
  }
}

TEST_P(CullerProps, OverlaysAndText)
{
  this->AddParts();
  vtkNew<vtkPolyDataMapper2D> plate;
  plate->SetInputData(MeshOf({ Rectangle(3.0, 3.0, 30.0, 20.0, 0.0) }));
  vtkNew<vtkActor2D> overlay;
  overlay->SetMapper(plate);
  overlay->GetProperty()->SetOpacity(0.6);
  Scene.Renderer->AddActor2D(overlay);
  vtkNew<vtkActor2D> underlay;
  underlay->SetMapper(plate);
  underlay->SetPosition(12, 24);
  underlay->GetProperty()->SetDisplayLocationToBackground();
  Scene.Renderer->AddActor2D(underlay);
  vtkNew<vtkTextActor> text;
  text->SetInput("hidden?");
  text->SetPosition(40, 5);
  Scene.Renderer->AddActor2D(text);
  vtkNew<vtkBillboardTextActor3D> sign;
  sign->SetInput("sign");
  sign->SetPosition(0.5, 0.2, -0.5); // behind the wall
  Scene.Renderer->AddActor(sign);
  Scene.ExpectHidden(232);
}

TEST_P(CullerProps, Volumes)
{
  this->AddParts();
  Scene.Renderer->AddVolume(MakeVolume());
  Scene.ExpectHidden(233, 2);
}

// A sphere that a mapper draws in four pieces, one after the other.
TEST_P(CullerProps, MapperOfPieces)
{
  Scene.AddMesh(MeshOf({ Rectangle(-0.2, -0.2, 2.0, 2.0, 0.9) })); // hides the first piece
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.8);
  const vtkSmartPointer<vtkActor> pieces = Scene.AddSource(sphere, { 0.3, 0.8, 0.3, 1.0 });
  auto* mapper = static_cast<vtkPolyDataMapper*>(pieces->GetMapper());
  mapper->SetNumberOfSubPieces(4);
  Scene.AddHidden(-0.9);
  Scene.ExpectHidden(234);
}

/** Draws nothing, and is of no name of its own. */
class MapperOfNothing : public vtkOpenGLPolyDataMapper
{
public:
  static MapperOfNothing* New() { VTK_STANDARD_NEW_BODY(MapperOfNothing); }
  void RenderPiece(vtkRenderer*, vtkActor*) override {}
};

TEST_P(CullerProps, MapperOfAUsersThatDrawsNothing)
{
  const vtkSmartPointer<vtkActor> wall = Scene.AddWall();
  Scene.AddHidden();
  Scene.ExpectHidden(236);
  vtkNew<MapperOfNothing> nothing;
  nothing->SetInputData(vtkPolyDataMapper::SafeDownCast(wall->GetMapper())->GetInput());
  wall->SetMapper(nothing);
  Scene.ExpectNothingHidden(236);
}

TEST_P(CullerProps, Peeling)
{
  this->AddParts();
  if (Scene.Setting.Samples == 0) // VTK peels no others
  {
    Scene.Renderer->UseDepthPeelingOn();
    Scene.ExpectHidden(220, 2);
  }
  Scene.Use(vtkSmartPointer<vtkLinkedListTransparencyPass>::New());
  Scene.ExpectHidden(221, 2);
}

TEST_P(CullerProps, HiddenLinesAndSmoothEdges)
{
  this->AddParts();
  const vtkSmartPointer<vtkActor> wires =
    Scene.AddSphere(-0.4, 0.2, 0.0, 0.4, { 0.9, 0.9, 0.9, 1.0 });
  wires->GetProperty()->SetRepresentationToWireframe();
  Scene.Renderer->UseHiddenLineRemovalOn();
  Scene.ExpectHidden(222, 2);
  Scene.Renderer->UseHiddenLineRemovalOff();
  Scene.Renderer->SetUseFXAA(Scene.Setting.Samples == 0);
  Scene.ExpectHidden(223, 2);
}

// With hidden-line removal VTK draws lines nearer to the eye than they are, by the change of depth along one pixel of
// them.
TEST_P(CullerProps, HiddenLinesThatTouchAWall)
{
  Scene.AddWall();
  Scene.AddHidden();
  for (int i = 0; i < 25; ++i)
  {
    const double radius = 0.04 + 0.002 * i;
    const vtkSmartPointer<vtkActor> wires = Scene.AddSphere(
      0.3 * (i % 5) - 0.6, 0.3 * (i / 5) - 0.6, -1.001 * radius, radius, { 0.9, 0.9, 0.9, 1.0 });
    wires->GetProperty()->SetRepresentationToWireframe();
  }
  Scene.Renderer->UseHiddenLineRemovalOn();
  Scene.ExpectHidden(228, 2);
}

// Without the wires, which lie beside the view, VTK draws as if no hidden lines were to be removed.
TEST_P(CullerProps, HiddenLinesBesideTheView)
{
  this->AddParts();
  Scene.AddSphere(9.0, 0.0, 0.0, 0.3, { 0.9, 0.9, 0.9, 1.0 })
    ->GetProperty()
    ->SetRepresentationToWireframe();
  Scene.Renderer->UseHiddenLineRemovalOn();
  Scene.ExpectHidden(237, 2);
}

// Where there are wires, be it beside the view, VTK leaves ambient occlusion out.
TEST_P(CullerProps, HiddenLinesAndAmbientOcclusion)
{
  this->AddParts();
  Scene.AddSphere(9.0, 0.0, 0.0, 0.3, { 0.9, 0.9, 0.9, 1.0 })
    ->GetProperty()
    ->SetRepresentationToWireframe();
  Scene.Renderer->UseSSAOOn();
  Scene.Renderer->UseHiddenLineRemovalOn();
  Scene.ExpectNothingHidden(238, 2);
  Scene.Renderer->UseSSAOOff();
  Scene.ExpectHidden(238, 1);
}

// Lines that are seen nearly from their end are drawn beyond it, however near that is.
TEST_P(CullerProps, WireframesBehindAWall)
{
  Scene.AddWall();
  const vtkSmartPointer<vtkActor> wires =
    Scene.AddSphere(0.0, 0.0, -1.0, 0.3, { 0.9, 0.9, 0.9, 1.0 });
  Scene.ExpectHidden(235);
  wires->GetProperty()->SetRepresentationToWireframe();
  Scene.ExpectNothingHidden(235);
}

// Most of them lie between samples.
TEST_P(CullerProps, SmallWireframesBehindAWall)
{
  Scene.AddWall();
  for (int i = 0; i < 25; ++i)
  {
    Scene.AddSphere(0.1 * (i % 5) - 0.2, 0.1 * (i / 5) - 0.2, -1.0, 1e-3, { 0.9, 0.9, 0.9, 1.0 })
      ->GetProperty()
      ->SetRepresentationToWireframe();
  }
  Scene.ExpectNothingHidden(238);
  Scene.AddHidden();
  Scene.ExpectHidden(241, 1);
}

TEST_P(CullerProps, AmbientOcclusion)
{
  this->AddParts();
  Scene.Renderer->UseSSAOOn();
  Scene.Renderer->SetSSAORadius(0.3);
  Scene.Renderer->SetSSAOBias(0.01);
  Scene.ExpectNothingHidden(224, 2);
  Scene.Renderer->UseSSAOOff();
  Scene.ExpectHidden(224, 2);
}

// Where a wall in front has no normals, those of what it hides are what ambient occlusion is found by.
TEST_P(CullerProps, AmbientOcclusionThroughAnUnlitWall)
{
  for (int i = 0; i < 25; ++i)
  {
    const vtkSmartPointer<vtkActor> sphere =
      Scene.AddSphere(0.3 * (i % 5) - 0.6, 0.3 * (i / 5) - 0.6, -0.2, 0.12, { 0.9, 0.9, 0.9, 1.0 });
    sphere->GetProperty()->LightingOn();
    sphere->GetProperty()->SetInterpolationToFlat();
  }
  Scene.AddWall();
  Scene.ExpectHidden(239, 2);
  Scene.Renderer->SetSSAORadius(0.3);
  Scene.Renderer->SetSSAOBias(0.01);
  Scene.Renderer->UseSSAOOn();
  Scene.ExpectNothingHidden(239, 2);
}

// It is found at the centres of pixels, which lie between samples where those have several.
TEST_P(CullerProps, AmbientOcclusionOfWhatIsThin)
{
  Scene.Renderer->UseSSAOOn();
  Scene.Renderer->SetSSAORadius(0.3);
  Scene.Renderer->SetSSAOBias(0.01);
  Scene.LookAhead();
  const double pixel = Scene.PixelSize();
  Scene.AddMesh(MeshOf({ Rectangle(-2.0, -2.0, 2.0, 2.0, -0.5) }));
  const vtkSmartPointer<vtkActor> bar = Scene.AddMesh(
    MeshOf({ Rectangle(-0.06 * pixel, -0.3, 0.06 * pixel, 0.3, 0.0) }), { 0.1, 0.9, 0.2, 1.0 });
  const int steps = 8;
  for (int i = 0; i < steps; ++i)
  {
    SCOPED_TRACE(i);
    bar->SetPosition(pixel * i / steps, 0.0, 0.0);
    EXPECT_EQ(Scene.ExpectSame(), 0) << "ambient occlusion looks at it";
  }
  Scene.Renderer->UseSSAOOff();
  Scene.AddHidden(-0.8);
  Scene.ExpectHidden(240, 1); // behind the plate
}

// What is hidden, or lies beside the view, casts a shadow nevertheless.
TEST_P(CullerProps, Shadows)
{
  this->AddParts();
  Scene.AddMesh(MeshOf({ Rectangle(-3.0, -3.0, 3.0, 3.0, -0.9) }))->GetProperty()->LightingOn();
  Scene.AddBox({ 2.5, 0.0, 0.0 }, { 1.0, 1.0, 0.1 })->GetProperty()->LightingOn();
  vtkNew<vtkLight> light;
  light->SetPositional(true);
  light->SetConeAngle(40.0);
  light->SetPosition(5.5, 0.5, 2.5);
  light->SetFocalPoint(-0.2, 0.0, -0.7);
  Scene.Renderer->AddLight(light);
  Scene.Renderer->UseShadowsOn();
  Scene.ExpectNothingHidden(225, 2);
  Scene.Renderer->UseShadowsOff();
  Scene.ExpectHidden(225, 1);
}

// Passes that look at the bounds of all parts, or at what lies beside the view: nothing is left out.
TEST_P(CullerProps, PassesThatLookBeyondTheView)
{
  this->AddParts();
  Scene.AddBox({ 0.7, 0.6, -3.0 }, { 0.1, 0.1, 0.1 }); // far behind the wall
  for (int side = -40; side < 40; ++side)              // beside the view
  {
    Scene.AddBox({ 1.25 + 0.01 * side, -0.04 * side, 0.3 }, { 0.02, 0.02, 0.02 });
    Scene.AddBox({ 0.04 * side, 1.25 + 0.01 * side, 0.3 }, { 0.02, 0.02, 0.02 });
  }
  const vtkSmartPointer<vtkImageProcessingPass> passes[] = { vtkSmartPointer<vtkEDLShading>::New(),
    vtkSmartPointer<vtkGaussianBlurPass>::New(), vtkSmartPointer<vtkPanoramicProjectionPass>::New(),
    vtkSmartPointer<vtkSobelGradientMagnitudePass>::New() };
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkOpenGLFXAAPass> smooth;
  for (const vtkSmartPointer<vtkImageProcessingPass>& pass : passes)
  {
    SCOPED_TRACE(pass->GetClassName());
    pass->SetDelegatePass(steps);
    Scene.Renderer->SetPass(pass);
    Scene.ExpectNothingHidden(226, 2);
    pass->ReleaseGraphicsResources(Scene.Window);
  }
  smooth->SetDelegatePass(steps);
  Scene.Renderer->SetPass(smooth);
  if (Scene.Setting.Samples == 0)
  {
    Scene.ExpectHidden(227, 2);
  }
  smooth->ReleaseGraphicsResources(Scene.Window);
  Scene.Renderer->SetPass(nullptr);
  Scene.ExpectHidden(227, 1);
}

// Tests nested passes that look beyond the view, passes that do not draw what would hide other parts, and unknown
// passes.
TEST_P(CullerProps, PassesWithinPasses)
{
  this->AddParts();
  Scene.AddBox({ 0.7, 0.6, -3.0 }, { 0.1, 0.1, 0.1 }); // far behind the wall
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkTranslucentPass> translucent;
  vtkNew<vtkClearZPass> clear;
  vtkNew<vtkEDLShading> shading;
  vtkNew<vtkRenderStepsPass> steps, transparent;
  shading->SetDelegatePass(steps);
  transparent->SetOpaquePass(nullptr);
  const std::pair<const char*, vtkSmartPointer<vtkRenderPass>> unsafe[] = {
    { "EDL", ByCamera(InSequence({ shading })) },
    { "translucent", ByCamera(InSequence({ lights, translucent })) },
    { "steps without opaque ones", transparent },
    { "depth that is cleared", ByCamera(InSequence({ lights, opaque, clear, translucent })) },
    { "a user's", vtkSmartPointer<UnknownPass>::New() },
  };
  for (const auto& [name, pass] : unsafe)
  {
    SCOPED_TRACE(name);
    Scene.Renderer->SetPass(pass);
    Scene.ExpectNothingHidden(229, 1);
    pass->ReleaseGraphicsResources(Scene.Window);
  }
  Scene.Renderer->SetPass(ByCamera(InSequence({ lights, opaque, translucent })));
  Scene.ExpectHidden(229, 1);
  Scene.Renderer->SetPass(nullptr);
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerProps, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
