// Tests passes around the translucent one that add outputs to the mappers' shaders and draw into several images, such
// as ambient occlusion.
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestPasses.h"
#include "TestScene.h"
#include "gl/VitrineOpenGL.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkInformation.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLState.h"
#include "vtkOverlayPass.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAOPass.h"
#include "vtkSeeThroughPass.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTruthTransparencyPass.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

constexpr Rgba White = { 1.0, 1.0, 1.0, 1.0 };

//------------------------------------------------------------------------------
// What stands between ambient occlusion and the translucent pass.

vtkSmartPointer<vtkRenderPass> SeeThrough(vtkRenderPass* translucent)
{
  auto pass = vtkSmartPointer<vtkSeeThroughPass>::New();
  pass->SetTranslucentPass(translucent);
  return pass;
}

vtkSmartPointer<vtkRenderPass> Steps(vtkRenderPass* translucent)
{
  auto pass = vtkSmartPointer<vtkRenderStepsPass>::New();
  pass->SetTranslucentPass(translucent);
  return pass;
}

vtkSmartPointer<vtkRenderPass> Sequence(vtkRenderPass* translucent)
{
  return InSequence({ ByCamera(InSequence({ vtkNew<vtkLightsPass>(), vtkNew<vtkOpaquePass>(),
    translucent, vtkNew<vtkOverlayPass>() })) });
}

struct Delegate
{
  std::string Name;
  vtkSmartPointer<vtkRenderPass> (*Make)(vtkRenderPass* translucent);
};

const Delegate Delegates[] = { { "see-through", SeeThrough }, { "steps", Steps },
  { "sequence", Sequence } };

vtkSmartPointer<vtkRenderPass> OccludedAround(const Delegate& delegate, vtkRenderPass* translucent)
{
  auto occlusion = vtkSmartPointer<vtkSSAOPass>::New();
  occlusion->SetRadius(0.5);
  occlusion->SetKernelSize(64);
  occlusion->SetDelegatePass(delegate.Make(translucent));
  return occlusion;
}

// A white cube before a white wall, lit by ambient light alone: whatever is darker than white is so by occlusion.
struct OccludedScene : TestScene
{
  explicit OccludedScene(int samples)
    : TestScene(64, 48, samples)
  {
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
    this->AddWhiteBox(3.0, 3.0, 0.1, -0.9);
    this->AddWhiteBox(0.7, 0.7, 0.6, -0.6);
  }

  void AddWhiteBox(double width, double height, double depth, double z)
  {
    vtkNew<vtkCubeSource> box;
    box->SetXLength(width);
    box->SetYLength(height);
    box->SetZLength(depth);
    box->SetCenter(0.1, -0.1, z);
    const vtkSmartPointer<vtkActor> actor = this->AddSource(box, White);
    actor->GetProperty()->SetAmbient(1.0);
    actor->GetProperty()->SetDiffuse(0.0);
    actor->GetProperty()->SetSpecular(0.0);
  }
};

// The darkest byte of red.
int Darkest(const Picture& picture)
{
  int darkest = 255;
  for (std::size_t i = 0; i < picture.Bytes.size(); i += 4)
  {
    darkest = std::min<int>(darkest, picture.Bytes[i]);
  }
  return darkest;
}

// The farthest that a pixel is from `color` times its occlusion, of which `occlusion` is a picture; in steps of 1/255.
double DistanceFromOccluded(const Picture& picture, const Rgba& color, const Picture& occlusion)
{
  double farthest = 0.0;
  for (std::size_t i = 0; i < picture.Bytes.size(); ++i)
  {
    if (i % 4 < 3)
    {
      const double expected = color[i % 4] * occlusion.Bytes[i];
      farthest = std::max(farthest, std::abs(picture.Bytes[i] - expected));
    }
  }
  return farthest;
}

class AmbientOcclusion : public testing::TestWithParam<Method>
{
};

// Opaque things alone occlude, and alone are occluded: plates before them change colours, and no occlusion.
TEST_P(AmbientOcclusion, IsOfWhatIsOpaque)
{
  for (const int samples : { 0, 4 })
  {
    for (const Delegate& delegate : Delegates)
    {
      SCOPED_TRACE(delegate.Name + ", " + std::to_string(samples) + " samples");
      OccludedScene scene(samples);
      const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
      scene.Renderer->SetPass(OccludedAround(delegate, pass));
      const Picture opaque = scene.Render();
      EXPECT_LT(Darkest(opaque), 200);

      const std::vector<Rgba> plates = RandomPlates(5, 0.3, 3);
      scene.AddPlates(plates, { 0.9, 0.7, 0.5, 0.3, 0.1 }, 4);
      for (int frame = 0; frame < 2; ++frame)
      {
        const Picture picture = scene.Render();
        EXPECT_STREQ(pass->GetFallbackReason(), "");
        EXPECT_EQ(pass->GetNumberOfFragments(), 5 * 64 * 48);
        // The occlusion is known to half a step.
        EXPECT_LE(DistanceFromOccluded(picture, CompositePlates(plates, White), opaque),
          GetParam().Tolerance + 0.5);
      }
    }
  }
}

