// Props whose fragments are added to what is behind them, and hide nothing of it: emissive splats.
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/VitrineOpenGL.h"
#include "vtkCellArray.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLState.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkTolerantTransparencyPass.h"
#include "vtkTranslucentPass.h"
#include "vtkTruthTransparencyPass.h"

#include <gtest/gtest.h>

namespace
{

// Splats at points. Those that fill the view have no fall-off: they are plates.
vtkSmartPointer<vtkActor> AddSplats(TestScene& scene,
  const std::vector<std::array<double, 3>>& places, const Rgba& color, bool fillTheView)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (const auto& place : places)
  {
    const vtkIdType id = points->InsertNextPoint(place.data());
    vertices->InsertNextCell(1, &id);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(vertices);
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(data);
  mapper->EmissiveOn();
  mapper->SetScaleFactor(fillTheView ? 100.0 : 0.2);
  if (fillTheView)
  {
    mapper->SetSplatShaderCode("//VTK::Color::Impl\n");
  }
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetOpacity(color[3]);
  scene.Renderer->AddActor(actor);
  return actor;
}

vtkSmartPointer<vtkActor> AddSplatPlate(TestScene& scene, double z, const Rgba& color)
{
  return AddSplats(scene, { { 0.0, 0.0, z } }, color, true);
}

// Adds what it draws, by the blend function that splats have.
class AddingMapper : public vtkOpenGLPolyDataMapper
{
public:
  static AddingMapper* New();
  vtkTypeMacro(AddingMapper, vtkOpenGLPolyDataMapper);

  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override
  {
    vtkOpenGLState* const state =
      vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow())->GetState();
    const vtkOpenGLState::ScopedglBlendFuncSeparate function(state);
    state->vtkglBlendFunc(GL_SRC_ALPHA, GL_ONE);
    this->Superclass::RenderPieceDraw(renderer, actor);
  }
};
vtkStandardNewMacro(AddingMapper);

vtkSmartPointer<vtkActor> AddAddingPlate(TestScene& scene, double z, const Rgba& color)
{
  const vtkSmartPointer<vtkActor> plate = scene.AddPlate(z, color);
  vtkNew<AddingMapper> mapper;
  mapper->SetInputConnection(plate->GetMapper()->GetInputConnection(0, 0));
  mapper->SetScalarVisibility(plate->GetMapper()->GetScalarVisibility());
  plate->SetMapper(mapper);
  return plate;
}

// Colours alone: VTK's blending adds the alpha of what is added, too.
Picture WithoutAlpha(Picture picture)
{
  for (std::size_t i = 3; i < picture.Bytes.size(); i += 4)
  {
    picture.Bytes[i] = 0;
  }
  return picture;
}

struct Layer
{
  Rgba Color;
  bool IsAdded;
};

// Layers front to back over the background.
Rgba Composite(const std::vector<Layer>& layers)
{
  Rgba sum = { 0.0, 0.0, 0.0, 0.0 };
  double transmittance = 1.0;
  for (const Layer& layer : layers)
  {
    const double alpha = layer.Color[3];
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += transmittance * alpha * layer.Color[c];
    }
    transmittance *= layer.IsAdded ? 1.0 : 1.0 - alpha;
  }
  for (int c = 0; c < 3; ++c)
  {
    sum[c] = std::min(sum[c] + transmittance * TestBackground[c], 1.0);
  }
  sum[3] = 1.0 - transmittance + transmittance * TestBackground[3];
  return sum;
}

// Between plates and beside them; their colours are low enough for their sum.
const std::vector<Layer> Mixed = { { RoundedTo8Bits({ 0.1, 0.2, 0.1, 0.3 }), true },
  { RoundedTo8Bits({ 0.9, 0.1, 0.4, 0.4 }), false },
  { RoundedTo8Bits({ 0.2, 0.5, 0.1, 0.5 }), true },
  { RoundedTo8Bits({ 0.4, 0.1, 0.3, 0.2 }), true },
  { RoundedTo8Bits({ 0.1, 0.3, 0.9, 0.3 }), false },
  { RoundedTo8Bits({ 0.2, 0.2, 0.4, 0.6 }), true } };

class Additive : public testing::TestWithParam<Method>
{
protected:
  // By splats where the method takes them.
  static vtkSmartPointer<vtkActor> AddLight(TestScene& scene, double z, const Rgba& color)
  {
    return GetParam().HasGroups() ? AddAddingPlate(scene, z, color)
                                  : AddSplatPlate(scene, z, color);
  }

  static void AddLayers(TestScene& scene, const std::vector<Layer>& layers)
  {
    for (std::size_t i = 0; i < layers.size(); ++i)
    {
      const double z = 0.9 - 0.3 * static_cast<double>(i);
      layers[i].IsAdded ? AddLight(scene, z, layers[i].Color) : scene.AddPlate(z, layers[i].Color);
    }
  }
};

