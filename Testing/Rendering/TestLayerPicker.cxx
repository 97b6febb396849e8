// The layers under pixels, with their parts, by lists and by drawing again (inspection/vtkLayerPicker).

#include "CompositeMapper.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/VitrineOpenGL.h"

#include "vtkABufferTransparencyPass.h"
#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCubeSource.h"
#include "vtkCulledCompositePolyDataMapper.h"
#include "vtkCullerCollection.h"
#include "vtkDummyController.h"
#include "vtkFollower.h"
#include "vtkHierarchicalSBufferCuller.h"
#include "vtkIdTypeArray.h"
#include "vtkLayerPicker.h"
#include "vtkLineSource.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSection.h"
#include "vtkSeeThroughPass.h"
#include "vtkUnsignedIntArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{

constexpr int Width = 64;
constexpr int Height = 48;

/** What a picker tells of one layer. */
struct Told
{
  vtkProp* Prop;
  unsigned int Block;
  double Share;
};

std::vector<Told> LayersAt(
  vtkLayerPicker* picker, vtkRenderer* renderer, int x, int y, bool behind = false)
{
  picker->SetRenderer(renderer);
  picker->SetPosition(x, y);
  picker->SetBehindOpaque(behind);
  EXPECT_TRUE(picker->Pick()) << picker->GetProblem();
  std::vector<Told> told;
  for (vtkIdType i = 0; i < picker->GetNumberOfLayers(); ++i)
  {
    told.push_back({ picker->GetProp(i), picker->GetBlock(i), picker->GetShare(i) });
  }
  return told;
}

void ExpectParts(const std::vector<Told>& told, const std::vector<vtkProp*>& props)
{
  std::vector<vtkProp*> found;
  for (const Told& layer : told)
  {
    found.push_back(layer.Prop);
  }
  EXPECT_EQ(found, props);
}

/** Plates at heights from 0.8 down, of which the fourth is opaque. */
struct Plates
{
  explicit Plates(TestScene& scene)
    : All{ scene.AddPlate(0.8, { 1.0, 0.0, 0.0, 0.5 }),
      scene.AddPlate(0.4, { 0.0, 1.0, 0.0, 0.25 }), scene.AddPlate(-0.2, { 0.0, 0.0, 1.0, 0.5 }),
      scene.AddPlate(-0.4, { 1.0, 1.0, 0.0, 1.0 }), scene.AddPlate(-0.6, { 0.0, 1.0, 1.0, 0.5 }) }
  {
  }
  vtkSmartPointer<vtkActor> All[5];
};

class LayerPicker : public testing::TestWithParam<Method>
{
};

TEST_P(LayerPicker, TellsLayersOfListsAsOfADraw)
{
  for (const int samples : GetParam().Samples())
  {
    SCOPED_TRACE(std::to_string(samples) + " samples");
    TestScene scene(Width, Height, samples);
    const Plates plates(scene);
    const auto pass = MakeABuffer(GetParam());
    scene.Use(pass);
    const Picture before = scene.Render();
    vtkNew<vtkLayerPicker> picker;
    for (const bool lists : { false, true })
    {
      SCOPED_TRACE(lists ? "lists" : "drawn");
      pass->SetPartNumbers(lists);
      EXPECT_TRUE(Matches(scene.Render(), before));
      EXPECT_TRUE(Matches(scene.Render(), before));
      const vtkTypeInt64 fragments = pass->GetNumberOfFragments();
      const int passes = pass->GetNumberOfGeometryPasses();
      const auto told = LayersAt(picker, scene.Renderer, 20, 30);
      ExpectParts(told, { plates.All[0], plates.All[1], plates.All[2], plates.All[3] });
      ASSERT_EQ(told.size(), 4u);
      const double tolerance = GetParam().KeepsEightBits() ? 0.6 / 255.0 : 1e-4;
      EXPECT_NEAR(told[0].Share, 0.5, tolerance);
      EXPECT_NEAR(told[1].Share, 0.125, tolerance);
      EXPECT_NEAR(told[2].Share, 0.1875, tolerance);
      EXPECT_NEAR(told[3].Share, 0.1875, tolerance);
      EXPECT_EQ(picker->GetNumberOfListedLayers(), lists ? 3 : 0);
      EXPECT_NEAR(picker->GetWorldPosition(1)[2], 0.4, 1e-5);
      EXPECT_NEAR(picker->GetDistance(1) - picker->GetDistance(0), 0.4, 1e-5);
      EXPECT_NEAR(picker->GetColor(2)[2], 1.0, 1.0 / 255.0);
      EXPECT_TRUE(picker->GetOpaque(3));
      EXPECT_FALSE(picker->GetOpaque(2));
      EXPECT_EQ(picker->GetCoverage(0), 1.0);
      const auto all = LayersAt(picker, scene.Renderer, 20, 30, true);
      ExpectParts(
        all, { plates.All[0], plates.All[1], plates.All[2], plates.All[3], plates.All[4] });
      EXPECT_EQ(all[4].Share, 0.0);
      // Neither the statistics nor the next frame notice.
      EXPECT_EQ(pass->GetNumberOfFragments(), fragments);
      EXPECT_EQ(pass->GetNumberOfGeometryPasses(), passes);
      EXPECT_TRUE(Matches(scene.Render(), before));
    }
  }
}