// Lit and curved, partly hidden, among several.
TEST_P(AmbientOcclusion, AroundPartsIsThatAroundTruth)
{
  for (const int samples : { 0, 4 })
  {
    for (const Delegate& delegate : Delegates)
    {
      SCOPED_TRACE(delegate.Name + ", " + std::to_string(samples) + " samples");
      OccludedScene scene(samples);
      scene.AddParts();
      scene.AddSphere(0.1, 0.1, -0.3, 0.45, { 0.9, 0.3, 0.1, 0.6 });
      vtkNew<vtkTruthTransparencyPass> truth;
      scene.Renderer->SetPass(OccludedAround(delegate, truth));
      const Picture expected = scene.Render();
      EXPECT_GT(truth->GetNumberOfFragments(), 0);
      const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
      scene.Renderer->SetPass(OccludedAround(delegate, pass));
      const Picture picture = scene.Render();
      EXPECT_STREQ(pass->GetFallbackReason(), "");
      EXPECT_TRUE(
        Matches(picture, expected, GetParam().KeepsEightBits() ? 2 : 1, GetParam().EdgeShare));
    }
  }
}

TEST_P(AmbientOcclusion, IsGoneWhenItIsTakenAway)
{
  OccludedScene scene(0);
  const std::vector<Rgba> plates = RandomPlates(3, 0.4, 5);
  scene.AddPlates(plates, { 0.9, 0.5, 0.1 }, 6);
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  const auto steps = Steps(pass);
  scene.Renderer->SetPass(steps);
  const Picture before = scene.Render();
  scene.Renderer->SetPass(OccludedAround(Delegates[1], pass));
  EXPECT_GT(LargestDifference(scene.Render(), before), 50);
  scene.Renderer->SetPass(steps);
  EXPECT_TRUE(Matches(scene.Render(), before));
}

//------------------------------------------------------------------------------
// Draws another pass into two images of its own, and has mappers write a mark into the second.
class MarkingPass : public vtkOpenGLRenderPass
{
public:
  static MarkingPass* New();
  vtkTypeMacro(MarkingPass, vtkOpenGLRenderPass);

  void Render(const vtkRenderState* s) override
  {
    this->State =
      vtkOpenGLRenderWindow::SafeDownCast(s->GetRenderer()->GetRenderWindow())->GetState();
    this->State->PushFramebufferBindings();
    this->MakeFramebuffer();
    this->Clear();
    this->State->vtkglDrawBuffers(this->DrawBuffersAtFirst, this->Buffers);
    this->PreRender(s);
    this->Delegate->Render(s);
    this->PostRender(s);
    GLint second = 0;
    glGetIntegerv(GL_DRAW_BUFFER1, &second);
    this->DrawBuffersAfterwards = second == GL_COLOR_ATTACHMENT1 ? 2 : 1;
    this->Color = this->Read(0);
    this->Marks = this->Read(1);
    this->State->PopFramebufferBindings();
    glDeleteFramebuffers(1, &this->Framebuffer);
    glDeleteTextures(3, this->Textures);
  }

  // As vtkSSAOPass does: a tag before VTK's own are replaced.
  bool PreReplaceShaderValues(
    std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*) override
  {
    return vtkShaderProgram::Substitute(
      fragmentShader, "//VTK::Light::Impl", "//VTK::Light::Impl\n  //Test::Mark\n", false);
  }

  bool PostReplaceShaderValues(
    std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*) override
  {
    vtkShaderProgram::Substitute(
      fragmentShader, "//Test::Mark", this->Output + " = vec4(1.0, 0.0, 1.0, 1.0);\n");
    return vtkShaderProgram::Substitute(
      fragmentShader, "//VTK::Output::Dec", this->Declaration + "//VTK::Output::Dec");
  }

  bool SetShaderParameters(
    vtkShaderProgram*, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*) override
  {
    GLint bound = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    this->OtherFramebuffers += static_cast<GLuint>(bound) != this->Framebuffer;
    this->State->vtkglDrawBuffers(2, this->Buffers);
    return true;
  }

