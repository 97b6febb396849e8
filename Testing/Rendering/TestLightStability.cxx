// Scenes in which other implementations of clustered lighting lost lights or flickered, each as VTK draws it.
#include "StableScene.h"
#include "TestMessages.h"
#include "gl/Capabilities.h"
#include "gl/GLObjects.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPBRIrradianceTexture.h"
#include "vtkPBRLUTTexture.h"
#include "vtkPBRPrefilterTexture.h"
#include "vtkTexture.h"
#include "vtkVersionMacros.h"

#include <gtest/gtest.h>

namespace
{

void SetProjection(vtkCamera* camera, const double (&elements)[16])
{
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(elements);
  camera->SetExplicitProjectionTransformMatrix(matrix);
  camera->UseExplicitProjectionTransformMatrixOn();
}

// Godot's touches_near flag, Bevy's clamp of z, PlayCanvas #4795.
TEST(StableLights, MayCrossTheNearPlane)
{
  StableScene scene;
  for (const double near : { 1.8, 2.4, 2.7 }) // the last ones cut spheres open
  {
    SCOPED_TRACE(near);
    scene.Camera()->SetClippingRange(near, 5.0);
    scene.Shine({ { { 0.3, 0.4, 2.9 - near }, { 0.0, 0.0, 0.0 }, 20.0 },
      { { 0.4, 0.5, 3.1 - near }, { 0.1, 0.1, -0.5 }, 50.0 },
      { { 1.2, 0.3, 3.0 - near }, { -1.0, 0.0, 2.9 - near }, 12.0 },
      { { 0.0, -0.3, 3.0 - near }, { 0.0, 0.0, 0.0 }, 180.0, 30.0 } });
    scene.ExpectStable();
  }
}

// Godot and Bevy likewise.
TEST(StableLights, MayHaveTheCameraWithin)
{
  StableScene scene;
  const Place eye = { 0.4, 0.5, 3.0 };
  scene.Shine({ { eye, { 0.0, 0.0, 0.0 }, 8.0 }, { eye, { 0.3, 0.2, 0.0 }, 180.0, 1.0 },
    { { 0.4, 0.5, 3.2 }, { 0.2, 0.2, 0.0 }, 4.0 },
    { { 0.6, 0.6, 3.5 }, { 0.0, 0.0, -0.5 }, 180.0, 2.0 } });
  scene.ExpectStable();
}

TEST(StableLights, MayBeBehindTheCamera)
{
  StableScene scene;
  scene.Shine({ { { 0.0, 0.0, 9.0 }, { 0.0, 0.0, 0.0 }, 3.0 },
    { { 30.0, -20.0, 40.0 }, { 0.3, 0.2, 0.0 }, 0.6 },
    { { -5.0, 1.0, 3.5 }, { 0.0, 0.0, 0.0 }, 6.0 }, { { 0.0, 0.0, 9.0 }, { 0.0, 0.0, 20.0 }, 30.0 },
    { { 0.5, 0.5, 5.0 }, { 0.0, 0.0, 0.0 }, 180.0, 0.2 } });
  scene.ExpectStable();
}

// Godot #48054, #36117, #71832; Filament's precision below 0.5 degrees.
TEST(StableLights, MayBeSpotsOfAnyAngle)
{
  StableScene scene;
  for (const double angle : { 0.3, 5.0, 30.0, 60.0, 85.0, 89.9, 90.0, 120.0 })
  {
    SCOPED_TRACE(angle);
    // A cone of 0.3 degrees is seen from far away.
    scene.Shine({ { { 60.0, 20.0, 100.0 }, { 0.4, 0.0, 0.1 }, angle },
      { { 0.0, 30.0, 90.0 }, { -0.4, 0.3, 0.1 }, angle },
      { { 1.0, 0.9, 0.6 }, { 0.0, 0.0, -0.5 }, angle },
      { { -1.0, 0.9, 0.6 }, { 0.0, -0.3, -0.5 }, angle, 1.0 } });
    scene.ExpectStable();
  }
}

// Godot #81772, #110367.
TEST(StableLights, MayReachFarBeyondAFarPlaneNearBy)
{
  StableScene scene;
  scene.Camera()->SetClippingRange(1.0, 3.6);
  scene.Shine({ { { 0.0, 80.0, 60.0 }, { 0.0, -2.0, -1.5 }, 40.0 },
    { { -300.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 }, 2.0 },
    { { 0.0, 0.0, -0.6 }, { 0.0, 300.0, 200.0 }, 70.0 },
    { { 0.0, 0.0, 400.0 }, { 0.0, 0.0, -1000.0 }, 1.0, 1e-6 } });
  scene.ExpectStable();
}

// Filament #5318, s&box #4620. VTK moves a near plane that is not before the eye, unless the user set the projection.
TEST(StableLights, MayBeSeenByParallelRaysFromBehindTheEye)
{
  StableScene scene(true);
  scene.Camera()->SetPosition(0.0, 0.0, 0.2);
  scene.Camera()->SetFocalPoint(0.0, 0.0, -1.0);
  scene.Camera()->SetClippingRange(-2.0, 3.0);
  scene.ShineAround(25.0);
  scene.ExpectStable();
  for (const double near : { -2.0, 0.0, 0.1 })
  {
    SCOPED_TRACE(near);
    const double far = 3.0, depth = far - near;
    SetProjection(scene.Camera(),
      { 0.8, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2 / depth, -(far + near) / depth, 0, 0, 0, 1 });
    scene.ShineAround(25.0);
    scene.ExpectStable();
    EXPECT_EQ(scene.Lights->GetNumberOfClusters(), 4 * 3 * 16);
    scene.ShineAround(180.0, 20.0);
    scene.ExpectStable();
  }
}

// Filament #3141.
TEST(StableLights, MayBeBeyondFarAndBeforeNear)
{
  StableScene scene;
  for (const double shift : { -0.02, 0.0, 0.02 }) // across both planes
  {
    SCOPED_TRACE(shift);
    scene.Camera()->SetClippingRange(2.2, 3.55);
    scene.Shine({ { { 0.4, 0.4, 0.8 + shift }, { 0.2, 0.1, 0.0 }, 40.0 },
      { { 0.1, 0.0, -0.6 + shift }, { 0.1, 0.0, 1.0 }, 30.0 },
      { { 0.0, 0.3, -8.0 }, { 0.1, 0.1, 1.0 }, 5.0 },
      { { 0.0, 0.0, -0.5 + shift }, { 0.0, 0.0, 9.0 }, 180.0, 10.0 },
      { { -0.6, 0.0, 0.8 + shift }, { 0.0, 0.0, 0.0 }, 180.0, 10.0 } });
    scene.ExpectStable();
  }
}

// Filament #3142.
TEST(StableLights, MayGraze)
{
  StableScene scene;
  scene.Camera()->SetPosition(0.0, -4.0, -0.4);
  scene.Camera()->SetFocalPoint(0.0, 4.0, -0.45);
  scene.Camera()->SetViewUp(0.0, 0.0, 1.0);
  scene.Camera()->SetClippingRange(0.5, 30.0);
  scene.ShineAround(30.0);
  scene.ExpectStable();
  scene.Shine({ { { 0.0, -5.0, -0.49 }, { 0.0, 0.0, -0.5 }, 10.0 },
    { { 2.0, 3.0, -0.49 }, { -2.0, 2.5, -0.5 }, 5.0 },
    { { -1.5, -2.0, 0.0 }, { 0.0, 2.0, -0.5 }, 15.0 },
    { { 1.0, -2.5, -0.4 }, { 0.0, 0.0, 0.0 }, 180.0, 20.0 } });
  scene.ExpectStable();
}

// Filament #7493 lost lights beyond 256, and Bevy #3915 lost all of them at 256. three.js #33406 has room for 64. All
// lights but the last are too faint to change VTK's picture of that one.
TEST(StableLights, AreAllThereWhereManyAreInOneCluster)
{
  StableScene scene;
  scene.SetGrid(
    4096, 1); // of the lights, VTK's picture has one alone; the others are too faint to change it
  const auto seen = scene.AddBeam({ { 0.5, 0.7, 1.0 }, { 0.0, 0.0, 0.0 }, 40.0 });
  const Picture expected = scene.InVTKsLight();
  for (const int faint : { 255, 256, 511 })
  {
    SCOPED_TRACE(faint);
    scene.Renderer->RemoveAllLights();
    for (int i = 0; i < faint; ++i)
    {
      scene.AddLight(LightKind::Point, 1e-12);
    }
    scene.Renderer->AddLight(seen);
    scene.ExpectFrames(expected, 0);
    EXPECT_EQ(scene.Lights->GetMaximumNumberOfLightsPerCluster(), faint + 1);
  }
}

// EEVEE counts in 16 bits, and so do lists here while there are no more lights than that.
TEST(StableLights, MayBeMoreThan65536)
{
  StableScene scene;
  const Beam beam = { { 0.5, 0.7, 1.0 }, { 0.0, 0.0, 0.0 }, 40.0 };
  scene.AddBeam(beam);
  const Picture expected = scene.InVTKsLight();
  scene.Shine(std::vector<Beam>(65535, { { 0.0, 0.0, 9.0 }, { 0.0, 0.0, 20.0 }, 30.0 }));
  const auto away = scene.AddBeam({ { 0.0, 0.0, 9.0 }, { 0.0, 0.0, 20.0 }, 30.0 });
  const auto seen = scene.AddBeam(beam);
  for (const int lights : { 65537, 65536 })
  {
    SCOPED_TRACE(lights);
    away->SetSwitch(lights == 65537);
    EXPECT_TRUE(Matches(scene.InClusteredLight(), expected));
    EXPECT_TRUE(Matches(scene.InDeferredLight(), expected));
    EXPECT_EQ(scene.Lights->GetNumberOfLights(), lights);
  }
}

// llvmpipe ends the loops of a shader after so many turns, which no picture tells.
TEST(StableLights, AreSaidToBeMissingWhereADriverEndsLoops)
{
  StableScene scene;
  scene.Window->SetSize(7, 5); // every pixel goes through thousands of lights
  scene.SetGrid(4096, 1);
  const auto seen = scene.AddBeam({ { 0.5, 0.7, 1.0 }, { 0.0, 0.0, 0.0 }, 40.0 });
  const Picture expected = scene.InVTKsLight();
  scene.Renderer->RemoveAllLights();
  for (int i = 0; i < 49999; ++i)
  {
    scene.AddLight(LightKind::Point, 1e-12);
  }
  scene.Renderer->AddLight(seen);
  EXPECT_TRUE(Matches(scene.InClusteredLight(), expected));
  EXPECT_TRUE(Matches(scene.InDeferredLight(), expected));
  EXPECT_EQ(TakeMessages(), std::vector<std::string>());
  scene.AddLight(LightKind::Point, 1e-12);
  scene.InClusteredLight();
  scene.InClusteredLight();
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), vitrine::IsSoftwareRasteriser() ? 1u : 0u);
  for (const std::string& message : messages)
  {
    EXPECT_NE(message.find("more than 50,000 lights"), std::string::npos) << message;
  }
}

