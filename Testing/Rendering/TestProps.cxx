// What VTK can draw translucently: each kind of prop, mapper and property by every method, against truth.
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkElevationFilter.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkImageProperty.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceMapper.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLight.h"
#include "vtkLightKit.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSeeThroughPass.h"
#include "vtkShaderProperty.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkToneMappingPass.h"
#include "vtkTranslucentPass.h"
#include "vtkUnsignedCharArray.h"

#if __has_include("vtkCompositePolyDataMapper2.h") // up to VTK 9.2
#include "vtkCompositePolyDataMapper2.h"
using CompositeMapper = vtkCompositePolyDataMapper2;
#else
#include "vtkCompositePolyDataMapper.h"
using CompositeMapper = vtkCompositePolyDataMapper;
#endif

#include <gtest/gtest.h>

#include <functional>

namespace
{

constexpr int Width = 61;
constexpr int Height = 47;

// Parts before, behind and within whatever a test adds.
void AddSurroundings(TestScene& scene)
{
  scene.AddSphere(-0.5, 0.2, 0.1, 0.4, { 0.8, 0.8, 0.8, 1.0 });
  scene.AddRectangle(-0.9, -0.6, 0.7, 0.5, -0.2, { 0.9, 0.4, 0.1, 0.4 });
  scene.AddRectangle(-0.3, -0.8, 0.9, 0.3, 0.6, { 0.1, 0.4, 0.9, 0.3 });
}

vtkSmartPointer<vtkActor> AddCone(TestScene& scene)
{
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(12);
  cone->SetHeight(1.4);
  cone->SetDirection(0.3, 1.0, 0.5);
  return scene.AddSource(cone, { 0.3, 0.9, 0.3, 0.5 });
}

struct Kind
{
  const char* Name;
  std::function<void(TestScene&)> Add;
};

void PrintTo(const Kind& kind, std::ostream* os)
{
  *os << kind.Name;
}

void AddElevation(TestScene& scene)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.7);
  vtkNew<vtkElevationFilter> elevation;
  elevation->SetInputConnection(sphere->GetOutputPort());
  elevation->SetLowPoint(0.0, -0.7, 0.0);
  elevation->SetHighPoint(0.0, 0.7, 0.0);
  vtkNew<vtkLookupTable> table;
  table->SetAlphaRange(0.2, 0.9);
  table->Build();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(elevation->GetOutputPort());
  mapper->SetLookupTable(table);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
}

// A chessboard of half transparent and fully transparent texels.
void AddTextured(TestScene& scene)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (int i = 0; i < 64; ++i)
  {
    auto* texel = static_cast<unsigned char*>(image->GetScalarPointer(i % 8, i / 8, 0));
    texel[0] = static_cast<unsigned char>(30 * (i % 8));
    texel[1] = 200;
    texel[2] = 80;
    texel[3] = (i + i / 8) % 2 == 0 ? 150 : 0;
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-0.8, -0.7, -0.4);
  plane->SetPoint1(0.8, -0.7, 0.4);
  plane->SetPoint2(-0.8, 0.7, -0.4);
  const vtkSmartPointer<vtkActor> actor = scene.AddSource(plane, { 1.0, 1.0, 1.0, 1.0 });
  actor->SetTexture(texture);
  actor->ForceTranslucentOn();
}

void AddClipped(TestScene& scene)
{
  const vtkSmartPointer<vtkActor> actor = AddCone(scene);
  for (const double x : { 0.8, -0.3 })
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(-0.1, -0.2, 0.0);
    plane->SetNormal(x, 1.0, 0.2);
    actor->GetMapper()->AddClippingPlane(plane);
  }
}

void AddComposite(TestScene& scene)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 3; ++i)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(0.5);
    sphere->SetCenter(0.4 * i - 0.4, 0.0, 0.0);
    sphere->Update();
    blocks->SetBlock(i, sphere->GetOutput());
  }
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  const double colors[3][3] = { { 1.0, 0.2, 0.2 }, { 0.2, 1.0, 0.2 }, { 0.2, 0.2, 1.0 } };
  for (unsigned int i = 0; i < 3; ++i)
  {
    mapper->SetBlockColor(i + 1, colors[i]);
    mapper->SetBlockOpacity(i + 1, i == 2 ? 1.0 : 0.3 + 0.2 * i);
  }
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
}

