// Parts that hide less than their triangles cover, or are drawn wider than they are: no pixel is lost.
#include "CompositeMapper.h"
#include "CullerScene.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkColorTransferFunction.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShaderProperty.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace
{

class CullerSurfaces : public CullerTest
{
protected:
  // A wall that stands before everything, and what lies behind it.
  vtkSmartPointer<vtkActor> AddWallAndHidden()
  {
    Scene.AddHidden(); // first, so that it shows through whatever blends
    return Scene.AddWall();
  }

  // Expects that a change of the wall lets everything show.
  void ExpectSeenThrough(const std::function<void(vtkActor*)>& change)
  {
    const vtkSmartPointer<vtkActor> wall = this->AddWallAndHidden();
    Scene.ExpectHidden(150, 1);
    change(wall);
    Scene.ExpectNothingHidden(151, 2);
  }
};

// Of 8 x 8 texels, every other one with another alpha if there are four components.
vtkSmartPointer<vtkImageData> Chessboard(int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(8, 8, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  for (int i = 0; i < 64; ++i)
  {
    auto* texel = static_cast<unsigned char*>(image->GetScalarPointer(i % 8, i / 8, 0));
    for (int c = 0; c < components; ++c)
    {
      texel[c] = static_cast<unsigned char>(c < 3 ? 40 + 20 * (i % 8) : (i + i / 8) % 2 * 255);
    }
  }
  return image;
}

// Scalars at the wall's corners.
void SetScalars(vtkActor* wall, const std::vector<double>& values, vtkScalarsToColors* colors)
{
  vtkNew<vtkFloatArray> scalars;
  for (const double value : values)
  {
    scalars->InsertNextValue(static_cast<float>(value));
  }
  auto* mapper = static_cast<vtkPolyDataMapper*>(wall->GetMapper());
  mapper->GetInput()->GetPointData()->SetScalars(scalars);
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
}

void AddLines(vtkPolyData* mesh, const std::vector<std::array<Point3, 2>>& lines)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const std::array<Point3, 2>& line : lines)
  {
    const vtkIdType from = points->InsertNextPoint(line[0].data());
    cells->InsertNextCell({ from, points->InsertNextPoint(line[1].data()) });
  }
  mesh->SetPoints(points);
  mesh->SetLines(cells);
}

TEST_P(CullerSurfaces, PartsOfLessThanAPixel)
{
  Scene.AddMesh(MeshOf(StripsBetweenSlits(0.2 * Scene.PixelSize(), 11)));
  TestRandom random(12);
  for (int i = 0; i < 200; ++i)
  {
    const double size = 0.02 * random.Unit();
    Scene.AddBox(
      { 2.0 * random.Unit() - 1.0, 2.0 * random.Unit() - 1.0, 0.6 * random.Unit() - 0.5 },
      { size, size, size });
  }
  Scene.ExpectHidden(130);
}

TEST_P(CullerSurfaces, PointsAndWideLines)
{
  // They reach out from behind the edges of the plate by their width alone.
  Scene.AddMesh(MeshOf({ Rectangle(-1.05, -1.05, 1.05, 1.05, 0.0) }));
  for (int k = 0; k < 15; ++k)
  {
    const double at = -1.05 + 0.15 * k;
    vtkNew<vtkPolyData> line;
    AddLines(line, { { { { at, -0.9 + 0.1 * k, -0.2 }, { at, -0.7 + 0.1 * k, -0.2 } } } });
    const vtkSmartPointer<vtkActor> drawn = Scene.AddMesh(line, { 0.9, 0.05 * k, 0.1, 1.0 });
    drawn->GetProperty()->SetLineWidth(1.0f + static_cast<float>((k * 5) % 7));
    vtkNew<vtkPolyData> points;
    AddLines(points, { { { { 0.1 * k - 0.9, at, -0.2 }, { 0.1 * k - 0.8, at, -0.2 } } } });
    const vtkSmartPointer<vtkActor> dots = Scene.AddMesh(points, { 0.1, 0.05 * k, 0.9, 1.0 });
    dots->GetProperty()->SetRepresentationToPoints();
    dots->GetProperty()->SetPointSize(7.0f - static_cast<float>((k * 4) % 7));
    dots->GetProperty()->SetRenderPointsAsSpheres(k % 4 == 3);
  }
  Scene.ExpectHidden(131, 5);
}

