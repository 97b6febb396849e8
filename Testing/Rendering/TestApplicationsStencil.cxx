// What an application keeps in the stencil of its framebuffer stays there, whatever a method does with stencils.
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/VitrineOpenGL.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderPass.h"
#include "vtkRenderState.h"

#include <gtest/gtest.h>

namespace
{

constexpr int Width = 20;
constexpr int Height = 18;

// Draws into a framebuffer that has a stencil.
class StencilOwningPass : public vtkRenderPass
{
public:
  static StencilOwningPass* New() { VTK_STANDARD_NEW_BODY(StencilOwningPass); }
  vtkTypeMacro(StencilOwningPass, vtkRenderPass);

  void Render(const vtkRenderState* s) override
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(s->GetRenderer()->GetRenderWindow());
    vtkOpenGLState* state = window->GetState();
    state->PushFramebufferBindings();
    GLuint framebuffer = 0;
    GLuint images[2] = { 0, 0 };
    glGenFramebuffers(1, &framebuffer);
    glGenRenderbuffers(2, images);
    state->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    Attach(GL_COLOR_ATTACHMENT0, images[0], GL_RGBA8);
    Attach(GL_DEPTH_STENCIL_ATTACHMENT, images[1], GL_DEPTH24_STENCIL8);
    const GLfloat black[4] = {};
    glClearBufferfv(GL_COLOR, 0, black);
    glClearBufferfi(GL_DEPTH_STENCIL, 0, 1.0f, 77);

    this->Pass->Render(s);

    this->Stencil.resize(std::size_t(Width) * Height);
    state->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glReadPixels(0, 0, Width, Height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, this->Stencil.data());
    glReadPixels(Width / 2, Height / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, this->Color.data());
    state->PopFramebufferBindings();
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(2, images);
  }

  vtkRenderPass* Pass = nullptr;
  std::vector<unsigned char> Stencil;
  std::array<unsigned char, 4> Color = {};

private:
  static void Attach(GLenum attachment, GLuint image, GLenum format)
  {
    glBindRenderbuffer(GL_RENDERBUFFER, image);
    glRenderbufferStorage(GL_RENDERBUFFER, format, Width, Height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, image);
  }
};

class ApplicationsStencil : public testing::TestWithParam<Method>
{
};

TEST_P(ApplicationsStencil, StaysAsItIs)
{
  TestScene scene(Width, Height);
  const std::vector<Rgba> plates = RandomPlates(6, 0.4, 3);
  scene.AddPlates(plates, 4);
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  vtkNew<StencilOwningPass> application;
  application->Pass = pass;
  scene.Use(application);
  scene.Render();
  EXPECT_STREQ(pass->GetFallbackReason(), "");
  EXPECT_EQ(application->Stencil, std::vector<unsigned char>(std::size_t(Width) * Height, 77));
  const Rgba expected = CompositePlates(plates, { 0.0, 0.0, 0.0, 0.0 });
  for (int c = 0; c < 4; ++c)
  {
    EXPECT_NEAR(application->Color[c], 255.0 * expected[c], 1.4);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Methods, ApplicationsStencil, testing::ValuesIn(AllMethods()), MethodName());

}