TEST_P(LayerPicker, MovesPartsWithNodesThatAreSorted)
{
  // More layers than a network sorts, in shuffled order, of two props in turn.
  TestScene scene(16, 12);
  const int count = 90;
  std::vector<vtkSmartPointer<vtkActor>> actors(count);
  TestRandom random(51);
  std::vector<int> order(count);
  for (int i = 0; i < count; ++i)
  {
    order[i] = i;
    std::swap(order[i], order[random.Next() % (i + 1)]);
  }
  for (const int i : order)
  {
    actors[i] = scene.AddPlate(0.9 - 0.02 * i, { 0.5, 0.5, 0.5, 0.02 });
  }
  const auto pass = MakeABuffer(GetParam());
  pass->SetPartNumbers(true);
  scene.Use(pass);
  scene.Render();
  scene.Render();
  vtkNew<vtkLayerPicker> picker;
  const auto told = LayersAt(picker, scene.Renderer, 7, 5);
  ExpectParts(told, std::vector<vtkProp*>(actors.begin(), actors.end()));
  EXPECT_EQ(picker->GetNumberOfListedLayers(), count);
}

INSTANTIATE_TEST_SUITE_P(Methods, LayerPicker, testing::ValuesIn(ABufferMethods()), MethodName());

/** Blocks: a cube, none, and a group of a hidden cube and a cube, one behind the other along z. */
vtkSmartPointer<vtkActor> Blocks(vtkPolyDataMapper* mapper, double alpha, bool edges)
{
  vtkNew<vtkMultiBlockDataSet> blocks, group;
  const auto cubeAt = [](double z)
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetCenter(0.0, 0.0, z);
    cube->SetXLength(1.0);
    cube->SetYLength(1.0);
    cube->SetZLength(0.2);
    cube->Update();
    vtkSmartPointer<vtkPolyData> data = cube->GetOutput();
    return data;
  };
  blocks->SetBlock(0, cubeAt(0.5));
  blocks->SetBlock(2, group);
  group->SetBlock(0, cubeAt(0.0));
  group->SetBlock(1, cubeAt(-0.5));
  mapper->SetInputDataObject(blocks);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(alpha);
  actor->GetProperty()->SetEdgeVisibility(edges);
  return actor;
}