  vtkSmartPointer<vtkRenderPass> Delegate;
  std::string Output = "gl_FragData[1]";
  std::string Declaration;
  unsigned int DrawBuffersAtFirst = 2;
  unsigned int DrawBuffersAfterwards = 0;
  int OtherFramebuffers = 0; // that were bound where this pass set the draw buffers
  Picture Color;
  Picture Marks;

private:
  static constexpr int Size = 16;

  void MakeFramebuffer()
  {
    glGenTextures(3, this->Textures);
    glGenFramebuffers(1, &this->Framebuffer);
    this->State->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
    const GLenum attachments[] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1,
      GL_DEPTH_ATTACHMENT };
    for (int i = 0; i < 3; ++i)
    {
      glBindTexture(GL_TEXTURE_2D, this->Textures[i]);
      glTexStorage2D(GL_TEXTURE_2D, 1, i < 2 ? GL_RGBA8 : GL_DEPTH_COMPONENT24, Size, Size);
      glFramebufferTexture2D(GL_FRAMEBUFFER, attachments[i], GL_TEXTURE_2D, this->Textures[i], 0);
    }
    glBindTexture(GL_TEXTURE_2D, 0);
  }

  void Clear()
  {
    this->State->vtkglViewport(0, 0, Size, Size);
    this->State->vtkglScissor(0, 0, Size, Size);
    this->State->vtkglEnable(GL_SCISSOR_TEST);
    this->State->vtkglEnable(GL_DEPTH_TEST);
    this->State->vtkglDepthMask(GL_TRUE);
    glDrawBuffers(2, this->Buffers);
    const GLfloat colors[2][4] = { { 0.2f, 0.6f, 0.4f, 0.0f }, { 0.0f, 1.0f, 0.0f, 0.0f } };
    glClearBufferfv(GL_COLOR, 0, colors[0]);
    glClearBufferfv(GL_COLOR, 1, colors[1]);
    const GLfloat depth = 1.0f;
    glClearBufferfv(GL_DEPTH, 0, &depth);
    glDrawBuffers(static_cast<GLsizei>(this->DrawBuffersAtFirst), this->Buffers);
  }

  Picture Read(unsigned int image) const
  {
    Picture picture = { Size, Size, std::vector<unsigned char>(4 * Size * Size) };
    this->State->vtkglReadBuffer(this->Buffers[image]);
    glReadPixels(0, 0, Size, Size, GL_RGBA, GL_UNSIGNED_BYTE, picture.Bytes.data());
    return picture;
  }

  vtkOpenGLState* State = nullptr;
  GLuint Framebuffer = 0;
  GLuint Textures[3] = {};
  GLenum Buffers[2] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1 };
};
vtkStandardNewMacro(MarkingPass);

constexpr Rgba Mark = { 1.0, 0.0, 1.0, 1.0 };
constexpr Rgba NoMark = { 0.0, 1.0, 0.0, 0.0 };

// A white rectangle in the left half of the view, drawn with marks, and translucent things before it.
struct MarkedScene : TestScene
{
  explicit MarkedScene(vtkRenderPass* translucent)
    : TestScene(16, 16)
  {
    this->Marking->Delegate =
      InSequence({ vtkNew<vtkLightsPass>(), vtkNew<vtkOpaquePass>(), translucent });
    this->Renderer->SetPass(this->Marking);
    this->Rectangle = this->AddRectangle(-2.0, -2.0, 0.0, 2.0, -0.5, White);
  }

  void ExpectNoMarksOfTranslucentThings() const
  {
    EXPECT_EQ(this->Marking->Marks.At(3, 8), this->Rectangle->GetVisibility() ? Mark : NoMark);
    EXPECT_EQ(this->Marking->Marks.At(12, 8), NoMark);
    EXPECT_EQ(this->Marking->OtherFramebuffers, 0);
  }

  vtkNew<MarkingPass> Marking;
  vtkSmartPointer<vtkActor> Rectangle;
};

