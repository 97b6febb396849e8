// Tests that props' settings and their targets do not change light, depth that images or keys ask to be written, and
// colours beyond 1.
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkImageProperty.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceMapper.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLight.h"
#include "vtkLightKit.h"
#include "vtkOpenGLActor.h"
#include "vtkProperty.h"
#include "vtkSeeThroughPass.h"
#include "vtkShaderProperty.h"
#include "vtkToneMappingPass.h"
#include "vtkTranslucentPass.h"

#include <gtest/gtest.h>

#include <functional>

namespace
{

constexpr int Width = 61;
constexpr int Height = 47;

// What Core/shader/ShaderTuning changes in shaders shows in no picture: one lit layer under every kind of light.
TEST(Lighting, OfOneLayerIsVTKs)
{
  const std::function<void(TestScene&)> lights[] = {
    [](TestScene&) {},
    [](TestScene& scene)
    {
      vtkNew<vtkLightKit> kit;
      kit->AddLightsToRenderer(scene.Renderer);
    },
    [](TestScene& scene)
    {
      vtkNew<vtkLight> light;
      light->SetPositional(true);
      light->SetPosition(0.5, 0.7, 1.5);
      light->SetFocalPoint(0.0, 0.0, 0.0);
      light->SetConeAngle(30.0);
      light->SetColor(1.0, 0.9, 0.5);
      scene.Renderer->AddLight(light);
    },
    [](TestScene& scene)
    {
      for (const double x : { -0.9, 0.1, 0.8 })
      {
        vtkNew<vtkLight> light;
        light->SetPositional(true);
        light->SetPosition(x, 0.7, 1.5);
        light->SetConeAngle(x > 0.5 ? 30.0 : 90.0);
        light->SetColor(0.4, 0.3 + 0.1 * x, 0.5);
        scene.Renderer->AddLight(light);
      }
    },
  };
  for (const auto& light : lights)
  {
    for (const double specular : { 0.0, 0.5 })
    {
      SCOPED_TRACE(std::to_string(&light - lights) + ", specular " + std::to_string(specular));
      TestScene scene(Width, Height);
      light(scene);
      // Opaque to the eye, so that blending rounds nothing.
      const vtkSmartPointer<vtkActor> actor =
        scene.AddSphere(0.0, 0.0, 0.0, 0.8, { 0.9, 0.6, 0.3, 1.0 });
      actor->ForceTranslucentOn();
      vtkProperty* property = actor->GetProperty();
      property->SetSpecular(specular);
      property->SetSpecularPower(12.0);
      property->SetAmbient(0.1);
      property->BackfaceCullingOn();
      vtkNew<vtkTranslucentPass> blending;
      scene.Use(blending);
      const Picture expected = scene.Render();
      for (const Method& method : AllMethods())
      {
        const vtkSmartPointer<vtkTransparencyPass> pass = method.Make();
        scene.Use(pass);
        // Storage rounds, but in truth.
        EXPECT_TRUE(
          Matches(scene.Render(), expected, method.Name == "Truth" ? 0 : 1, method.EdgeShare))
          << method.Name;
        EXPECT_EQ(pass->GetMaximumNumberOfLayers(), 1);
      }
    }
  }
}

// VTK's images write depth by default, text in space (an image) too.
TEST(Images, HideNothingInAnyOrder)
{
  const std::vector<Rgba> plates = { { 0.8, 0.2, 0.2, 0.4 }, { 0.2, 0.6, 0.4, 0.5 },
    { 0.2, 0.2, 0.8, 0.3 } };
  const unsigned char texel[3] = { 51, 153, 102 }; // the second plate
  for (const Method& method : AllMethods())
  {
    for (const bool imageFirst : { true, false })
    {
      TestScene scene(Width, Height);
      vtkNew<vtkImageData> image;
      image->SetDimensions(2, 2, 1);
      image->SetSpacing(4.0, 4.0, 1.0);
      image->SetOrigin(-2.0, -2.0, 0.0);
      image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
      for (int i = 0; i < 12; ++i)
      {
        static_cast<unsigned char*>(image->GetScalarPointer())[i] = texel[i % 3];
      }
      vtkNew<vtkImageSliceMapper> mapper;
      mapper->SetInputData(image);
      vtkNew<vtkImageSlice> slice;
      slice->SetMapper(mapper);
      slice->GetProperty()->SetOpacity(plates[1][3]);
      slice->ForceTranslucentOn();
      if (imageFirst)
      {
        scene.Renderer->AddViewProp(slice);
      }
      scene.AddPlate(0.5, plates[0]);
      scene.AddPlate(-0.5, plates[2]);
      if (!imageFirst)
      {
        scene.Renderer->AddViewProp(slice);
      }
      const vtkSmartPointer<vtkTransparencyPass> pass = method.Make();
      scene.Use(pass);
      SCOPED_TRACE(method.Name + (imageFirst ? ", image first" : ""));
      ExpectColor(
        UniformColor(scene.Render()), CompositePlates(plates, TestBackground), method.Tolerance);
      EXPECT_EQ(pass->GetNumberOfFragments(), 3 * Width * Height);
    }
  }
}

// Keys that an application set are left alone.
TEST(PropertyKeys, ThatAskForDepthToBeWrittenHideNothing)
{
  TestScene scene(Width, Height);
  const std::vector<Rgba> plates = RandomPlates(5, 0.4, 31);
  std::vector<vtkSmartPointer<vtkActor>> actors;
  for (const int i : { 3, 0, 1, 4, 2 })
  {
    actors.push_back(scene.AddPlate(0.5 - 0.2 * i, plates[i]));
    vtkNew<vtkInformation> keys;
    keys->Set(vtkOpenGLActor::GLDepthMaskOverride(), 1);
    actors.back()->SetPropertyKeys(keys);
  }
  for (const Method& method : AllMethods())
  {
    const vtkSmartPointer<vtkTransparencyPass> pass = method.Make();
    scene.Use(pass);
    SCOPED_TRACE(method.Name);
    ExpectColor(
      UniformColor(scene.Render()), CompositePlates(plates, TestBackground), method.Tolerance);
    EXPECT_EQ(pass->GetNumberOfFragments(), 5 * Width * Height);
  }
  EXPECT_EQ(actors[0]->GetPropertyKeys()->Get(vtkOpenGLActor::GLDepthMaskOverride()), 1);
}

// A target that holds colours beyond 1: methods that keep 8 bits end there, in each channel by itself, others do not.
class FloatTarget : public testing::TestWithParam<Method>
{
};

TEST_P(FloatTarget, HoldsColorsBeyondOneWhereTheMethodDoes)
{
  TestScene scene(Width, Height);
  scene.AddPlate(0.0, { 0.8, 0.2, 0.1, 0.5 })
    ->GetShaderProperty()
    ->AddFragmentShaderReplacement(
      "//VTK::Light::Impl", false, "//VTK::Light::Impl\n  gl_FragData[0].rgb *= 2.0;\n", false);
  vtkNew<vtkSeeThroughPass> seeThrough;
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  seeThrough->SetTranslucentPass(pass);
  vtkNew<vtkToneMappingPass> toneMapping;
  toneMapping->SetToneMappingType(vtkToneMappingPass::Clamp);
  toneMapping->SetDelegatePass(seeThrough);
  scene.Renderer->SetPass(toneMapping);
  const Rgba color = UniformColor(scene.Render());
  EXPECT_STREQ(pass->GetFallbackReason(), "");
  const double red = GetParam().KeepsEightBits() ? 1.0 : 1.6;
  const Rgba expected = CompositePlates({ { red, 0.4, 0.2, 0.5 } }, TestBackground);
  ExpectColor(
    { color[0], color[1], color[2], expected[3] }, expected, 1.4); // alpha is tone mapping's
}

INSTANTIATE_TEST_SUITE_P(Methods, FloatTarget, testing::ValuesIn(AllMethods()), MethodName());

}
