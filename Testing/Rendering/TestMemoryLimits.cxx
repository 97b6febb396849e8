// The linked-list pass where memory is short, props are unsteady, or frames of several views share one pool.
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/VitrineOpenGL.h"
#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRendererCollection.h"
#include "vtkSeeThroughPass.h"
#include "vtkTranslucentPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace
{

constexpr int Width = 16;
constexpr int Height = 16;

Picture RenderAsVTK(TestScene& scene)
{
  vtkNew<vtkOrderIndependentTranslucentPass> weighted;
  vtkNew<vtkTranslucentPass> translucent;
  weighted->SetTranslucentPass(translucent);
  scene.Use(weighted);
  return scene.Render();
}

// Takes the one message that a fallback leaves.
void ExpectFallbackSays(vtkTransparencyPass* pass, const std::string& text)
{
  EXPECT_NE(std::string(pass->GetFallbackReason()).find(text), std::string::npos)
    << pass->GetFallbackReason();
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find(text), std::string::npos) << messages[0];
}

//------------------------------------------------------------------------------
// A driver that has memory for buffers of `Memory` bytes at most: larger ones it is asked for with a size that no
// driver has.
class ScarceBuffers
{
public:
  explicit ScarceBuffers(GLsizeiptr memory)
  {
    Memory = memory;
    Refusals = 0;
    Driver = glBufferData;
    glBufferData = Allocate;
  }
  ~ScarceBuffers() { glBufferData = Driver; }
  static int Refusals;

private:
  static void Allocate(GLenum target, GLsizeiptr size, const void* data, GLenum usage)
  {
    const bool refuses = target == GL_SHADER_STORAGE_BUFFER && size > Memory;
    Refusals += refuses ? 1 : 0;
    Driver(target, refuses ? GLsizeiptr(1) << 50 : size, data, usage);
  }
  static GLsizeiptr Memory;
  static decltype(glBufferData) Driver;
};
int ScarceBuffers::Refusals = 0;
GLsizeiptr ScarceBuffers::Memory = 0;
decltype(glBufferData) ScarceBuffers::Driver = nullptr;

class DriverMemory : public testing::Test
{
protected:
  DriverMemory() { this->Scene.AddPlates(RandomPlates(40, 0.1, 5), 6); }

  // The refusals themselves are what OpenGL complains about.
  static void DropOutOfMemory()
  {
    for (const std::string& message : TakeMessages())
    {
      EXPECT_NE(message.find("OUT_OF_MEMORY"), std::string::npos) << message;
    }
  }

  TestScene Scene = TestScene(Width, Height);
};

TEST_F(DriverMemory, ForNoReserveIsEnough)
{
  vtkNew<vtkLinkedListTransparencyPass> pass;
  this->Scene.Use(pass);
  const Picture expected = this->Scene.Render();
  const GLsizeiptr least = 40 * Width * Height * 12;
  vtkNew<vtkLinkedListTransparencyPass> frugal;
  this->Scene.Use(frugal);
  {
    const ScarceBuffers scarce(least);
    EXPECT_TRUE(this->Scene.Render() == expected);
    DropOutOfMemory();
  }
  EXPECT_STREQ(frugal->GetFallbackReason(), "");
  EXPECT_EQ(frugal->GetNumberOfBands(), 1);
  EXPECT_EQ(ScarceBuffers::Refusals, 1);
}