vtkSmartPointer<vtkPolyData> MakePoints()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  TestRandom random(41);
  for (vtkIdType i = 0; i < 12; ++i)
  {
    const double x = 1.2 * random.Unit() - 0.6;
    const double y = random.Unit() - 0.5;
    points->InsertNextPoint(x, y, random.Unit() - 0.5);
    vertices->InsertNextCell({ i });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(vertices);
  return data;
}

void AddGlyphs(TestScene& scene)
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(MakePoints());
  mapper->SetSourceConnection(cube->GetOutputPort());
  mapper->SetScaleFactor(0.3);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(0.4);
  scene.Renderer->AddActor(actor);
}

void AddSphereImpostors(TestScene& scene)
{
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(MakePoints());
  mapper->SetRadius(0.3);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(0.4);
  actor->GetProperty()->SetColor(0.9, 0.8, 0.2);
  scene.Renderer->AddActor(actor);
}

void AddPoints(TestScene& scene, bool asSpheres)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakePoints());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetPointSize(9.0);
  actor->GetProperty()->SetRenderPointsAsSpheres(asSpheres);
  actor->GetProperty()->SetOpacity(0.4);
  scene.Renderer->AddActor(actor);
}

void AddWireframe(TestScene& scene, double width, bool asTubes)
{
  const vtkSmartPointer<vtkActor> actor = AddCone(scene);
  actor->GetProperty()->SetRepresentationToWireframe();
  actor->GetProperty()->SetLineWidth(width);
  actor->GetProperty()->SetRenderLinesAsTubes(asTubes);
}

void AddImage(TestScene& scene)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(9, 9, 1);
  image->SetSpacing(0.2, 0.15, 1.0);
  image->SetOrigin(-0.8, -0.6, 0.2);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 81 * 3; ++i)
  {
    static_cast<unsigned char*>(image->GetScalarPointer())[i] =
      static_cast<unsigned char>(i * 37 % 256);
  }
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(image);
  vtkNew<vtkImageSlice> slice;
  slice->SetMapper(mapper);
  slice->GetProperty()->SetOpacity(0.5);
  scene.Renderer->AddViewProp(slice);
}

const Kind Kinds[] = {
  { "Cone", [](TestScene& s) { AddCone(s); } },
  { "ScalarsWithAlpha", AddElevation },
  { "TextureWithAlpha", AddTextured },
  { "ClippingPlanes", AddClipped },
  { "CompositeBlocks", AddComposite },
  { "Glyphs", AddGlyphs },
  { "SphereMapper", AddSphereImpostors },
  { "Points", [](TestScene& s) { AddPoints(s, false); } },
  { "PointsAsSpheres", [](TestScene& s) { AddPoints(s, true); } },
  { "Lines", [](TestScene& s) { AddWireframe(s, 1.0, false); } },
  { "WideLines", [](TestScene& s) { AddWireframe(s, 6.0, false); } },
  { "LinesAsTubes", [](TestScene& s) { AddWireframe(s, 8.0, true); } },
  { "Image", AddImage },
  { "VisibleEdges", [](TestScene& s) { AddCone(s)->GetProperty()->EdgeVisibilityOn(); } },
  { "BackfaceProperty",
    [](TestScene& s)
    {
      vtkNew<vtkProperty> back;
      back->SetColor(0.9, 0.1, 0.6);
      back->SetOpacity(0.7);
      AddCone(s)->SetBackfaceProperty(back);
    } },
  { "BackfaceCulling", [](TestScene& s) { AddCone(s)->GetProperty()->BackfaceCullingOn(); } },
  { "FrontfaceCulling", [](TestScene& s) { AddCone(s)->GetProperty()->FrontfaceCullingOn(); } },
  { "FlatShading", [](TestScene& s) { AddCone(s)->GetProperty()->SetInterpolationToFlat(); } },
  { "PhysicallyBased", [](TestScene& s) { AddCone(s)->GetProperty()->SetInterpolationToPBR(); } },
  { "CoincidentOffsets",
    [](TestScene& s)
    {
      for (const double offset : { 0.0, -40000.0, -2000.0, 2000.0, 40000.0 })
      {
        const vtkSmartPointer<vtkActor> actor = s.AddRectangle(
          -0.7, -0.5 - 1e-6 * offset, 0.6, 0.4, 0.1, { 0.5, 0.9, 0.9 + 1e-6 * offset, 0.5 });
        actor->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
        actor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, offset);
      }
    } },
};