// From the first frame on, of one and of four samples.
TEST_P(Additive, LightIsSeenThroughWhatIsInFrontAlone)
{
  for (const int samples : GetParam().Samples())
  {
    SCOPED_TRACE(std::to_string(samples) + " samples");
    TestScene scene(32, 24, samples);
    AddLayers(scene, Mixed);
    const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
    scene.Use(pass);
    for (int frame = 0; frame < 2; ++frame)
    {
      // Each plate of a splat has a rounding of its own in 8 bits.
      ExpectColor(UniformColor(scene.Render()), Composite(Mixed), GetParam().Tolerance + 0.5);
      EXPECT_STREQ(pass->GetFallbackReason(), "");
      if (samples ==
        0) // where they are several, two triangles of a splat share the pixels between them
      {
        EXPECT_EQ(pass->GetNumberOfFragments(), 6 * 32 * 24);
        EXPECT_EQ(pass->GetMaximumNumberOfLayers(), 6);
      }
    }
  }
}

class AdditiveSplats : public Additive
{
};

// Nothing in front and nothing behind, as VTK's blending draws them.
TEST_P(AdditiveSplats, AloneAreThoseOfVTKsBlending)
{
  TestScene scene;
  TestRandom random(7);
  RecordProperty("seed", 7);
  std::vector<std::array<double, 3>> places;
  for (int i = 0; i < 8; ++i)
  {
    places.push_back(
      { 1.6 * random.Unit() - 0.8, 1.6 * random.Unit() - 0.8, 1.6 * random.Unit() - 0.8 });
  }
  AddSplats(scene, places, { 0.5, 0.3, 0.2, 0.4 }, false);
  vtkNew<vtkTranslucentPass> blending;
  scene.Use(blending);
  const Picture expected = WithoutAlpha(scene.Render());
  scene.Use(GetParam().Make());
  // VTK rounds each of eight, by half a step at most, and so do nodes of 8 bits.
  const int tolerance = GetParam().KeepsEightBits() ? 8 : 4;
  EXPECT_LE(LargestDifference(WithoutAlpha(scene.Render()), expected), tolerance);
}

// Fragments of alphas that each way to keep them takes for 0, which is what splats have.
TEST_P(Additive, LightBrightensNoFaintFragments)
{
  for (const double alpha : { 1e-3, 1e-5, 1e-8, 1e-10 })
  {
    SCOPED_TRACE(alpha);
    TestScene scene(16, 16);
    const int count = GetParam().Keeps(20) ? 19 : GetParam().MaxLayers - 1;
    std::vector<Layer> layers(count, { { 1.0, 1.0, 1.0, alpha }, false });
    for (std::size_t i = 0; i < layers.size(); ++i)
    {
      scene.AddPlate(0.9 - 0.05 * static_cast<double>(i), layers[i].Color);
    }
    layers.push_back({ RoundedTo8Bits({ 0.3, 0.1, 0.2, 0.4 }), true });
    AddLight(scene, -0.5, layers.back().Color);
    scene.Use(GetParam().Make());
    // In 8 bits they are lost.
    const double lost =
      GetParam().KeepsEightBits() || GetParam().HasGroups() ? 255 * alpha * count : 0.0;
    ExpectColor(UniformColor(scene.Render()), Composite(layers), GetParam().Tolerance + lost);
  }
}

// It comes and goes, and so do the shaders for it.
TEST_P(Additive, LightComesAndGoes)
{
  TestScene scene(16, 16);
  const std::vector<Layer> plates = { Mixed[1], Mixed[4] };
  AddLayers(scene, plates);
  const vtkSmartPointer<vtkActor> light = AddLight(scene, 0.95, Mixed[0].Color);
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  scene.Use(pass);
  for (int frame = 0; frame < 8; ++frame)
  {
    const bool isThere = frame / 2 % 2 == 1;
    light->SetVisibility(isThere);
    std::vector<Layer> layers = plates;
    if (isThere)
    {
      layers.insert(layers.begin(), Mixed[0]);
    }
    ExpectColor(UniformColor(scene.Render()), Composite(layers), GetParam().Tolerance + 0.5);
  }
}

// A frame draws the geometry once more where it learns that there is any; after that it draws as often as ever.
TEST_P(Additive, LightCostsAGeometryPassOnce)
{
  TestScene scene(16, 16);
  scene.AddPlate(0.0, Mixed[1].Color);
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  scene.Use(pass);
  AddLight(scene, 0.5, Mixed[0].Color);
  int passes[3];
  for (int& number : passes)
  {
    scene.Render();
    number = pass->GetNumberOfGeometryPasses();
  }
  EXPECT_GT(passes[0], passes[1]);
  EXPECT_EQ(passes[1], passes[2]);
}

