// Framebuffers of all kinds: too large, faces of cubes, levels, layers, unsized depth, several draw buffers.
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/VitrineOpenGL.h"
#include "vtkCamera.h"
#include "vtkCullerCollection.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPanoramicProjectionPass.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkShaderProperty.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace
{

class Targets : public testing::TestWithParam<Method>
{
};

// Lists of multisampled pixels take an image of two texels a pixel.
TEST_P(Targets, OfTheDriversLargestWidth)
{
  TestScene scene(9000, 4, 4);
  const std::vector<Rgba> plates = RandomPlates(3, 0.4, 5);
  scene.AddPlates(plates, 6);
  scene.Renderer->GetActiveCamera()->SetParallelScale(0.001); // the plates are wide enough
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  scene.Use(pass);
  const Rgba color = UniformColor(scene.Render());
  if (!GetParam().RefusesSamples.empty())
  {
    ExpectRefusal(pass, GetParam().RefusesSamples);
    return;
  }
  EXPECT_STREQ(pass->GetFallbackReason(), "");
  ExpectColor(color, CompositePlates(plates, TestBackground), GetParam().Tolerance);
}

// A height that is no problem for the target is one for what a method needs several times as high: heads of lists and
// groups of masks. Truth and routing need nothing larger than the target.
TEST_P(Targets, TooLargeForTheDriverAreSaidToBe)
{
  TestScene scene(4, 9000, GetParam().Samples().back());
  const std::vector<Rgba> plates = RandomPlates(3, 0.4, 5);
  scene.AddPlates(plates, 6);
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  scene.Use(pass);
  const Rgba color = UniformColor(scene.Render());
  if (pass->GetFallbackReason()[0] == '\0')
  {
    EXPECT_TRUE(GetParam().Name == "Truth" || GetParam().Name == RoutedMethods().front().Name);
    ExpectColor(color, CompositePlates(plates, TestBackground), GetParam().Tolerance);
    return;
  }
  EXPECT_NE(color, (Rgba{ 0.0, 0.0, 0.0, 0.0 }));
  const int rows = GetParam().HasGroups() ? static_cast<int>(std::sqrt(GetParam().MaxLayers)) : 2;
  ExpectRefusal(pass, "x" + std::to_string(9000 * rows) + " pixels");
}

// How many pixels have a colour.
int CountPixels(const Picture& picture, const Rgba& color)
{
  int count = 0;
  for (std::size_t i = 0; i < picture.Bytes.size(); i += 4)
  {
    bool isColor = true;
    for (int c = 0; c < 4; ++c)
    {
      isColor = isColor && std::abs(picture.Bytes[i + c] - 255.0 * color[c]) <= 1.4;
    }
    count += isColor ? 1 : 0;
  }
  return count;
}

// A panorama of spheres around the camera, one layer each.
TEST_P(Targets, FacesOfACube)
{
  TestScene scene(96, 48);
  const std::array<double, 3> centers[] = { { 2.0, 0.0, -1.0 }, { -2.0, 0.0, 1.0 },
    { 0.0, 2.0, 2.0 } };
  const Rgba colors[] = { { 1.0, 0.4, 0.0, 0.4 }, { 0.0, 1.0, 0.6, 0.4 }, { 0.2, 0.4, 1.0, 0.4 } };
  for (int i = 0; i < 3; ++i)
  {
    const auto actor =
      scene.AddSphere(centers[i][0], centers[i][1], centers[i][2], 1.0, colors[i], 30);
    actor->GetProperty()->BackfaceCullingOn();
    actor->GetProperty()->LightingOff();
  }
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetPosition(0.0, 0.0, 0.1);
  scene.Renderer->GetCullers()->RemoveAllItems(); // which see the front alone
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetTranslucentPass(pass);
  vtkNew<vtkPanoramicProjectionPass> panorama;
  panorama->SetProjectionTypeToEquirectangular();
  panorama->SetDelegatePass(steps);
  panorama->SetCubeResolution(64);
  panorama->SetAngle(360.0);
  scene.Renderer->SetPass(panorama);

  const Picture picture = scene.Render();
  EXPECT_STREQ(pass->GetFallbackReason(), "");
  const int background = CountPixels(picture, TestBackground);
  int covered = 0;
  for (const Rgba& color : colors)
  {
    const int pixels = CountPixels(picture, CompositePlates({ color }, TestBackground));
    EXPECT_GT(pixels, 100);
    covered += pixels;
  }
  EXPECT_GT(background, 96 * 48 / 2);
  EXPECT_LT(96 * 48 - background - covered, covered / 2); // edges, which VTK interpolates
}

//------------------------------------------------------------------------------
// Renders another pass into a framebuffer of its own, and keeps the pictures of its colour images.
class FramebufferPass : public vtkRenderPass
{
public:
  static FramebufferPass* New();
  vtkTypeMacro(FramebufferPass, vtkRenderPass);

  void Render(const vtkRenderState* s) override
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(s->GetRenderer()->GetRenderWindow());
    vtkOpenGLState* state = window->GetState();
    state->PushFramebufferBindings();
    this->MakeFramebuffer(state);
    this->Clear(state);
    this->Delegate->Render(s);
    this->Pictures.clear();
    for (int i = 0; i < this->Colors; ++i)
    {
      this->Pictures.push_back(this->Read(state, i));
    }
    state->PopFramebufferBindings();
    glDeleteFramebuffers(1, &this->Framebuffer);
    glDeleteTextures(3, this->Textures);
  }

  vtkSmartPointer<vtkRenderPass> Delegate;
  int Size = 16;
  int Level = 0;
  int Colors = 1;
  bool Layers = false;
  GLenum DepthFormat = GL_DEPTH_COMPONENT24;
  std::vector<std::vector<unsigned char>> Pictures;

private:
  void MakeFramebuffer(vtkOpenGLState* state)
  {
    glGenTextures(3, this->Textures);
    glGenFramebuffers(1, &this->Framebuffer);
    state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
    for (int i = 0; i < this->Colors; ++i)
    {
      const GLenum attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
      if (this->Layers)
      {
        glBindTexture(GL_TEXTURE_2D_ARRAY, this->Textures[i]);
        glTexStorage3D(GL_TEXTURE_2D_ARRAY, 1, GL_RGBA8, this->Size, this->Size, 2);
        glFramebufferTextureLayer(GL_FRAMEBUFFER, attachment, this->Textures[i], 0, 1);
      }
      else
      {
        glBindTexture(GL_TEXTURE_2D, this->Textures[i]);
        glTexStorage2D(GL_TEXTURE_2D, this->Level + 1, GL_RGBA8, this->Size << this->Level,
          this->Size << this->Level);
        glFramebufferTexture2D(
          GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, this->Textures[i], this->Level);
      }
    }
    glBindTexture(GL_TEXTURE_2D, this->Textures[2]);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(this->DepthFormat), this->Size, this->Size, 0,
      GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    glFramebufferTexture2D(
      GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, this->Textures[2], 0);
    glBindTexture(GL_TEXTURE_2D, 0);
    const GLenum buffers[2] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1 };
    glDrawBuffers(this->Colors, buffers);
    EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), GLenum(GL_FRAMEBUFFER_COMPLETE));
  }

  void Clear(vtkOpenGLState* state)
  {
    state->vtkglViewport(0, 0, this->Size, this->Size);
    state->vtkglScissor(0, 0, this->Size, this->Size);
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglDepthMask(GL_TRUE);
    for (int i = 0; i < this->Colors; ++i)
    {
      const GLfloat color[4] = { 0.2f, 0.6f, 0.4f * static_cast<float>(1 + i), 0.0f };
      glClearBufferfv(GL_COLOR, i, color);
    }
    const GLfloat depth = 1.0f;
    glClearBufferfv(GL_DEPTH, 0, &depth);
  }

  std::vector<unsigned char> Read(vtkOpenGLState* state, int color) const
  {
    GLint drawBuffer = 0;
    glGetIntegerv(GL_DRAW_BUFFER0 + static_cast<GLenum>(color), &drawBuffer);
    EXPECT_EQ(drawBuffer, GL_COLOR_ATTACHMENT0 + color);
    std::vector<unsigned char> bytes(4 * this->Size * this->Size);
    state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->Framebuffer);
    state->vtkglReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<unsigned int>(color));
    glReadPixels(0, 0, this->Size, this->Size, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    return bytes;
  }

  GLuint Framebuffer = 0;
  GLuint Textures[3] = {};
};
vtkStandardNewMacro(FramebufferPass);