template <class Mapper>
void ExpectBlocks()
{
  for (const bool edges : { false, true })
  {
    for (const double alpha : { 0.5, 1.0 })
    {
      SCOPED_TRACE((edges ? "edges, " : "") + std::to_string(alpha));
      TestScene scene(Width, Height);
      vtkNew<Mapper> mapper;
      const auto actor = Blocks(mapper, alpha, edges);
      vtkNew<vtkCompositeDataDisplayAttributes> attributes;
      mapper->SetCompositeDataDisplayAttributes(attributes);
      scene.Renderer->AddActor(scene.AddPlate(0.9, { 1.0, 1.0, 1.0, 0.1 }));
      scene.Renderer->AddActor(actor);
      auto pass =
        vtkSmartPointer<vtkTransparencyPass>::Take(vtkTransparencyPass::NewMethod("linked-list"));
      vtkABufferTransparencyPass::SafeDownCast(pass)->SetPartNumbers(true);
      scene.Use(pass);
      scene.Render();
      mapper->SetBlockVisibility(
        4, false); // the third leaf's number: root 0, leaf 1, none 2, group 3
      scene.Render();
      vtkNew<vtkLayerPicker> picker;
      const auto told = LayersAt(picker, scene.Renderer, Width / 2 + 8, Height / 2 - 3, true);
      std::vector<unsigned int> blocks;
      std::vector<bool> fronts;
      for (std::size_t i = 0; i < told.size(); ++i)
      {
        if (told[i].Prop == actor)
        {
          blocks.push_back(told[i].Block);
          fronts.push_back(picker->GetFrontFace(static_cast<vtkIdType>(i)));
          EXPECT_EQ(picker->GetOpaque(static_cast<vtkIdType>(i)), alpha == 1.0);
        }
      }
      EXPECT_EQ(blocks, (std::vector<unsigned int>{ 1, 1, 5, 5 }));
      EXPECT_EQ(fronts, (std::vector<bool>{ true, false, true, false }));
      if (alpha < 1.0)
      {
        LayersAt(picker, scene.Renderer, Width / 2 + 8, Height / 2 - 3);
        EXPECT_EQ(picker->GetNumberOfListedLayers(), 5);
        EXPECT_EQ(picker->GetBlock(1), 1u);
        EXPECT_EQ(picker->GetBlock(4), 5u);
      }
    }
  }
}

TEST(LayersOfBlocks, HaveFlatIndices)
{
  ExpectBlocks<CompositeMapper>();
}

TEST(LayersOfBlocks, HaveFlatIndicesWithTheCulledMapper)
{
  ExpectBlocks<vtkCulledCompositePolyDataMapper>();
}

TEST(LayersOfProps, AreOfTheirUsers)
{
  TestScene scene(Width, Height);
  // An actor within an assembly is a part, and a follower is itself, though another actor draws it.
  vtkNew<vtkAssembly> assembly;
  auto within = scene.AddPlate(0.5, { 1.0, 0.0, 0.0, 0.5 });
  scene.Renderer->RemoveActor(within);
  assembly->AddPart(within);
  scene.Renderer->AddActor(assembly);
  vtkNew<vtkFollower> follower;
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  follower->SetMapper(mapper);
  follower->SetCamera(scene.Renderer->GetActiveCamera());
  follower->GetProperty()->SetOpacity(0.5);
  scene.Renderer->AddActor(follower);
  auto wide = scene.AddSource(
    []
    {
      static vtkNew<vtkLineSource> line;
      line->SetPoint1(-1.0, 0.0, -0.5);
      line->SetPoint2(1.0, 0.0, -0.5);
      return line.GetPointer();
    }(),
    { 0.0, 0.0, 1.0, 0.5 });
  wide->GetProperty()->SetLineWidth(8.0);
  scene.Render();
  vtkNew<vtkLayerPicker> picker;
  ExpectParts(LayersAt(picker, scene.Renderer, Width / 2, Height / 2), { within, follower, wide });
  EXPECT_EQ(picker->GetCellId(0), 0);
  EXPECT_EQ(picker->GetCellId(2), -1);
  // Hidden props are no layers, without a frame in between.
  follower->SetVisibility(false);
  ExpectParts(LayersAt(picker, scene.Renderer, Width / 2, Height / 2), { within, wide });
}

TEST(LayersOfProps, AgreeWithClippingAndCulling)
{
  TestScene scene(Width, Height);
  const Plates plates(scene);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.0, 0.0); // keeps x >= 0
  plates.All[1]->GetMapper()->AddClippingPlane(plane);
  plates.All[3]->GetMapper()->AddClippingPlane(plane);
  vtkNew<vtkHierarchicalSBufferCuller> culler;
  scene.Renderer->GetCullers()->RemoveAllItems();
  scene.Renderer->AddCuller(culler);
  scene.Render();
  vtkNew<vtkLayerPicker> picker;
  ExpectParts(LayersAt(picker, scene.Renderer, Width / 4, Height / 2),
    { plates.All[0], plates.All[2], plates.All[4] });
  ExpectParts(LayersAt(picker, scene.Renderer, 3 * Width / 4, Height / 2, true),
    { plates.All[0], plates.All[1], plates.All[2], plates.All[3], plates.All[4] });
}

