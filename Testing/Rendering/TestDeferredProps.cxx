// Whatever an opaque prop is, deferred shading gives VTK's picture of it, or leaves it to others.
#include "CompositeMapper.h"
#include "DeferredScene.h"
#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkConeSource.h"
#include "vtkCulledCompositePolyDataMapper.h"
#include "vtkCulledPolyDataMapper.h"
#include "vtkDataSetMapper.h"
#include "vtkElevationFilter.h"
#include "vtkGlyph3DMapper.h"
#include "vtkLineSource.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataTangents.h"
#include "vtkShaderProperty.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVertexGlyphFilter.h"

#include <gtest/gtest.h>

#include <array>

namespace
{

struct PropKind
{
  const char* Name;
  int Deferred; ///< of the props that are added
  std::function<void(DeferredScene&)> Add;
};

void PrintTo(const PropKind& kind, std::ostream* os)
{
  *os << kind.Name;
}

vtkSmartPointer<vtkActor> AddBall(DeferredScene& scene)
{
  const auto ball = scene.AddSphere(0.2, 0.1, 0.6, 0.35, { 0.4, 0.7, 0.9, 1.0 });
  ball->GetProperty()->SetSpecular(0.5);
  return ball;
}

vtkSmartPointer<vtkTexture> MakeChessboard(int components)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  for (int i = 0; i < 64; ++i)
  {
    auto* const texel = static_cast<unsigned char*>(image->GetScalarPointer(i % 8, i / 8, 0));
    for (int c = 0; c < components; ++c)
    {
      texel[c] = static_cast<unsigned char>((i + i / 8) % 2 == 0 ? 255 - 20 * c : 60 + 40 * c);
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

vtkSmartPointer<vtkActor> AddPlate(DeferredScene& scene)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-0.6, -0.5, 0.3);
  plane->SetPoint1(0.7, -0.5, 0.7);
  plane->SetPoint2(-0.6, 0.6, 0.3);
  return scene.AddSource(plane, { 1.0, 1.0, 1.0, 1.0 });
}

/** The actor's property, which VTK's formula for physical surfaces is for from now on. */
vtkProperty* MakePhysical(vtkActor* actor)
{
  actor->GetProperty()->SetInterpolationToPBR();
  return actor->GetProperty();
}

// Each block of another colour; the last is translucent.
template <class Mapper>
void AddBlocks(DeferredScene& scene)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 3; ++i)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(0.5 * i - 0.5, 0.2, 0.6);
    sphere->SetRadius(0.3);
    sphere->Update();
    blocks->SetBlock(i, sphere->GetOutput());
  }
  vtkNew<Mapper> mapper;
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  mapper->SetInputDataObject(blocks);
  const double color[3] = { 0.9, 0.3, 0.2 };
  attributes->SetBlockColor(blocks->GetBlock(1), color);
  attributes->SetBlockOpacity(blocks->GetBlock(2), 0.4);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
}