// Among curved parts, partly hidden, in front and behind.
TEST_P(AdditiveSplats, AmongPartsAreTruth)
{
  for (const int samples : GetParam().Samples())
  {
    SCOPED_TRACE(std::to_string(samples) + " samples");
    TestScene scene(64, 48, samples);
    scene.AddParts();
    AddSplats(scene,
      { { 0.0, 0.0, 0.9 }, { 0.3, 0.2, 0.1 }, { -0.3, 0.1, -0.2 }, { -0.1, -0.4, 0.3 },
        { 0.5, -0.2, -0.8 } },
      { 0.4, 0.3, 0.2, 0.5 }, false);
    ExpectTruth(scene, GetParam().Make(), GetParam().Tolerance + 0.5);
  }
}

class TolerantAdditive : public testing::TestWithParam<Method>
{
};

// The mean over all orders: a plate of alpha a is in front of a splat, or behind it, as often.
TEST_P(TolerantAdditive, SplatsThatCoincideAreTheMeanOfAllOrders)
{
  TestScene scene(16, 16);
  const Rgba splat = RoundedTo8Bits({ 0.3, 0.2, 0.6, 0.5 });
  const std::vector<Rgba> plates = { RoundedTo8Bits({ 0.9, 0.1, 0.4, 0.4 }),
    RoundedTo8Bits({ 0.9, 0.1, 0.4, 0.6 }) };
  AddSplatPlate(scene, 0.3, splat);
  scene.AddPlate(0.3, plates[0]);
  scene.AddPlate(0.3, plates[1]);
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  auto* tolerant = vtkTolerantTransparencyPass::SafeDownCast(pass);
  ASSERT_NE(tolerant, nullptr);
  tolerant->SetCoincidenceSteps(16.0);
  scene.Use(pass);
  const double a = plates[0][3];
  const double b = plates[1][3];
  // None in front in a third of the orders, one in a third, both in a third.
  const double seen = (1.0 + 0.5 * (1.0 - a + 1.0 - b) + (1.0 - a) * (1.0 - b)) / 3.0;
  Rgba expected = CompositePlates(plates, TestBackground); // of one colour, so the order is nothing
  for (int c = 0; c < 3; ++c)
  {
    expected[c] += seen * splat[3] * splat[c];
  }
  ExpectColor(UniformColor(scene.Render()), expected, GetParam().Tolerance + 0.5);
  EXPECT_STREQ(pass->GetFallbackReason(), "");
}

// Many, so that weights are scaled to the sum that they must have; and more, so that all lies near t = 0.
TEST_P(TolerantAdditive, SplatsAmongManyPlatesHaveTheClosedForm)
{
  const std::pair<int, double> groups[] = { { 200, 252.0 / 255 }, { 300, 204.0 / 255 } };
  for (const auto& [count, alpha] : groups)
  {
    SCOPED_TRACE(count);
    TestScene scene(8, 8);
    scene.AddPlates(
      std::vector<Rgba>(count, { 0.0, 0.0, 0.0, alpha }), std::vector<double>(count, 0.3), 5);
    AddSplats(scene, std::vector<std::array<double, 3>>(120, { 0.0, 0.0, 0.3 }),
      { 1.0, 1.0, 1.0, 0.8 }, true);
    const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
    vtkTolerantTransparencyPass::SafeDownCast(pass)->SetCoincidenceSteps(16.0);
    scene.Use(pass);
    // The integral of (1 - t alpha)^count.
    const double seen = (1.0 - std::pow(1.0 - alpha, count + 1)) / ((count + 1) * alpha);
    const double gray = 120 * 0.8 * seen;
    ExpectColor(UniformColor(scene.Render()), { gray, gray, gray, 1.0 }, 1.2);
  }
}

// Which are points, and those the method refuses.
TEST(AdditiveOfMasks, SplatsAreRefused)
{
  TestScene scene(16, 16);
  AddSplatPlate(scene, 0.0, Mixed[0].Color);
  const vtkSmartPointer<vtkTransparencyPass> pass = MaskMethods().front().Make();
  scene.Use(pass);
  scene.Render();
  ExpectRefusal(pass, "points");
}

INSTANTIATE_TEST_SUITE_P(Methods, Additive, testing::ValuesIn(AllMethods()), MethodName());
INSTANTIATE_TEST_SUITE_P(Methods, AdditiveSplats,
  testing::ValuesIn(MethodsThat([](const Method& method) { return !method.HasGroups(); })),
  MethodName());
INSTANTIATE_TEST_SUITE_P(Methods, TolerantAdditive,
  testing::ValuesIn(MethodsThat([](const Method& method)
    { return vtkTolerantTransparencyPass::SafeDownCast(method.Make()) != nullptr; })),
  MethodName());

}
