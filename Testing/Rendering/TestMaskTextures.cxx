// Stencil masks shade a pixel in many places of a larger target: of textures they see what the picture's pixels see, so
// that minified ones come from the level of detail that truth takes.
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTexture.h"

#include <gtest/gtest.h>

#include <functional>

namespace
{

// Rectangles of 4 x 8 texels in two colours, mipmapped; anisotropic by default, as VTK's textures are.
vtkSmartPointer<vtkTexture> MakeChecker(float anisotropy = 4.0f)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 64, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (int i = 0; i < 64 * 64; ++i)
  {
    const bool odd = (i / 4 + (i / 64 + 4) / 8) % 2 != 0;
    auto* texel = static_cast<unsigned char*>(image->GetScalarPointer(i % 64, i / 64, 0));
    texel[0] = odd ? 230 : 40;
    texel[1] = odd ? 30 : 200;
    texel[2] = 90;
    texel[3] = odd ? 190 : 110;
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->MipmapOn();
  texture->InterpolateOn();
  texture->RepeatOn();
  texture->SetMaximumAnisotropicFiltering(anisotropy);
  return texture;
}

// A triangle that leans back and fills a perspective view, without an edge in it.
vtkSmartPointer<vtkActor> AddLeaningTriangle(TestScene& scene, int coordinates)
{
  const float corners[3][3] = { { -30.0f, -3.0f, 1.0f }, { 30.0f, -3.0f, 1.0f },
    { 0.0f, 40.0f, -30.0f } };
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> texturePlaces;
  texturePlaces->SetNumberOfComponents(coordinates);
  for (const float* corner : corners)
  {
    points->InsertNextPoint(corner);
    normals->InsertNextTuple3(0.0, 0.58, 0.81);
    const float place[2] = { 0.9f * corner[0] + 0.1f * corner[1], 0.4f * corner[1] };
    texturePlaces->InsertNextTuple(place);
  }
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetNormals(normals);
  data->GetPointData()->SetTCoords(texturePlaces);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(0.5);
  actor->ForceTranslucentOn();
  scene.Renderer->AddActor(actor);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
  scene.Renderer->ResetCameraClippingRange();
  return actor;
}

void SetAlbedo(vtkActor* actor, vtkTexture* texture)
{
  texture->UseSRGBColorSpaceOn();
  actor->GetProperty()->SetInterpolationToPBR();
  actor->GetProperty()->SetBaseColorTexture(texture);
}

// Of two coordinates that its vertices have, VTK takes the one that changes less from pixel to pixel.
void SetSeamless(vtkActor* actor, vtkTexture* texture)
{
  texture->MipmapOff();
  actor->SetTexture(texture);
  vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SeamlessUOn();
}

struct Lookup
{
  const char* Name;
  std::function<void(vtkActor*)> Texture;
  int Coordinates = 2;

  /**
   * The share of the channels that may be off. llvmpipe's anisotropic filter takes one level and does not interpolate
   * between two. Where the level changes, the smallest difference of gradients shows.
   */
  double Besides = 0.02;
};

void PrintTo(const Lookup& lookup, std::ostream* os)
{
  *os << lookup.Name;
}

const Lookup Lookups[] = {
  { "Texture", [](vtkActor* a) { a->SetTexture(MakeChecker()); } },
  { "IsotropicTexture", [](vtkActor* a) { a->SetTexture(MakeChecker(1.0f)); }, 2, 0.0 },

  { "OneCoordinate", [](vtkActor* a) { a->SetTexture(MakeChecker()); }, 1 },
  { "PropertyTexture", [](vtkActor* a) { a->GetProperty()->SetTexture("mine", MakeChecker()); } },
  { "AlbedoTexture", [](vtkActor* a) { SetAlbedo(a, MakeChecker()); } },
  { "IsotropicAlbedoTexture", [](vtkActor* a) { SetAlbedo(a, MakeChecker(1.0f)); }, 2, 0.0 },
  { "MaterialTexture",
    [](vtkActor* a)
    {
      a->GetProperty()->SetInterpolationToPBR();
      a->GetProperty()->SetORMTexture(MakeChecker());
    } },
  { "SeamlessTexture", [](vtkActor* a) { SetSeamless(a, MakeChecker(1.0f)); }, 2, 0.0 },
};

class StencilMaskTexture : public testing::TestWithParam<Lookup>
{
};

TEST_P(StencilMaskTexture, IsMinifiedAsInTruth)
{
  TestScene scene(60, 50);
  const vtkSmartPointer<vtkActor> actor = AddLeaningTriangle(scene, GetParam().Coordinates);
  GetParam().Texture(actor);
  for (const Method& method : MaskMethods())
  {
    SCOPED_TRACE(method.Name);
    ExpectTruth(scene, method.Make(), 1.4, GetParam().Besides);
  }
}

INSTANTIATE_TEST_SUITE_P(Lookups, StencilMaskTexture, testing::ValuesIn(Lookups),
  [](const auto& info) { return info.param.Name; });

}