void AddGlyphs(DeferredScene& scene)
{
  vtkNew<vtkPlaneSource> places;
  places->SetResolution(2, 2);
  vtkNew<vtkConeSource> cone;
  cone->SetHeight(0.4);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputConnection(places->GetOutputPort());
  mapper->SetSourceConnection(cone->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(0.0, 0.0, 0.7);
  scene.Renderer->AddActor(actor);
}

const std::vector<PropKind>& Kinds()
{
  static const std::vector<PropKind> kinds = {
    { "Textured", 1, [](DeferredScene& s) { AddPlate(s)->SetTexture(MakeChessboard(3)); } },
    { "TexturedByATableWithAlpha", 0,
      [](DeferredScene& s)
      {
        vtkNew<vtkLookupTable> table;
        table->SetAlphaRange(0.2, 0.9);
        table->SetRange(0.0, 255.0);
        table->Build();
        const auto texture = MakeChessboard(1);
        texture->SetLookupTable(table);
        texture->SetColorModeToMapScalars();
        AddPlate(s)->SetTexture(texture);
      } },
    { "OfABackThatLetsThrough", 0,
      [](DeferredScene& s)
      {
        const auto plate = AddPlate(s);
        plate->RotateY(180.0);
        plate->SetPosition(0.0, 0.0, 1.0);
        vtkNew<vtkProperty> back;
        back->SetOpacity(0.4);
        plate->SetBackfaceProperty(back);
      } },
    { "ForcedOpaque", 0,
      [](DeferredScene& s)
      {
        const auto ball = AddBall(s);
        ball->GetProperty()->SetOpacity(0.5);
        ball->ForceOpaqueOn();
      } },
    { "OfColoursOfPoints", 1,
      [](DeferredScene& s)
      {
        vtkNew<vtkSphereSource> sphere;
        vtkNew<vtkElevationFilter> elevation;
        elevation->SetInputConnection(sphere->GetOutputPort());
        s.AddSource(elevation, { 1.0, 1.0, 1.0, 1.0 });
      } },
    { "OfColoursOfCells", 1,
      [](DeferredScene& s)
      {
        vtkNew<vtkSphereSource> sphere;
        sphere->Update();
        vtkNew<vtkPolyData> cells;
        cells->ShallowCopy(sphere->GetOutput());
        vtkNew<vtkUnsignedCharArray> colors;
        colors->SetNumberOfComponents(3);
        for (int i = 0; i < cells->GetNumberOfCells(); ++i)
        {
          colors->InsertNextTuple3(i % 3 * 100, 255 - i, i);
        }
        cells->GetCellData()->SetScalars(colors);
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(cells);
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        s.Renderer->AddActor(actor);
      } },
    { "NotLit", 1, [](DeferredScene& s) { AddBall(s)->GetProperty()->LightingOff(); } },
    { "OfLines", 1,
      [](DeferredScene& s)
      {
        vtkNew<vtkLineSource> line;
        line->SetPoint1(-0.9, -0.9, 0.8);
        line->SetPoint2(0.9, 0.8, 0.8);
        s.AddSource(line, { 0.9, 0.1, 0.2, 1.0 })->GetProperty()->SetLineWidth(3.0);
      } },
    { "OfWires", 1,
      [](DeferredScene& s) { AddBall(s)->GetProperty()->SetRepresentationToWireframe(); } },
    { "OfPoints", 1,
      [](DeferredScene& s)
      {
        const auto ball = AddBall(s);
        ball->GetProperty()->SetRepresentationToPoints();
        ball->GetProperty()->SetPointSize(4.0);
      } },
    { "OfPointsAsSpheres", 1,
      [](DeferredScene& s)
      {
        const auto ball = AddBall(s);
        ball->GetProperty()->SetRepresentationToPoints();
        ball->GetProperty()->SetPointSize(7.0);
        ball->GetProperty()->RenderPointsAsSpheresOn();
      } },
    { "WithEdges", 1, [](DeferredScene& s) { AddBall(s)->GetProperty()->EdgeVisibilityOn(); } },
    { "OfTwoSidesClipped", 1,
      [](DeferredScene& s)
      {
        const auto ball = AddBall(s);
        vtkNew<vtkProperty> back;
        back->SetColor(0.9, 0.2, 0.1);
        back->SetSpecular(0.8);
        back->SetSpecularPower(9.0);
        ball->SetBackfaceProperty(back);
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(0.2, 0.1, 0.6);
        plane->SetNormal(-0.3, 0.4, -1.0);
        ball->GetMapper()->AddClippingPlane(plane);
      } },
    { "WithCoat", 1, [](DeferredScene& s) { MakePhysical(AddBall(s))->SetCoatStrength(0.8); } },
    { "Anisotropic", 1,
      [](DeferredScene& s)
      {
        vtkNew<vtkPlaneSource> plane;
        plane->SetOrigin(-0.6, -0.5, 0.3);
        plane->SetPoint1(0.7, -0.5, 0.7);
        plane->SetPoint2(-0.6, 0.6, 0.3);
        vtkNew<vtkTriangleFilter> triangles;
        triangles->SetInputConnection(plane->GetOutputPort());
        vtkNew<vtkPolyDataTangents> tangents;
        tangents->SetInputConnection(triangles->GetOutputPort());
        vtkProperty* const plate = MakePhysical(s.AddSource(tangents, { 0.9, 0.6, 0.3, 1.0 }));
        plate->SetAnisotropy(0.9);
        plate->SetRoughness(0.4);
      } },
    { "PhysicalAndTextured", 1,
      [](DeferredScene& s)
      {
        vtkProperty* const plate = MakePhysical(AddPlate(s));
        const auto color = MakeChessboard(3), glow = MakeChessboard(3);
        color->UseSRGBColorSpaceOn();
        glow->UseSRGBColorSpaceOn();
        plate->SetBaseColorTexture(color);
        plate->SetEmissiveTexture(glow);
        plate->SetEmissiveFactor(0.2, 0.1, 0.3);
      } },
    { "OfTexturesOfRoughness", 1,
      [](DeferredScene& s) { MakePhysical(AddPlate(s))->SetORMTexture(MakeChessboard(3)); } },
    { "OccludedByHalf", 1,
      [](DeferredScene& s) { MakePhysical(AddBall(s))->SetOcclusionStrength(0.3); } },
    { "OfADataSet", 1,
      [](DeferredScene& s)
      {
        vtkNew<vtkSphereSource> sphere;
        vtkNew<vtkDataSetMapper> mapper;
        mapper->SetInputConnection(sphere->GetOutputPort());
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        s.Renderer->AddActor(actor);
      } },
    { "OfBlocks", 1, AddBlocks<CompositeMapper> },
    { "OfCulledBlocks", 1, AddBlocks<vtkCulledCompositePolyDataMapper> },
    { "OfCulledRuns", 1,
      [](DeferredScene& s)
      {
        vtkNew<vtkSphereSource> sphere;
        vtkNew<vtkCulledPolyDataMapper> mapper;
        mapper->SetInputConnection(sphere->GetOutputPort());
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        s.Renderer->AddActor(actor);
      } },
    { "OfGlyphs", 0, AddGlyphs },
    { "OfShaderCode", 0,
      [](DeferredScene& s)
      {
        AddBall(s)->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::TCoord::Impl", true,
          "//VTK::TCoord::Impl\n  gl_FragData[0].rgb = gl_FragData[0].bgr;\n", false);
      } },
  };
  return kinds;
}

