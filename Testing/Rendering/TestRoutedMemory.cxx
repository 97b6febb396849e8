// The memory of stencil routing: layers for as many passes as frames take, and drivers that have less.
#include "TestMessages.h"
#include "TestScene.h"
#include "gl/VitrineOpenGL.h"
#include "vtkActor.h"
#include "vtkStencilRoutedTransparencyPass.h"

#include <gtest/gtest.h>

namespace
{

constexpr int Width = 64;
constexpr int Height = 48;
constexpr int Layers = 40;

// A driver that has memory for images of so many layers at most: more is asked for with a size that no driver has.
class ScarceLayers
{
public:
  explicit ScarceLayers(GLsizei layers)
  {
    Most = layers;
    Refusals = 0;
    Driver = glTexImage3D;
    glTexImage3D = Allocate;
  }
  ~ScarceLayers()
  {
    glTexImage3D = Driver;
    EXPECT_EQ(TakeMessages().size() > 0, Refusals > 0); // what OpenGL says of the sizes
  }
  static int Refusals;

private:
  static void GLAPIENTRY Allocate(GLenum target, GLint level, GLint internalFormat, GLsizei width,
    GLsizei height, GLsizei layers, GLint border, GLenum format, GLenum type, const void* pixels)
  {
    const bool refuses = layers > Most;
    Refusals += refuses ? 1 : 0;
    Driver(target, level, internalFormat, refuses ? -1 : width, height, layers, border, format,
      type, pixels);
  }
  static GLsizei Most;
  static decltype(glTexImage3D) Driver;
};
int ScarceLayers::Refusals = 0;
GLsizei ScarceLayers::Most = 0;
decltype(glTexImage3D) ScarceLayers::Driver = nullptr;

class RoutedMemory : public testing::Test
{
protected:
  RoutedMemory()
  {
    this->Pass->SetSamplesPerPass(1);
    this->Scene.RenderAsVTK(); // the context, with which the loader sets its pointers
    this->Scene.Use(this->Pass);
  }

  // Two frames with nothing but so many plates, exact both times.
  void ExpectExact(int layers)
  {
    SCOPED_TRACE(layers);
    const std::vector<Rgba> plates = RandomPlates(layers, 0.1, 3);
    const vtkSmartPointer<vtkActor> stack = this->Scene.AddPlates(plates, 4);
    for (int frame = 0; frame < 2; ++frame)
    {
      const Rgba color = UniformColor(this->Scene.Render());
      EXPECT_STREQ(this->Pass->GetFallbackReason(), "");
      ExpectColor(color, CompositePlates(plates, TestBackground), 0.6);
    }
    this->Scene.Renderer->RemoveActor(stack);
  }

  TestScene Scene = TestScene(Width, Height);
  vtkNew<vtkStencilRoutedTransparencyPass> Pass;
};

// The first frame with more layers makes room for them, and the first pass is drawn again.
TEST(StencilRoutedMemory, GrowsWithinTheFrameAndShrinksAfterMany)
{
  TestScene scene(64, 48);
  vtkNew<vtkStencilRoutedTransparencyPass> pass;
  pass->SetSamplesPerPass(1);
  scene.Use(pass);
  scene.AddPlate(0.9, { 0.2, 0.4, 0.6, 0.5 });
  scene.Render();
  const vtkTypeInt64 small = pass->GetBytes();
  EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 1);

  const vtkSmartPointer<vtkActor> stack = scene.AddPlates(RandomPlates(40, 0.1, 3), 4);
  const Picture first = scene.Render();
  EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 41 + 1);
  EXPECT_GE(pass->GetBytes(), small + 39 * 64 * 48 * 12);
  EXPECT_LE(pass->GetBytes(), small + 1.3 * 40 * 64 * 48 * 12);
  EXPECT_TRUE(Matches(scene.Render(), first));
  EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 41);

  scene.Renderer->RemoveActor(stack);
  for (int frame = 0; frame < 40; ++frame)
  {
    scene.Render();
    EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 1);
  }
  EXPECT_EQ(pass->GetBytes(), small);
}

TEST(StencilRoutedMemory, HalvesColoursOfEightBits)
{
  TestScene scene(128, 96);
  scene.AddPlate(0.0, { 0.2, 0.4, 0.6, 0.5 });
  vtkNew<vtkStencilRoutedTransparencyPass> pass;
  pass->SetSamplesPerPass(1);
  scene.Use(pass);
  scene.Render();
  const vtkTypeInt64 halfFloat = pass->GetBytes();
  pass->SetColorStorageToEightBit();
  scene.Render();
  EXPECT_EQ(pass->GetBytes(), halfFloat - 4 * 128 * 96);
}

// The driver refuses the reserve once, and is not asked for one again.
TEST_F(RoutedMemory, ForNoReserveIsEnough)
{
  const ScarceLayers scarce(Layers);
  this->ExpectExact(1);
  EXPECT_EQ(ScarceLayers::Refusals, 0);
  this->ExpectExact(Layers);
  EXPECT_EQ(ScarceLayers::Refusals, 1);
  EXPECT_LE(this->Pass->GetBytes(), (Layers + 2) * Width * Height * 12);
  this->ExpectExact(Layers - 1);
  EXPECT_EQ(ScarceLayers::Refusals, 1);
}

TEST_F(RoutedMemory, MayBeMoreLater)
{
  {
    const ScarceLayers scarce(Layers);
    this->ExpectExact(Layers);
  }
  const ScarceLayers scarce(Layers + 2);
  this->ExpectExact(Layers + 1);
  this->ExpectExact(Layers + 2);
  EXPECT_EQ(ScarceLayers::Refusals, 0);
}

// One frame that is too deep is VTK's, and says so; those before and after it are exact.
TEST_F(RoutedMemory, ForTooFewPassesIsSaidAndForgotten)
{
  const ScarceLayers scarce(Layers / 2);
  this->ExpectExact(2);
  const vtkTypeInt64 before = this->Pass->GetBytes();
  const vtkSmartPointer<vtkActor> stack = this->Scene.AddPlates(RandomPlates(Layers, 0.1, 3), 4);
  const Picture byVTK = this->Scene.RenderAsVTK();
  this->Scene.Use(this->Pass);
  for (int frame = 0; frame < 2; ++frame)
  {
    EXPECT_TRUE(Matches(this->Scene.Render(), byVTK));
    const std::string reason = this->Pass->GetFallbackReason();
    EXPECT_EQ(reason.find("the driver has no memory for an image"), 0u) << reason;
    EXPECT_LT(this->Pass->GetBytes(), before);
  }
  this->Scene.Renderer->RemoveActor(stack);
  this->ExpectExact(2);
  this->ExpectExact(Layers / 2);
}

// What a release leaves is not more than a new pass begins with.
TEST_F(RoutedMemory, IsSmallAgainAfterARelease)
{
  this->ExpectExact(1);
  const vtkTypeInt64 small = this->Pass->GetBytes();
  this->ExpectExact(Layers);
  EXPECT_GT(this->Pass->GetBytes(), small);
  this->Pass->ReleaseGraphicsResources(this->Scene.Window);
  this->ExpectExact(1);
  EXPECT_EQ(this->Pass->GetBytes(), small);
}

}