// Bevy, three.js #33749: what is round is not symmetric in perspective, the less so aside.
TEST(StableLights, MayBeInViewsToOneSide)
{
  StableScene scene;
  for (const std::array<double, 2> centre :
    { std::array{ 0.7, -0.4 }, { -1.5, 0.2 }, { 0.1, 1.2 } })
  {
    SCOPED_TRACE(centre[0]);
    scene.Camera()->SetWindowCenter(centre[0], centre[1]);
    scene.Camera()->SetViewAngle(60.0);
    scene.ShineAround(20.0);
    scene.ExpectStable();
    scene.ShineAround(180.0, 40.0);
    scene.ExpectStable();
  }
}

// Of an eye that is not the origin, or a screen that is turned away, VTK makes a projection that does not go along z.
TEST(StableLights, MayBeInOffAxisViews)
{
  if (VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION > 2)
  {
    GTEST_SKIP() << "from VTK 9.3 on, eye and screen stand in the world, not before the camera";
  }
  StableScene scene;
  scene.Camera()->UseOffAxisProjectionOn();
  for (const std::array<double, 2> off : { std::array{ 0.0, 0.0 }, { 0.3, 0.0 }, { 0.3, 0.4 } })
  {
    const auto [eye, turned] = off;
    SCOPED_TRACE(testing::Message() << eye << " " << turned);
    scene.Camera()->SetEyePosition(Place{ 0.2, 0.1, eye }.data());
    scene.Camera()->SetScreenBottomLeft(-0.9, -0.8, -1.5);
    scene.Camera()->SetScreenBottomRight(1.4, -0.8, turned - 1.5);
    scene.Camera()->SetScreenTopRight(1.4, 0.9, turned - 1.5);
    scene.ShineAround(20.0);
    scene.ExpectStable();
    scene.ShineAround(180.0, 40.0);
    scene.ExpectStable();
    EXPECT_EQ(scene.Lights->GetNumberOfClusters() > 1, eye == 0.0);
  }
}