// Of opaque faces in one plane that with the last triangle is in front, also where a geometry shader draws edges.
TEST(LayersOfProps, OfEqualDepthAreInTheOrderOfTriangles)
{
  const std::vector<Rgba> colors = { { 1.0, 0.0, 0.0, 1.0 }, { 0.0, 1.0, 0.0, 1.0 },
    { 0.0, 0.0, 1.0, 1.0 }, { 1.0, 1.0, 0.0, 1.0 } };
  for (const bool edges : { false, true })
  {
    SCOPED_TRACE(edges);
    for (const std::uint64_t seed : { 1, 2, 3, 4 })
    {
      TestScene scene(Width, Height);
      vtkActor* const actor = scene.AddPlates(colors, { 0.0, 0.0, 0.0, 0.0 }, seed);
      actor->ForceTranslucentOff();
      actor->GetProperty()->SetEdgeVisibility(edges);
      const Rgba seen = scene.Render().At(9, 5);
      vtkNew<vtkLayerPicker> picker;
      ASSERT_EQ(LayersAt(picker, scene.Renderer, 9, 5, true).size(), colors.size());
      const double* const first = picker->GetColor(0);
      ExpectColor({ first[0], first[1], first[2], seen[3] }, seen, 0.5);
    }
  }
}

// VTK's mappers draw blocks in the order of the addresses of their data, and since 9.3 in that of their numbers.
TEST(LayersOfBlocks, OfEqualDepthAreInTheOrderOfDrawing)
{
  std::vector<vtkSmartPointer<vtkPolyData>> plates;
  for (int i = 0; i < 4; ++i)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->Update();
    plates.emplace_back(plane->GetOutput());
  }
  std::sort(plates.begin(), plates.end());
  for (const bool reversed : { false, true })
  {
    SCOPED_TRACE(reversed);
    TestScene scene(Width, Height);
    vtkNew<vtkMultiBlockDataSet> blocks;
    vtkNew<CompositeMapper> mapper;
    mapper->SetInputDataObject(blocks);
    vtkNew<vtkCompositeDataDisplayAttributes> attributes;
    mapper->SetCompositeDataDisplayAttributes(attributes);
    for (unsigned int i = 0; i < 4; ++i)
    {
      blocks->SetBlock(i, plates[reversed ? 3 - i : i]);
      const double color[3] = { i / 4.0, 1.0, 0.0 };
      attributes->SetBlockColor(blocks->GetBlock(i), color);
    }
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    scene.Renderer->AddActor(actor);
    const Rgba seen = scene.Render().At(Width / 2, Height / 2);
    vtkNew<vtkLayerPicker> picker;
    ASSERT_EQ(LayersAt(picker, scene.Renderer, Width / 2, Height / 2, true).size(), 4u);
    const double* const first = picker->GetColor(0);
    ExpectColor({ first[0], first[1], first[2], seen[3] }, seen, 1.0);
  }
}

/** What a pick may not change. */
std::vector<GLint> StateOfGL()
{
  std::vector<GLint> state;
  for (const GLenum name : { GL_DRAW_FRAMEBUFFER_BINDING, GL_READ_FRAMEBUFFER_BINDING, GL_VIEWPORT,
         GL_SCISSOR_BOX, GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING, GL_ARRAY_BUFFER_BINDING,
         GL_ACTIVE_TEXTURE, GL_DEPTH_WRITEMASK, GL_DEPTH_FUNC, GL_COLOR_WRITEMASK, GL_BLEND_SRC_RGB,
         GL_BLEND_DST_RGB, GL_SHADER_STORAGE_BUFFER_BINDING, GL_COPY_WRITE_BUFFER_BINDING })
  {
    GLint values[4] = {};
    glGetIntegerv(name, values);
    state.insert(state.end(), values, values + 4);
  }
  for (const GLenum name : { GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_STENCIL_TEST,
         GL_CULL_FACE, GL_MULTISAMPLE, GL_DEPTH_CLAMP })
  {
    state.push_back(glIsEnabled(name));
  }
  return state;
}