class MarkedOutputs : public testing::TestWithParam<Method>
{
protected:
  // Plates before the rectangle, in several frames.
  void ExpectExactPlates()
  {
    const std::vector<Rgba> plates = RandomPlates(5, 0.3, 7);
    this->Scene.AddPlates(plates, { 0.9, 0.7, 0.5, 0.3, 0.1 }, 8);
    for (int frame = 0; frame < 3; ++frame)
    {
      this->Scene.Render();
      EXPECT_STREQ(this->Pass->GetFallbackReason(), "");
      EXPECT_EQ(this->Pass->GetNumberOfFragments(), 5 * 16 * 16);
      const Picture& color = this->Scene.Marking->Color;
      const Rgba& behind = this->Scene.Rectangle->GetVisibility() ? White : TestBackground;
      ExpectColor(color.At(3, 8), CompositePlates(plates, behind), GetParam().Tolerance);
      ExpectColor(color.At(12, 8), CompositePlates(plates, TestBackground), GetParam().Tolerance);
      this->Scene.ExpectNoMarksOfTranslucentThings();
    }
  }

  vtkSmartPointer<vtkTransparencyPass> Pass = GetParam().Make();
  MarkedScene Scene = MarkedScene(Pass);
};

TEST_P(MarkedOutputs, OfData)
{
  this->ExpectExactPlates();
  EXPECT_EQ(this->Scene.Marking->DrawBuffersAfterwards, 2u);
}

TEST_P(MarkedOutputs, OfADeclaredVariable)
{
  this->Scene.Marking->Output = "mark";
  this->Scene.Marking->Declaration = "out vec4 mark;\n";
  this->ExpectExactPlates();
  EXPECT_EQ(this->Scene.Marking->DrawBuffersAfterwards, 2u);
}

// Nothing tells of the second draw buffer before the first translucent mapper draws.
TEST_P(MarkedOutputs, OfAPassThatSetsItsDrawBuffersForEachMapper)
{
  this->Scene.Rectangle->VisibilityOff();
  this->Scene.Marking->DrawBuffersAtFirst = 1;
  this->ExpectExactPlates();
}

TEST_P(MarkedOutputs, LeaveThePropsAsTheyWere)
{
  const vtkSmartPointer<vtkActor> plate = this->Scene.AddPlate(0.5, { 1.0, 0.0, 0.0, 0.5 });
  this->Scene.Render();
  ASSERT_NE(plate->GetPropertyKeys(), nullptr);
  EXPECT_FALSE(plate->GetPropertyKeys()->Has(vtkOpenGLRenderPass::RenderPasses()));
}

// Without a pass around: users' shaders may write to more outputs than there are.
TEST_P(MarkedOutputs, OfAUsersShader)
{
  this->Scene.Use(this->Pass);
  const std::vector<Rgba> plates = RandomPlates(4, 0.3, 11);
  this->Scene.AddPlates(plates, { 0.9, 0.7, 0.5, 0.3 }, 12)
    ->GetShaderProperty()
    ->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
      "//VTK::Light::Impl\n  gl_FragData[1] = vec4(1.0);\n  gl_FragData[3] = gl_FragData[1];\n",
      false);
  const Picture picture = this->Scene.Render();
  EXPECT_STREQ(this->Pass->GetFallbackReason(), "");
  ExpectColor(picture.At(12, 8), CompositePlates(plates, TestBackground), GetParam().Tolerance);
}

// Where a method refuses, VTK's own way draws. It leaves no marks either.
TEST(OuterPasses, LeaveNoMarksWhereAMethodRefuses)
{
  const vtkSmartPointer<vtkTransparencyPass> pass = MaskMethods().front().Make();
  MarkedScene scene(pass);
  const Rgba plate = RoundedTo8Bits({ 0.2, 0.4, 0.9, 0.4 });
  scene.AddPlate(0.5, plate);
  // Lines, which the method refuses, outside of the view.
  scene.AddRectangle(-9.0, -9.0, 9.0, 9.0, 0.0, { 1.0, 1.0, 1.0, 0.5 })
    ->GetProperty()
    ->SetRepresentationToWireframe();
  scene.Render();
  ExpectRefusal(pass, "lines");
  for (const int x : { 3, 12 })
  {
    Rgba expected = CompositePlates({ plate }, x == 3 ? White : TestBackground);
    const Rgba color = scene.Marking->Color.At(x, 8);
    expected[3] = color[3];            // which VTK does not keep
    ExpectColor(color, expected, 1.5); // VTK blends in half floats
  }
  scene.ExpectNoMarksOfTranslucentThings();
  EXPECT_EQ(scene.Marking->DrawBuffersAfterwards, 2u);
}

INSTANTIATE_TEST_SUITE_P(Methods, AmbientOcclusion, testing::ValuesIn(AllMethods()), MethodName());
INSTANTIATE_TEST_SUITE_P(Methods, MarkedOutputs, testing::ValuesIn(AllMethods()), MethodName());

}