TEST_F(DriverMemory, ForAPartIsDrawnInBands)
{
  vtkNew<vtkLinkedListTransparencyPass> pass;
  this->Scene.Use(pass);
  const Picture expected = this->Scene.Render();
  vtkNew<vtkLinkedListTransparencyPass> frugal;
  this->Scene.Use(frugal);
  {
    const ScarceBuffers scarce(40 * Width * Height * 12 / 5);
    EXPECT_TRUE(this->Scene.Render() == expected);
    EXPECT_STREQ(frugal->GetFallbackReason(), "");
    EXPECT_GT(frugal->GetNumberOfBands(), 4);
    EXPECT_LE(frugal->GetNumberOfBands(), 20);
    DropOutOfMemory();

    // Remembered, so that the driver is not asked in vain every frame.
    const int refusals = ScarceBuffers::Refusals;
    EXPECT_TRUE(this->Scene.Render() == expected);
    EXPECT_EQ(ScarceBuffers::Refusals, refusals);
  }
  for (int frame = 0; frame < 40; ++frame)
  {
    this->Scene.Render();
  }
  EXPECT_EQ(frugal->GetNumberOfBands(), 1); // there is memory again
}

TEST_F(DriverMemory, ForNothingIsSaid)
{
  const Picture byVTK = RenderAsVTK(this->Scene);
  vtkNew<vtkLinkedListTransparencyPass> pass;
  this->Scene.Use(pass);
  {
    const ScarceBuffers scarce(100);
    EXPECT_TRUE(this->Scene.Render() == byVTK);
  }
  EXPECT_STREQ(pass->GetFallbackReason(), "the driver has no memory for the smallest node pool");
  TakeMessages();
  ExpectTruth(this->Scene, pass, 2.0);
}

//------------------------------------------------------------------------------
// Draws its translucent geometry as often as Draws[n] says the n-th time that fragments are stored, or the last one
// after that; and `Steadily` times where fragments are blended.
class UnsteadyActor : public vtkOpenGLActor
{
public:
  static UnsteadyActor* New();
  vtkTypeMacro(UnsteadyActor, vtkOpenGLActor);

  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override
  {
    GLint buffer = GL_NONE;
    glGetIntegerv(GL_DRAW_BUFFER0, &buffer);
    const int draws = buffer == GL_NONE
      ? this->Draws[std::min(this->Calls++, this->Draws.size() - 1)]
      : this->Steadily;
    int rendered = 0;
    for (int i = 0; i < draws; ++i)
    {
      rendered = this->Superclass::RenderTranslucentPolygonalGeometry(viewport);
    }
    return rendered;
  }

  std::vector<int> Draws;
  int Steadily = 3;

private:
  std::size_t Calls = 0;
};
vtkStandardNewMacro(UnsteadyActor);

class UnsteadyProps : public testing::Test
{
protected:
  void AddActor(std::vector<int> draws)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-2.0, -2.0, 0.0);
    plane->SetPoint1(2.0, -2.0, 0.0);
    plane->SetPoint2(-2.0, 2.0, 0.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    this->Actor->SetMapper(mapper);
    this->Actor->GetProperty()->SetColor(0.8, 0.2, 0.4);
    this->Actor->GetProperty()->SetOpacity(0.1);
    this->Actor->GetProperty()->LightingOff();
    this->Actor->Draws = std::move(draws);
    this->Scene.Renderer->AddActor(this->Actor);
  }

  void ExpectLayers(const Picture& picture, int layers)
  {
    const Rgba color = UniformColor(picture);
    const Rgba expected =
      CompositePlates(std::vector<Rgba>(layers, { 0.8, 0.2, 0.4, 0.1 }), TestBackground);
    for (int c = 0; c < 4; ++c)
    {
      EXPECT_NEAR(255.0 * color[c], 255.0 * expected[c], 1.0) << "channel " << c;
    }
  }

  vtkNew<UnsteadyActor> Actor;
  TestScene Scene = TestScene(Width, Height);
};

TEST_F(UnsteadyProps, AreDrawnAgainWhereTheyOutgrowThePool)
{
  this->AddActor({ 2, 30, 30 });
  vtkNew<vtkLinkedListTransparencyPass> pass;
  this->Scene.Use(pass);
  ExpectLayers(this->Scene.Render(), 30);
  EXPECT_STREQ(pass->GetFallbackReason(), "");
  EXPECT_EQ(pass->GetGeometryPasses(), 3);
}