TEST(StableLights, MayBeInSlantedViews)
{
  for (const bool isParallel : { false, true })
  {
    StableScene scene(isParallel);
    const double slanted[16] = { 1, 0.3, 0.2, 0.1, 0, 0.8, -0.4, 0, 0.1, 0, 1.1, -2.0, 0, 0, 0, 1 };
    scene.Camera()->SetModelTransformMatrix(slanted);
    scene.Camera()->SetClippingRange(1.0, 9.0);
    scene.Shine({ { { 0.5, 0.6, 1.2 }, { 0.5, 0.6, -0.5 }, 12.0 },
      { { -0.9, 0.7, 0.9 }, { -0.9, 0.7, -0.5 }, 15.0 },
      { { 0.9, -0.8, 0.2 }, { 0.9, -0.8, -0.5 }, 20.0 } }); // straight down at the wall
    scene.ExpectStable();
    scene.ShineAround(20.0);
    scene.ExpectStable();
    scene.ShineAround(180.0, 40.0);
    scene.ExpectStable();
  }
}

// Depths leave no bits for what is far then, and slices are few.
TEST(StableLights, MayBeAMillionTimesAsFarAsNearIs)
{
  StableScene scene;
  for (const double near : { 5e-6, 1e-3 })
  {
    SCOPED_TRACE(near);
    scene.Camera()->SetClippingRange(near, 1e6 * near);
    scene.ShineAround(20.0);
    scene.ExpectStable();
    scene.ShineAround(180.0, 40.0);
    scene.ExpectStable();
  }
}