TEST(LayersOfProps, AgreeWithSections)
{
  TestScene scene(Width, Height);
  auto plate = scene.AddPlate(0.8, { 1.0, 0.0, 0.0, 0.5 });
  auto ball = scene.AddSphere(0.0, 0.0, 0.0, 0.7, { 0.0, 1.0, 0.0, 0.5 }, 24);
  auto pass =
    vtkSmartPointer<vtkTransparencyPass>::Take(vtkTransparencyPass::NewMethod("linked-list"));
  auto* const lists = vtkABufferTransparencyPass::SafeDownCast(pass);
  vtkNew<vtkSection> section;
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 0.3);
  plane->SetNormal(0.0, 0.0, -1.0);
  section->AddPlane(plane); // keeps z <= 0.3
  section->Attach(scene.Renderer);
  scene.Use(pass);
  vtkNew<vtkLayerPicker> picker;
  for (const bool numbers : { false, true })
  {
    lists->SetPartNumbers(numbers);
    scene.Render();
    scene.Render();
    // The plate and the front of the ball are gone. A cap closes the ball, with the ball's own number.
    const auto told = LayersAt(picker, scene.Renderer, Width / 2 + 3, Height / 2 + 2);
    ExpectParts(told, { ball, ball });
    EXPECT_EQ(picker->GetNumberOfListedLayers(), numbers ? 2 : 0);
    EXPECT_NEAR(picker->GetWorldPosition(0)[2], 0.3, 1e-3);
    EXPECT_LT(picker->GetWorldPosition(1)[2], -0.5);
  }
  section->Detach();
  scene.Render();
  ExpectParts(
    LayersAt(picker, scene.Renderer, Width / 2 + 3, Height / 2 + 2), { plate, ball, ball });
}

TEST(LayersOfAnArea, LeaveTheStateOfOpenGL)
{
  for (const bool numbers : { false, true })
  {
    TestScene scene(Width, Height);
    scene.AddParts();
    auto pass =
      vtkSmartPointer<vtkTransparencyPass>::Take(vtkTransparencyPass::NewMethod("linked-list"));
    vtkABufferTransparencyPass::SafeDownCast(pass)->SetPartNumbers(numbers);
    scene.Use(pass);
    scene.Render();
    const std::vector<GLint> before = StateOfGL();
    vtkNew<vtkLayerPicker> picker;
    EXPECT_GT(LayersAt(picker, scene.Renderer, Width / 2, Height / 2, true).size(), 0u);
    EXPECT_EQ(StateOfGL(), before);
    EXPECT_GT(LayersAt(picker, scene.Renderer, Width / 2, Height / 2, false).size(), 0u);
    EXPECT_EQ(StateOfGL(), before);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
}

// Parts of layers are told by their ranks, which another controller does not have.
TEST(LayersOfAnArea, AreGoneAfterAnotherController)
{
  TestScene scene(Width, Height);
  scene.AddParts();
  scene.Render();
  vtkNew<vtkLayerPicker> picker;
  EXPECT_GT(LayersAt(picker, scene.Renderer, Width / 2, Height / 2, true).size(), 0u);
  picker->SetController(nullptr); // as before
  EXPECT_GT(picker->GetNumberOfLayers(), 0);
  vtkNew<vtkDummyController> controller;
  picker->SetController(controller);
  EXPECT_EQ(picker->GetNumberOfLayers(), 0);
  EXPECT_EQ(picker->GetOffsets()->GetNumberOfValues(), 0);
}

TEST(LayersOfAnArea, AreInRowsOfPixels)
{
  TestScene scene(Width, Height);
  auto left = scene.AddRectangle(-1.0, -1.0, 0.0, 1.0, 0.5, { 1.0, 0.0, 0.0, 0.5 });
  auto all = scene.AddPlate(0.0, { 0.0, 1.0, 0.0, 1.0 });
  auto pass =
    vtkSmartPointer<vtkTransparencyPass>::Take(vtkTransparencyPass::NewMethod("prefix-sum"));
  auto* const lists = vtkABufferTransparencyPass::SafeDownCast(pass);
  lists->SetPartNumbers(true);
  scene.Use(pass);
  scene.Render();
  EXPECT_EQ(lists->GetPoolBytes(), pass->GetNumberOfFragments() * (12 + 4));
  vtkNew<vtkLayerPicker> picker;
  picker->SetRenderer(scene.Renderer);
  picker->SetArea(Width / 2 + 1, 10, Width / 2 - 2, 12); // corners in any order
  for (const bool opaque : { true, false })
  {
    picker->SetOpaqueLayers(opaque);
    ASSERT_TRUE(picker->Pick()) << picker->GetProblem();
    ASSERT_EQ(picker->GetOffsets()->GetNumberOfValues(), 13);
    vtkIdType at = 0;
    for (int pixel = 0; pixel < 12; ++pixel)
    {
      const bool isLeft = pixel % 4 < 2;
      EXPECT_EQ(picker->GetOffsets()->GetValue(pixel), at);
      if (isLeft)
      {
        EXPECT_EQ(picker->GetPropOfPart(picker->GetPartNumbers()->GetValue(at++)), left);
      }
      if (opaque)
      {
        EXPECT_EQ(picker->GetPropOfPart(picker->GetPartNumbers()->GetValue(at++)), all);
      }
    }
    EXPECT_EQ(picker->GetNumberOfLayers(), at);
  }
}

TEST(LayersOfViewports, AreOfTheirRenderer)
{
  TestScene scene(Width, Height);
  auto first = scene.AddPlate(0.0, { 1.0, 0.0, 0.0, 0.5 });
  scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.5, 0.0, 1.0, 1.0);
  other->AddActor(scene.AddSphere(0.0, 0.0, 0.0, 0.5, { 0.0, 1.0, 0.0, 0.5 }));
  scene.Window->AddRenderer(other);
  scene.Render();
  vtkNew<vtkLayerPicker> picker;
  EXPECT_EQ(LayersAt(picker, scene.Renderer, Width / 4 - 14, Height / 2).size(), 1u);
  const auto told = LayersAt(picker, other, 3 * Width / 4, Height / 2); // a perspective camera
  EXPECT_EQ(told.size(), 2u);
  const double* const eye = other->GetActiveCamera()->GetPosition();
  EXPECT_NEAR(picker->GetDistance(1) - picker->GetDistance(0), 1.0, 0.05);
  EXPECT_NEAR(picker->GetDistance(0), eye[2] - 0.5, 0.05);
  picker->SetPosition(Width / 4, 3);
  EXPECT_FALSE(picker->Pick());
  EXPECT_NE(picker->GetProblem().find("not within the renderer's viewport"), std::string::npos);
}