// Forty quads stand behind the slanted edge of a wall, and the box around them reaches beyond the edge. They are
// hidden, unless something else is drawn of the part that reaches beyond it.
TEST_P(CullerSurfaces, LinesVerticesAndStripsOfAPartOfManyPoints)
{
  Scene.AddMesh(MeshOf({ { { { -4, -4, 0 }, { 4, 4, 0 }, { 4, 14, 0 }, { -4, 14, 0 } } } }));
  std::vector<Quad> quads;
  for (int i = 0; i < 40; ++i)
  {
    const double at = -0.5 + 0.02 * i;
    quads.push_back(Rectangle(at, at + 0.4, at + 0.02, at + 0.42, -0.05));
  }
  const vtkSmartPointer<vtkPolyData> mesh = MeshOf(quads);
  const vtkIdType across[] = { mesh->GetPoints()->InsertNextPoint(0.28, -0.08, -0.05),
    mesh->GetPoints()->InsertNextPoint(0.3, 0.0, -0.05),
    mesh->GetPoints()->InsertNextPoint(0.2, 0.0, -0.05) };
  Scene.AddMesh(mesh, { 0.9, 0.2, 0.1, 1.0 });
  Scene.ExpectHidden(132);

  const auto expectSeen = [&](int size, const std::function<void(vtkCellArray*)>& set)
  {
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(size, across);
    set(cells);
    Scene.ExpectNothingHidden(133);
    set(nullptr);
  };
  expectSeen(1, [&](vtkCellArray* cells) { mesh->SetVerts(cells); });
  expectSeen(2, [&](vtkCellArray* cells) { mesh->SetLines(cells); });
  expectSeen(3, [&](vtkCellArray* cells) { mesh->SetStrips(cells); });
}

// Lines beside the view that reach from before the eye to behind it, and lines along its edges.
TEST_P(CullerSurfaces, WideLinesBesideTheView)
{
  Scene.AddWall(-1.0);
  Scene.AddHidden(-1.2);
  const double top = 0.5 * Scene.PixelSize() * Scene.Setting.Height;
  const double right = top * Scene.Setting.Width / Scene.Setting.Height;
  for (const double outside : { 0.999, 1.0, 1.002, 1.01, 1.03 })
  {
    for (const double side : { -1.0, 1.0 })
    {
      const double x = side * outside * right, y = side * outside * top;
      // Perspective: in the plane of the view's side, which meets the eye at z = 3.6.
      const double ahead = Scene.Setting.IsParallel ? 1.0 : 1.2,
                   behind = Scene.Setting.IsParallel ? 1.0 : -0.4;
      for (const std::array<double, 2>& at :
        { std::array<double, 2>{ x, 0.3 * y }, { 0.4 * x, y } })
      {
        for (const double to : { behind, 0.9 * ahead })
        {
          const double z = Scene.Setting.IsParallel ? (to == behind ? 5.0 : 0.5) : 3.6 - 3.6 * to;
          vtkNew<vtkPolyData> line;
          AddLines(line,
            { { { { at[0] * ahead, at[1] * ahead, Scene.Setting.IsParallel ? -0.7 : -0.72 },
              { at[0] * to, at[1] * to, z } } } });
          const vtkSmartPointer<vtkActor> drawn = Scene.AddMesh(line, { 0.9, 0.2, 0.3, 1.0 });
          drawn->GetProperty()->SetLineWidth(7.0f);
        }
      }
    }
  }
  EXPECT_GT(Scene.ExpectSame(), 0);
}

TEST_P(CullerSurfaces, Glyphs)
{
  Scene.AddMesh(MeshOf({ Rectangle(-0.4, -2.0, 2.0, 2.0, 0.0) }));
  vtkNew<vtkPolyData> places;
  places->SetPoints(MeshOf(StripsBetweenSlits(0.1, 13))->GetPoints());
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetSourceConnection(cube->GetOutputPort());
  mapper->SetScaleFactor(0.2);
  const vtkSmartPointer<vtkActor> glyphs = vtkSmartPointer<vtkActor>::New();
  glyphs->SetMapper(mapper);
  glyphs->SetScale(0.6);
  glyphs->SetPosition(0.0, 0.0, -0.6);
  Scene.Renderer->AddActor(glyphs);
  Scene.AddHidden();
  Scene.ExpectHidden(133);
}

TEST_P(CullerSurfaces, TranslucentWall)
{
  this->ExpectSeenThrough([](vtkActor* wall) { wall->GetProperty()->SetOpacity(0.99); });
  Scene.Clear();
  this->ExpectSeenThrough([](vtkActor* wall) { wall->ForceTranslucentOn(); });
}

TEST_P(CullerSurfaces, TranslucentBackOfAWall)
{
  this->ExpectSeenThrough(
    [](vtkActor* wall)
    {
      vtkNew<vtkProperty> back;
      back->SetOpacity(0.4);
      wall->SetBackfaceProperty(back);
      wall->SetScale(-1.0, 1.0, 1.0); // turns its back
    });
}

TEST_P(CullerSurfaces, ImageThatGetsAnAlpha)
{
  Scene.AddHidden();
  const vtkSmartPointer<vtkActor> wall = Scene.AddMesh(TexturedWall());
  const vtkSmartPointer<vtkImageData> image = Chessboard(3);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  wall->SetTexture(texture);
  Scene.ExpectHidden(147, 1);
  image->DeepCopy(Chessboard(4));
  Scene.ExpectNothingHidden(148, 1);
}