class DeferredProps : public testing::TestWithParam<PropKind>
{
};

// Lit where they are thin: a light's tiles need not be those that are drawn.
TEST(DeferredProp, ThatIsDrawnWideIsVTKs)
{
  DeferredScene scene(false);
  scene.Renderer->RemoveAllViewProps();
  scene.Deferred->SetTileSize(4);
  for (int i = 0; i < 4; ++i)
  {
    const double x = i - 1.5, y = 0.4 * (i % 2);
    const auto light = scene.AddLight(LightKind::Spot, 1.0, 0.0);
    light->SetPosition(x, y, 1.0);
    light->SetFocalPoint(x, y, 0.0);
    light->SetConeAngle(20.0);
  }
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1.0, -1.0, 0.0);
  plane->SetPoint1(1.0, -1.0, 0.0);
  plane->SetPoint2(-1.0, 1.0, 0.0);
  plane->SetResolution(4, 4);
  vtkNew<vtkVertexGlyphFilter> vertices;
  vertices->SetInputConnection(plane->GetOutputPort());
  for (vtkAlgorithm* const source : std::array<vtkAlgorithm*, 2>{ plane, vertices })
  {
    const auto actor = scene.AddSource(source, { 0.9, 0.8, 0.7, 1.0 });
    actor->GetProperty()->SetLineWidth(11.0);
    actor->GetProperty()->SetPointSize(11.0);
    for (const int representation : { VTK_POINTS, VTK_WIREFRAME })
    {
      SCOPED_TRACE(representation);
      actor->GetProperty()->SetRepresentation(representation);
      scene.ExpectAsVTK(1);
    }
    actor->GetProperty()->SetRepresentationToSurface();
    scene.ExpectAsVTK(1);
    scene.Renderer->RemoveActor(actor);
  }
}

TEST_P(DeferredProps, AreVTKs)
{
  DeferredScene scene(false);
  scene.AddLights(2);
  const Picture without = scene.InVTKsLight();
  GetParam().Add(scene);
  EXPECT_GT(LargestDifference(without, scene.InVTKsLight()), 10); // it can be seen
  scene.ExpectAsVTK(DeferredParts + GetParam().Deferred);
}

INSTANTIATE_TEST_SUITE_P(Kinds, DeferredProps, testing::ValuesIn(Kinds()),
  [](const testing::TestParamInfo<PropKind>& info) { return std::string(info.param.Name); });

}