TEST_F(UnsteadyProps, ThatGrowForEverAreSaidTo)
{
  this->AddActor({ 2, 10, 40, 160 });
  const Picture byVTK = RenderAsVTK(this->Scene);
  vtkNew<vtkLinkedListTransparencyPass> pass;
  this->Scene.Use(pass);
  EXPECT_TRUE(this->Scene.Render() == byVTK);
  ExpectFallbackSays(pass, "make more fragments each time");
}

TEST_F(UnsteadyProps, AreDrawnAgainWhereTheyOutgrowBands)
{
  this->AddActor({ 4, 4, 20 }); // the frame, its first band, and all after that
  vtkNew<vtkLinkedListTransparencyPass> pass;
  pass->SetMemoryLimit(16 * 4 * Width * 3);
  this->Scene.Use(pass);
  ExpectLayers(this->Scene.Render(), 20);
  EXPECT_STREQ(pass->GetFallbackReason(), "");
  EXPECT_GT(pass->GetNumberOfBands(), 20);
}

TEST_F(UnsteadyProps, ThatGrowForEverInBandsLeaveNoTrace)
{
  std::vector<int> draws = { 4,
    4 }; // the first band is in the picture before the second does not fit
  for (int draw = 5; draw < 190; ++draw)
  {
    draws.push_back(draw);
  }
  this->AddActor(draws);
  const Picture byVTK = RenderAsVTK(this->Scene);
  vtkNew<vtkLinkedListTransparencyPass> pass;
  pass->SetMemoryLimit(16 * 4 * Width * 3);
  this->Scene.Use(pass);
  EXPECT_TRUE(this->Scene.Render() == byVTK);
  ExpectFallbackSays(pass, "make more fragments each time");
}

//------------------------------------------------------------------------------
TEST(PagesAtTheLimit, AreOfOneNodeWhereLargerOnesDoNotFit)
{
  const std::vector<Rgba> plates = RandomPlates(80, 0.05, 7);
  TestScene scene(4, 4);
  scene.AddPlates(plates, 8);
  vtkNew<vtkLinkedListTransparencyPass> unlimited;
  scene.Use(unlimited);
  const Picture expected = scene.Render();
  for (const int limit : { 80 * 16, 1300, 1600, 2000, 3100 })
  {
    SCOPED_TRACE(limit);
    vtkNew<vtkLinkedListTransparencyPass> pass;
    pass->SetMemoryLimit(limit);
    scene.Use(pass);
    for (int frame = 0; frame < 3; ++frame)
    {
      EXPECT_TRUE(scene.Render() == expected);
      EXPECT_STREQ(pass->GetFallbackReason(), "");
      EXPECT_GT(pass->GetNumberOfBands(), 1);
      EXPECT_LE(pass->GetPoolBytes(), limit);
    }
  }
  vtkNew<vtkLinkedListTransparencyPass> pass;
  pass->SetMemoryLimit(80 * 16 - 1);
  scene.Use(pass);
  scene.Render();
  ExpectFallbackSays(
    pass, "one pixel alone needs 1280 bytes of the node pool, and its limit is 1279 bytes");
}

//------------------------------------------------------------------------------
// One pass that draws several viewports side by side, each of some number of plates.
class SharedPool : public testing::Test
{
protected:
  void AddViewports(const std::vector<int>& layers)
  {
    this->Scene.Window->RemoveRenderer(this->Scene.Renderer);
    const double width = 1.0 / static_cast<double>(layers.size());
    for (std::size_t i = 0; i < layers.size(); ++i)
    {
      TestScene maker;
      maker.AddPlates(RandomPlates(layers[i], 0.05, 3), 4);
      maker.Window->RemoveRenderer(maker.Renderer);
      maker.Renderer->SetViewport(width * i, 0.0, width * (i + 1), 1.0);
      maker.Renderer->SetPass(this->SeeThrough);
      this->Scene.Window->AddRenderer(maker.Renderer);
    }
    this->SeeThrough->SetTranslucentPass(this->Pass);
  }

