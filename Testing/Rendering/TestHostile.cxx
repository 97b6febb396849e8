// Input that no sane scene has: NaN, infinity, nothing. No crash, no NaN in the picture, and the neighbours right.
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTruthTransparencyPass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

class Hostile : public testing::TestWithParam<Method>
{
};

// A plate whose shader makes colours that no number describes, between two plain ones.
TEST_P(Hostile, ColorsOfAShader)
{
  const struct
  {
    const char* Color;
    Rgba As;
  } cases[] = {
    { "vec4(0.0 / zero, 0.4, 0.8, 0.6)", { 0.0, 0.4, 0.8, 0.6 } },
    { "vec4(1.0 / zero, 0.4, 0.8, 0.6)", { 1.0, 0.4, 0.8, 0.6 } },
    { "vec4(-1.0 / zero, 0.4, -3.0, 0.6)", { 0.0, 0.4, 0.0, 0.6 } },
    { "vec4(7.0, 0.4, 0.8, 3.0)", { 1.0, 0.4, 0.8, 1.0 } },
    { "vec4(0.2, 0.4, 0.8, 0.0 / zero)", { 0.2, 0.4, 0.8, 0.0 } },
    { "vec4(0.2, 0.4, 0.8, 1.0 / zero)", { 0.2, 0.4, 0.8, 1.0 } },
  };
  for (const auto& c : cases)
  {
    SCOPED_TRACE(c.Color);
    TestScene scene(6, 5);
    const Rgba front = { 0.8, 0.2, 0.2, 0.4 };
    const Rgba back = { 0.2, 0.2, 0.8, 0.4 };
    scene.AddPlate(0.5, front);
    scene.AddPlate(-0.5, back);
    scene.AddPlate(0.0, { 1.0, 1.0, 1.0, 0.5 })
      ->GetShaderProperty()
      ->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
        std::string("//VTK::Light::Impl\n  float zero = min(gl_FragCoord.x, 0.0);\n"
                    "  gl_FragData[0] = ") +
          c.Color + ";\n",
        false);
    scene.Use(GetParam().Make());
    ExpectColor(
      UniformColor(scene.Render()), CompositePlates({ front, c.As, back }, TestBackground), 0.75);
  }
}

TEST_P(Hostile, NaNScalarsHaveTheirTablesColor)
{
  TestScene scene(20, 16);
  vtkNew<vtkPoints> points;
  for (const double x : { -2.0, 2.0 })
  {
    for (const double y : { -2.0, 2.0 })
    {
      points->InsertNextPoint(x, y, 0.0);
    }
  }
  vtkNew<vtkCellArray> quads;
  quads->InsertNextCell({ 0, 1, 3, 2 });
  vtkNew<vtkFloatArray> scalars;
  for (const float value : { 0.0f, std::numeric_limits<float>::quiet_NaN(), 1.0f, 0.5f })
  {
    scalars->InsertNextValue(value);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(quads);
  data->GetPointData()->SetScalars(scalars);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(0.5);
  scene.Renderer->AddActor(actor);
  scene.AddSphere(0.0, 0.0, 0.2, 0.6, { 0.9, 0.5, 0.1, 0.4 });
  ExpectTruth(scene, GetParam().Make(), GetParam().Tolerance, GetParam().EdgeShare);
}

// Triangles with corners that are nowhere do not disturb the plates around them.
TEST_P(Hostile, PositionsDisturbNothingElse)
{
  const int layers = GetParam().Keeps(12) ? 12 : GetParam().MaxLayers;
  for (const double coordinate : { NaN, Infinity, -Infinity, 1e38 })
  {
    SCOPED_TRACE(coordinate);
    TestScene scene(12, 10);
    const std::vector<Rgba> plates = RandomPlates(layers, 0.2, 9);
    scene.AddPlates(plates, 10);
    scene.AddTriangle(
      { { { coordinate, coordinate, coordinate }, { NaN, 0.0, 0.0 }, { coordinate, 0.5, 0.0 } } },
      { 1.0, 0.0, 0.0, 0.5 });
    const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
    scene.Use(pass);
    ExpectColor(UniformColor(scene.Render()), CompositePlates(plates, TestBackground), 0.75);
    EXPECT_EQ(pass->GetNumberOfFragments(), layers * 12 * 10);
  }
}

TEST_P(Hostile, NothingToDraw)
{
  TestScene scene(12, 10);
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  scene.Use(pass);
  EXPECT_EQ(UniformColor(scene.Render()), TestBackground); // no props
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkPolyData> empty;
  mapper->SetInputData(empty);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(0.5);
  scene.Renderer->AddActor(actor);
  EXPECT_EQ(UniformColor(scene.Render()), TestBackground); // no triangles
  scene.AddTriangle(
    { { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } } }, { 1.0, 0.0, 0.0, 0.5 });
  scene.AddTriangle(
    { { { -1.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } } }, { 1.0, 0.0, 0.0, 0.5 });
  scene.AddRectangle(-1.0, -1.0, 1.0, 1.0, 7.0, { 1.0, 0.0, 0.0, 0.5 }); // behind the camera
  EXPECT_EQ(UniformColor(scene.Render()), TestBackground);               // no area
  EXPECT_EQ(pass->GetNumberOfFragments(), 0);
  EXPECT_EQ(pass->GetMaximumNumberOfLayers(), 0);
  EXPECT_EQ(pass->GetMeanNumberOfLayers(), 0.0);
}

// Behind opaque geometry that covers everything there is nothing, either.
TEST_P(Hostile, NothingToSee)
{
  TestScene scene(12, 10);
  scene.AddPlate(0.9, { 1.0, 1.0, 1.0, 1.0 });
  scene.AddPlates(RandomPlates(12, 0.2, 9), 10);
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  scene.Use(pass);
  EXPECT_EQ(UniformColor(scene.Render()), (Rgba{ 1.0, 1.0, 1.0, 1.0 }));
}

INSTANTIATE_TEST_SUITE_P(Methods, Hostile, testing::ValuesIn(AllMethods()), MethodName());

}