// VTK fits the clipping range to what is seen in each frame, so the grid moves.
TEST(StableLights, DoNotFollowTheGrid)
{
  StableScene scene;
  scene.ShineAround(20.0);
  const Picture expected = scene.InVTKsLight();
  for (int i = 0; i < 10; ++i)
  {
    SCOPED_TRACE(i);
    scene.Camera()->SetClippingRange(
      0.9 + 0.5 * scene.Random.Unit(), 4.6 + 0.5 * scene.Random.Unit());
    ASSERT_TRUE(Matches(expected, scene.InVTKsLight()));
    scene.SetGrid(16 << i % 3, std::array{ 1, 3, 16, 64 }[i % 4]);
    scene.ExpectFrames(expected, 0);
  }
}

/** All of the current context's. */
int CountPrograms()
{
  int count = 0;
  for (GLuint name = 1; name < 4096; ++name)
  {
    count += glIsProgram(name) ? 1 : 0;
  }
  return count;
}

// luma.gl #2751 went through more lights than there were.
TEST(StableLights, ComeAndGoWithoutAShader)
{
  StableScene scene;
  const auto expectLights = [&](int count)
  {
    scene.Renderer->RemoveAllLights();
    scene.AddLights(count / 2);
    scene.AddLight(LightKind::Directional);
    scene.ExpectFrames(scene.InClusteredLight(), 0);
    EXPECT_EQ(scene.Lights->GetNumberOfLights(), count);
  };
  expectLights(5);
  const int programs = CountPrograms();
  EXPECT_GT(programs, 5);
  expectLights(41);
  expectLights(7);
  EXPECT_EQ(CountPrograms(), programs);
}