  // How often the pool has another size than after the viewport before.
  int Changes(int frames)
  {
    int changes = 0;
    vtkTypeInt64 before = this->Pass->GetPoolBytes();
    std::function<void()> count = [&]
    {
      changes += this->Pass->GetPoolBytes() != before ? 1 : 0;
      before = this->Pass->GetPoolBytes();
    };
    vtkNew<vtkCallbackCommand> afterViewport;
    afterViewport->SetClientData(&count);
    afterViewport->SetCallback([](vtkObject*, unsigned long, void* data, void*)
      { (*static_cast<std::function<void()>*>(data))(); });
    vtkRendererCollection* renderers = this->Scene.Window->GetRenderers();
    renderers->InitTraversal();
    while (vtkRenderer* renderer = renderers->GetNextItem())
    {
      renderer->AddObserver(vtkCommand::EndEvent, afterViewport);
    }
    for (int frame = 0; frame < frames; ++frame)
    {
      this->Scene.Render();
    }
    renderers->InitTraversal();
    while (vtkRenderer* renderer = renderers->GetNextItem())
    {
      renderer->RemoveObserver(afterViewport);
    }
    return changes;
  }

  TestScene Scene = TestScene(120, 20);
  vtkNew<vtkLinkedListTransparencyPass> Pass;
  vtkNew<vtkSeeThroughPass> SeeThrough;
};

TEST_F(SharedPool, OfADeepAndAFlatViewHoldsStill)
{
  this->AddViewports({ 64, 1 });
  this->Changes(2);
  const vtkTypeInt64 bytes = this->Pass->GetPoolBytes();
  EXPECT_GE(bytes, 64 * 60 * 20 * 12);
  EXPECT_EQ(this->Changes(70), 0);
  EXPECT_EQ(this->Pass->GetGeometryPasses(), 1);
}

TEST_F(SharedPool, OfADeepAndSeveralFlatViewsHoldsStill)
{
  this->AddViewports({ 64, 1, 1, 1, 1, 1 });
  this->Changes(3);
  EXPECT_EQ(this->Changes(40), 0);
}

TEST_F(SharedPool, TakesUpAnotherPageSizeAfterAWhile)
{
  const vtkSmartPointer<vtkActor> deep = this->Scene.AddPlates(RandomPlates(64, 0.05, 3), 4);
  this->Scene.AddPlates(RandomPlates(1, 0.05, 3), 4);
  this->Scene.Use(this->Pass);
  this->Scene.Render();
  const vtkTypeInt64 large = this->Pass->GetPoolBytes();
  deep->VisibilityOff();
  const int changes = this->Changes(80);
  EXPECT_GE(changes, 1);
  EXPECT_LE(changes, 3);
  const double plain = static_cast<double>(this->Pass->GetFragmentCount()) * 16;
  EXPECT_LE(this->Pass->GetPoolBytes(), std::max(1.3 * plain, large / 20.0));
}

TEST_F(SharedPool, ShrinksWhileNothingIsVisible)
{
  const vtkSmartPointer<vtkActor> plates = this->Scene.AddPlates(RandomPlates(64, 0.05, 3), 4);
  this->Scene.Use(this->Pass);
  this->Scene.Render();
  const vtkTypeInt64 large = this->Pass->GetPoolBytes();
  const vtkTypeInt64 bytes = this->Pass->GetBytes();
  plates->VisibilityOff();
  this->Changes(40);
  EXPECT_LT(this->Pass->GetPoolBytes(), large / 100);
  EXPECT_EQ(bytes - this->Pass->GetBytes(), large - this->Pass->GetPoolBytes());
  plates->VisibilityOn();
  ExpectTruth(this->Scene, this->Pass, 2.0);
}

}