class OwnFramebuffer : public Targets
{
protected:
  OwnFramebuffer()
    : Pass(GetParam().Make())
    , Plates(RandomPlates(5, 0.4, 5))
  {
    this->Scene.AddPlates(this->Plates, 6);
    this->Target->Delegate = this->Pass;
  }

  void Render()
  {
    this->Scene.Use(this->Target);
    this->Scene.Render();
    this->Scene.Render();
  }

  void ExpectPlates()
  {
    EXPECT_STREQ(this->Pass->GetFallbackReason(), "");
    const Rgba expected = CompositePlates(this->Plates, { 0.2, 0.6, 0.4, 0.0 });
    for (std::size_t i = 0; i < this->Target->Pictures[0].size(); ++i)
    {
      ASSERT_NEAR(this->Target->Pictures[0][i], 255.0 * expected[i % 4], 1.5) << i;
    }
  }

  TestScene Scene = TestScene(16, 16);
  vtkNew<FramebufferPass> Target;
  vtkSmartPointer<vtkTransparencyPass> Pass;
  std::vector<Rgba> Plates;
};

TEST_P(OwnFramebuffer, OfALevel)
{
  this->Target->Level = 2;
  this->Render();
  this->ExpectPlates();
}

TEST_P(OwnFramebuffer, OfLayersIsRefused)
{
  this->Target->Layers = true;
  this->Render();
  EXPECT_STREQ(
    this->Pass->GetFallbackReason(), "the framebuffer has layers of a texture, and no plain image");
  EXPECT_EQ(TakeMessages().size(), 1u);
}

// The copy of the depth, which a writer of depth asks for, has a format of the same bits.
TEST_P(OwnFramebuffer, OfUnsizedDepth)
{
  this->Target->DepthFormat = GL_DEPTH_COMPONENT;
  this->Plates.push_back(RoundedTo8Bits({ 0.5, 0.7, 0.1, 0.6 }));
  const auto writer = this->Scene.AddPlate(-0.95, this->Plates.back());
  writer->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::Depth::Impl", true, "gl_FragDepth = gl_FragCoord.z;\n", false);
  this->Render();
  this->ExpectPlates();
  EXPECT_EQ(this->Pass->GetNumberOfFragments(), 6 * 16 * 16);
}

TEST_P(OwnFramebuffer, OfSeveralDrawBuffersKeepsTheOthers)
{
  this->Target->Colors = 2;
  this->Render();
  this->ExpectPlates();
  const std::vector<unsigned char>& other = this->Target->Pictures[1];
  for (std::size_t i = 0; i < other.size(); ++i)
  {
    const int cleared[] = { 51, 153, 204, 0 };
    ASSERT_EQ(other[i], cleared[i % 4]) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Targets, testing::ValuesIn(AllMethods()), MethodName());
INSTANTIATE_TEST_SUITE_P(Methods, OwnFramebuffer, testing::ValuesIn(AllMethods()), MethodName());

}