TEST_P(CullerSurfaces, TextureOfAProperty)
{
  Scene.AddHidden();
  const vtkSmartPointer<vtkActor> wall = Scene.AddMesh(TexturedWall());
  vtkNew<vtkTexture> texture;
  texture->SetInputData(Chessboard(4));
  texture->UseSRGBColorSpaceOn();
  wall->GetProperty()->SetTexture("albedoTex", texture);
  Scene.ExpectNothingHidden(154);
  wall->VisibilityOff();
  Scene.AddWall();
  Scene.ExpectHidden(154, 1);
}

TEST_P(CullerSurfaces, LookupTableWithAlpha)
{
  vtkNew<vtkLookupTable> table;
  this->ExpectSeenThrough(
    [&](vtkActor* wall)
    {
      SetScalars(wall, { 0.0, 0.3, 0.6, 1.0 }, table);
      Scene.ExpectHidden(155, 1);
      table->SetAlphaRange(0.5, 1.0);
      table->Build();
    });
}

// VTK takes the wall for opaque, and blends it nevertheless.
TEST_P(CullerSurfaces, TranslucentColorOfWhatIsUnknown)
{
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, 0.2, 0.2, 0.4);
  colors->IndexedLookupOn(); // none of the values is known by name
  colors->SetNanOpacity(0.3);
  this->ExpectSeenThrough(
    [&](vtkActor* wall) {
      SetScalars(wall, { 0.0, 0.3, 0.6, 1.0 }, colors);
    });
}

TEST_P(CullerSurfaces, ColorsWithAlpha)
{
  this->ExpectSeenThrough(
    [](vtkActor* wall)
    {
      vtkNew<vtkUnsignedCharArray> colors;
      colors->SetNumberOfComponents(4);
      for (const int alpha : { 255, 255, 100, 255 })
      {
        colors->InsertNextTuple4(90, 90, 120, alpha);
      }
      static_cast<vtkPolyDataMapper*>(wall->GetMapper())
        ->GetInput()
        ->GetPointData()
        ->SetScalars(colors);
    });
}

TEST_P(CullerSurfaces, BlocksOfUnlikeOpacity)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MeshOf({ Rectangle(-2.0, -2.0, 0.1, 2.0, 0.0) }));
  blocks->SetBlock(1, MeshOf({ Rectangle(0.1, -2.0, 2.0, 2.0, 0.0) }));
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  mapper->SetBlockOpacity(2, 0.5);
  vtkNew<vtkActor> walls;
  walls->SetMapper(mapper);
  const vtkSmartPointer<vtkActor> inFront =
    Scene.AddMesh(MeshOf({ Rectangle(-0.3, -0.3, 0.5, 0.5, 0.3) }));
  Scene.Renderer->AddActor(walls);
  Scene.AddHidden();
  Scene.ExpectHidden(156);
  inFront->VisibilityOff();
  Scene.ExpectHidden(157); // by the opaque block
  mapper->SetBlockOpacity(1, 0.5);
  Scene.ExpectNothingHidden(157);
}

TEST_P(CullerSurfaces, ClippingPlanes)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.7, 0.5, 0.0);
  this->ExpectSeenThrough([&](vtkActor* wall) { wall->GetMapper()->AddClippingPlane(plane); });
}

TEST_P(CullerSurfaces, ShadersThatDiscard)
{
  this->ExpectSeenThrough(
    [](vtkActor* wall)
    {
      wall->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
        "//VTK::Light::Impl\n  if (mod(gl_FragCoord.x, 5.0) < 2.0) discard;\n", false);
    });
}

TEST_P(CullerSurfaces, WiresAndPoints)
{
  this->ExpectSeenThrough(
    [](vtkActor* wall) { wall->GetProperty()->SetRepresentationToWireframe(); });
  Scene.Clear();
  this->ExpectSeenThrough([](vtkActor* wall) { wall->GetProperty()->SetRepresentationToPoints(); });
}

// Surfaces with their edges may be drawn a little behind where they are, so that the edges stand out.
TEST_P(CullerSurfaces, EdgesOfSurfaces)
{
  const vtkSmartPointer<vtkActor> wall = Scene.AddWall();
  wall->GetProperty()->EdgeVisibilityOn();
  wall->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, 4.0);
  for (int i = 0; i < 9; ++i)
  {
    const double x = -0.8 + 0.2 * i;
    Scene.AddMesh(
      MeshOf({ Rectangle(x, -0.8, x + 0.1, 0.8, -2e-5 * (i + 1)) }), { 0.9, 0.3, 0.1, 1.0 });
  }
  Scene.ExpectNothingHidden(158, 1);
  Scene.AddMesh(MeshOf({ Rectangle(-2.0, -2.0, 2.0, 2.0, 0.3) }));
  EXPECT_GE(Scene.ExpectSameAround(158, 2), 9); // all of the strips
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerSurfaces, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