TEST(LayerPickerProblems, AreTold)
{
  vtkNew<vtkLayerPicker> picker;
  EXPECT_FALSE(picker->Pick());
  EXPECT_EQ(picker->GetProblem(), "there is no renderer: call SetRenderer()");
  EXPECT_EQ(picker->GetNumberOfLayers(), 0);
  EXPECT_EQ(picker->GetProp(0), nullptr);
  EXPECT_EQ(picker->GetCellId(-1), -1);
  EXPECT_EQ(picker->PickThrough(0.5), -1);
  {
    vtkNew<vtkRenderer> lonely;
    picker->SetRenderer(lonely);
    EXPECT_FALSE(picker->Pick());
  }
  EXPECT_EQ(picker->GetRenderer(), nullptr);
  TestScene scene(Width, Height);
  scene.AddPlate(0.0, { 1.0, 0.0, 0.0, 0.5 });
  picker->SetRenderer(scene.Renderer);
  EXPECT_FALSE(picker->Pick());
  EXPECT_NE(picker->GetProblem().find("no frame"), std::string::npos);
  scene.Render();
  EXPECT_TRUE(picker->Pick()) << picker->GetProblem();
  EXPECT_EQ(picker->GetNumberOfLayers(), 1);
  EXPECT_EQ(picker->PickThrough(0.5), 0);
  EXPECT_EQ(picker->PickThrough(0.6), -1);
  EXPECT_EQ(picker->PickThrough(std::numeric_limits<double>::quiet_NaN()), -1);
  const int most = std::numeric_limits<int>::max(), least = std::numeric_limits<int>::min();
  for (const auto& area : { std::array<int, 4>{ least, least, most, most }, { 0, 0, Width, 0 },
         { -1, 0, 0, 0 }, { 0, Height, 0, Height } })
  {
    picker->SetArea(area[0], area[1], area[2], area[3]);
    EXPECT_FALSE(picker->Pick());
    EXPECT_EQ(picker->GetNumberOfLayers(), 0);
  }
}

}