/** Layers of what is translucent are rounded one by one, and take shaders of their own. */
void HideTranslucent(DeferredScene& scene)
{
  for (const int translucent : { 1, 3 })
  {
    scene.Parts[translucent]->VisibilityOff();
  }
}

/** Gives a scene surroundings that it mirrors, small ones. */
void AddSurroundings(vtkRenderer* renderer)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 32, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 64 * 32 * 3; ++i)
  {
    static_cast<unsigned char*>(image->GetScalarPointer())[i] = static_cast<unsigned char>(i / 25);
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->MipmapOn();
  texture->InterpolateOn();
  auto* const opengl = static_cast<vtkOpenGLRenderer*>(renderer);
  opengl->GetEnvMapLookupTable()->SetLUTSize(16);
  opengl->GetEnvMapLookupTable()->SetLUTSamples(16);
  opengl->GetEnvMapIrradiance()->SetIrradianceSize(8);
  opengl->GetEnvMapPrefiltered()->SetPrefilterLevels(2);
  opengl->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(16);
  opengl->UseSphericalHarmonicsOff();
  opengl->SetEnvironmentTexture(texture);
  opengl->UseImageBasedLightingOn();
}

// three.js #34003 dropped lights where there were surroundings.
TEST(StableLights, MayShineWhereThereAreSurroundings)
{
  StableScene scene(false, true);
  HideTranslucent(scene);
  scene.ShineAround(20.0);
  const Picture before = scene.InVTKsLight();
  AddSurroundings(scene.Renderer);
  const Picture expected = scene.InVTKsLight();
  EXPECT_GT(LargestDifference(before, expected), 5);
  scene.ExpectFrames(expected, 0);
}

// What a light gives that is cut in one frame and not in the next is below the cut-off.
TEST(StableLights, DoNotPopWhileTheCameraTurns)
{
  StableScene scene;
  HideTranslucent(scene);
  for (int i = 0; i < 12; ++i)
  {
    scene.AddLight(LightKind::Point, 0.5, 3e3);
  }
  scene.AddLight(LightKind::Directional, 0.2);
  scene.SetCutOff(0.5 / 255.0);
  for (int i = 0; i < 12; ++i)
  {
    SCOPED_TRACE(i);
    scene.Camera()->Azimuth(1.5);
    scene.Camera()->Elevation(0.5);
    scene.ExpectFrames(scene.InVTKsLight(), 1);
    EXPECT_LT(scene.Lights->GetMeanNumberOfLightsPerCluster(), 0.8 * 13);
  }
}

// VTK writes a block of shader for each light, which takes it seconds to compile.
void ExpectKinds(int count, bool isPhysical)
{
  DeferredScene scene(false, isPhysical);
  HideTranslucent(scene);
  for (int i = 0; i < count; ++i)
  {
    scene.AddLight(AllLightKinds[i % AllLightKinds.size()], 3.0 / count);
  }
  const Picture expected = scene.InVTKsLight();
  EXPECT_TRUE(Matches(scene.InClusteredLight(), expected));
  scene.ExpectAsVTK(DeferredParts);
}

TEST(StableLights, AreVTKsWhere64OfAllKindsShineOnPhongs)
{
  ExpectKinds(64, false);
}

TEST(StableLights, AreVTKsWhere32OfAllKindsShineOnPhysicalSurfaces)
{
  ExpectKinds(32, true);
}

}