class Props : public testing::TestWithParam<Kind>
{
  void TearDown() override { vtkMapper::SetResolveCoincidentTopologyToDefault(); }
};

TEST_P(Props, AreTruth)
{
  TestScene scene(Width, Height);
  AddSurroundings(scene);
  vtkNew<vtkTranslucentPass> blending;
  scene.Use(blending);
  const Picture without = scene.Render();
  GetParam().Add(scene);
  EXPECT_FALSE(scene.Render() == without) << "nothing was added";
  // One of the blocks is opaque, and meets the others.
  ExpectAllAreTruth(scene, 1.0, GetParam().Name == std::string("CompositeBlocks") ? 0.002 : 0.0);
}

// One layer needs no sorting: VTK's own blending of it is right, but for its rounding. That truth is right, too,
// shows that joining the methods to the mappers' shaders changes nothing there.
TEST_P(Props, InOneLayerAreAsVTKBlendsThem)
{
  TestScene scene(Width, Height);
  GetParam().Add(scene);
  vtkNew<vtkTranslucentPass> blending;
  scene.Use(blending);
  const Picture expected = scene.Render();
  for (const Method& method : AllMethods())
  {
    SCOPED_TRACE(method.Name);
    const vtkSmartPointer<vtkTransparencyPass> pass = method.Make();
    scene.Use(pass);
    const Picture picture = scene.Render();
    if (pass->GetLayersMax() == 1)
    {
      EXPECT_LE(LargestDifference(picture, expected, method.EdgeShare), 1);
    }
    if (pass->GetFallbackReason()[0] != '\0')
    {
      EXPECT_GT(method.MaxLayers, 0);
      EXPECT_NE(std::string(pass->GetFallbackReason()).find("lines and points"), std::string::npos);
      EXPECT_EQ(TakeMessages().size(), 1u);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  Kinds, Props, testing::ValuesIn(Kinds), [](const auto& info) { return info.param.Name; });

// What Core/ShaderTuning changes in shaders shows in no picture: one lit layer under every kind of light.
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
        EXPECT_LE(LargestDifference(scene.Render(), expected, method.EdgeShare),
          method.Name == "Truth" ? 0 : 1)
          << method.Name;
        EXPECT_EQ(pass->GetLayersMax(), 1);
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
      const Rgba color = UniformColor(scene.Render());
      EXPECT_EQ(pass->GetFragmentCount(), 3 * Width * Height) << method << imageFirst;
      const Rgba expected = CompositePlates(plates, TestBackground);
      for (int i = 0; i < 4; ++i)
      {
        EXPECT_NEAR(255.0 * color[i], 255.0 * expected[i], method.Tolerance)
          << method << imageFirst;
      }
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
    const Rgba color = UniformColor(scene.Render());
    EXPECT_EQ(pass->GetFragmentCount(), 5 * Width * Height) << method;
    const Rgba expected = CompositePlates(plates, TestBackground);
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(255.0 * color[i], 255.0 * expected[i], method.Tolerance) << method;
    }
  }
  EXPECT_EQ(actors[0]->GetPropertyKeys()->Get(vtkOpenGLActor::GLDepthMaskOverride()), 1);
}

// A target that holds colours beyond 1: what 8 bits cannot hold does not spill into other channels.
TEST(FloatTarget, ClampsWhatEightBitsCannotHold)
{
  TestScene scene(Width, Height);
  scene.AddPlate(0.0, { 0.8, 0.2, 0.1, 0.5 })
    ->GetShaderProperty()
    ->AddFragmentShaderReplacement(
      "//VTK::Light::Impl", false, "//VTK::Light::Impl\n  gl_FragData[0].rgb *= 2.0;\n", false);
  vtkNew<vtkLinkedListTransparencyPass> pass;
  pass->SetColorStorageToEightBit();
  vtkNew<vtkSeeThroughPass> seeThrough;
  seeThrough->SetTranslucentPass(pass);
  vtkNew<vtkToneMappingPass> toneMapping;
  toneMapping->SetToneMappingType(vtkToneMappingPass::Clamp);
  toneMapping->SetDelegatePass(seeThrough);
  scene.Renderer->SetPass(toneMapping);
  const Rgba color = UniformColor(scene.Render());
  const Rgba expected = CompositePlates({ { 1.0, 0.4, 0.2, 0.5 } }, TestBackground);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(255.0 * color[i], 255.0 * expected[i], 1.4) << i;
  }
}

}
