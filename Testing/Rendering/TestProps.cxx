// What VTK can draw translucently: each kind of prop, mapper and property by every method, against truth.
#include "CompositeMapper.h"
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
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkTranslucentPass.h"
#include "vtkUnsignedCharArray.h"

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
  bool CountsInPixels = false; // lines and points, which have a size in pixels
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
  { "Points", [](TestScene& s) { AddPoints(s, false); }, true },
  { "PointsAsSpheres", [](TestScene& s) { AddPoints(s, true); }, true },
  { "Lines", [](TestScene& s) { AddWireframe(s, 1.0, false); }, true },
  { "WideLines", [](TestScene& s) { AddWireframe(s, 6.0, false); }, true },
  { "LinesAsTubes", [](TestScene& s) { AddWireframe(s, 8.0, true); }, true },
  { "Image", AddImage },
  { "VisibleEdges", [](TestScene& s) { AddCone(s)->GetProperty()->EdgeVisibilityOn(); }, true },
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
  ExpectAllAreTruth(scene);
}

// Masks are truth besides edges, or refuse what counts in pixels.
TEST_P(Props, AreTruthBesidesEdgesOrRefused)
{
  TestScene scene(3 * Width, 3 * Height);
  AddSurroundings(scene);
  GetParam().Add(scene);
  for (const Method& method : MaskMethods())
  {
    SCOPED_TRACE(method.Name);
    const vtkSmartPointer<vtkTransparencyPass> pass = method.Make();
    if (GetParam().CountsInPixels)
    {
      const Picture byVTK = scene.RenderAsVTK();
      scene.Use(pass);
      EXPECT_TRUE(Matches(scene.Render(), byVTK));
      ExpectRefusal(pass, "lines and points");
    }
    else
    {
      ExpectTruth(scene, pass, method.Tolerance, 0.3);
    }
  }
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
    if (pass->GetMaximumNumberOfLayers() == 1)
    {
      EXPECT_TRUE(Matches(picture, expected, 1, method.EdgeShare));
    }
    if (method.HasGroups() && GetParam().CountsInPixels)
    {
      ExpectRefusal(pass, "lines and points");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  Kinds, Props, testing::ValuesIn(Kinds), [](const auto& info) { return info.param.Name; });

}
