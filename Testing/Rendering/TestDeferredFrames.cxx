// Windows, viewports and passes around deferred shading.
#include "DeferredScene.h"
#include "Select.h"
#include "TestMessages.h"
#include "TestPasses.h"
#include "gl/VitrineOpenGL.h"
#include "vtkDataObject.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLState.h"
#include "vtkRenderStepsPass.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>

#include <map>

namespace
{

TEST(DeferredFrame, OfNoLightsOrOneHeadlightIsVTKs)
{
  DeferredScene scene;
  scene.AddLights(1);
  scene.InDeferredLight();
  scene.Renderer->RemoveAllLights();
  EXPECT_TRUE(Matches(scene.InDeferredLight(), scene.InVTKsLight()));
  EXPECT_EQ(scene.Deferred->GetNumberOfDeferredProps(), 0);
  scene.AddLight(LightKind::Headlight);
  const vtkTypeInt64 bytes = scene.Deferred->GetBytes();
  EXPECT_TRUE(Matches(scene.InDeferredLight(), scene.InVTKsLight()));
  EXPECT_EQ(scene.Deferred->GetNumberOfDeferredProps(), 0);
  EXPECT_EQ(scene.Deferred->GetBytes(), bytes);
}

TEST(DeferredFrame, OfNothingOpaqueIsVTKs)
{
  DeferredScene scene;
  scene.AddLights(1);
  scene.InDeferredLight();
  for (const int i : { 0, 2, 4, 5 })
  {
    scene.Renderer->RemoveActor(scene.Parts[i]);
  }
  scene.ExpectAsVTK(0);
  scene.Renderer->RemoveAllViewProps();
  scene.ExpectAsVTK(0);
}

TEST(DeferredFrame, OfAnySizeIsVTKs)
{
  DeferredScene scene;
  scene.AddLights(2);
  for (const std::array<int, 2> size : { std::array{ 61, 47 }, { 1, 1 }, { 90, 20 }, { 16, 16 } })
  {
    scene.Window->SetSize(size[0], size[1]);
    scene.ExpectAsVTK(DeferredParts);
  }
}

TEST(DeferredFrame, OfLightsThatReachNothingIsVTKs)
{
  DeferredScene scene(false);
  for (int i = 0; i < 2; ++i)
  {
    const auto light = scene.AddLight(LightKind::Spot);
    light->SetPosition(0.0, 0.0, 9.0);
    light->SetFocalPoint(0.0, 0.0, 20.0);
  }
  scene.ExpectAsVTK(DeferredParts);
}

TEST(DeferredFrame, InSeveralViewportsAndLayersIsVTKs)
{
  for (const bool isPreserved : { false, true })
  {
    DeferredScene scene;
    scene.AddLights(2);
    scene.Renderer->SetViewport(0.0, 0.0, 0.6, 1.0);
    vtkNew<vtkRenderer> above;
    above->SetActiveCamera(scene.Renderer->GetActiveCamera());
    above->SetViewport(0.3, 0.2, 1.0, 0.9);
    above->SetLayer(1);
    above->SetPreserveDepthBuffer(isPreserved);
    above->AutomaticLightCreationOff();
    above->SetLightCollection(scene.Renderer->GetLights());
    above->AddActor(scene.Parts[2]);
    above->AddActor(scene.Parts[5]);
    scene.Window->SetNumberOfLayers(2);
    scene.Window->AddRenderer(above);
    vtkNew<vtkSeeThroughPass> steps;
    above->SetPass(steps);
    const Picture expected = scene.InVTKsLight();
    vtkNew<vtkDeferredLightsPass> deferred;
    deferred->SetDelegatePass(steps);
    deferred->SetCutOff(0.0);
    above->SetPass(deferred);
    EXPECT_TRUE(Matches(scene.InDeferredLight(), expected)) << isPreserved;
    EXPECT_EQ(deferred->GetNumberOfDeferredProps(), 2);
    // One pass for both.
    scene.Deferred->SetTileSize(64);
    above->SetPass(scene.Deferred);
    EXPECT_TRUE(Matches(scene.InDeferredLight(), expected)) << isPreserved;
  }
}

TEST(DeferredFrame, OfAnotherSampleCountIsVTKs)
{
  DeferredScene scene;
  scene.AddLights(2);
  for (const int samples : { 4, 0, 4 })
  {
    scene.Window->SetMultiSamples(samples);
    scene.ExpectAsVTK(DeferredParts);
  }
}

TEST(DeferredFrame, WithAStencilBufferIsVTKs)
{
  for (const int samples : { 0, 4 })
  {
    DeferredScene scene(true, false, samples);
    scene.Window->SetStencilCapable(1);
    scene.AddLights(1);
    scene.ExpectAsVTK(DeferredParts);
  }
}

TEST(DeferredFrame, OfATiledScreenshotIsVTKs)
{
  DeferredScene scene(false);
  scene.AddLights(2);
  const auto shoot = [&](vtkRenderPass* pass)
  {
    scene.Renderer->SetPass(pass);
    vtkNew<vtkWindowToImageFilter> shot;
    shot->SetInput(scene.Window);
    shot->SetScale(2, 3);
    shot->ShouldRerenderOn();
    shot->Update();
    return ToPicture(shot->GetOutput());
  };
  const Picture expected = shoot(scene.Steps);
  for (const int assignment : DeferredAssignments)
  {
    scene.Deferred->SetAssignment(assignment);
    EXPECT_TRUE(Matches(shoot(scene.Deferred), expected)) << assignment;
  }
}

TEST(DeferredFrame, MovesFromWindowToWindow)
{
  DeferredScene first, second(true, false, 4);
  Picture expected[2];
  for (int i = 0; i < 2; ++i)
  {
    DeferredScene& scene = i == 0 ? first : second;
    scene.AddLights(1);
    expected[i] = scene.InVTKsLight();
  }
  for (int i = 0; i < 4; ++i)
  {
    DeferredScene& scene = i % 2 == 0 ? first : second;
    first.Deferred->SetDelegatePass(scene.Steps);
    first.Deferred->SetAssignment(DeferredAssignments[i % 3]);
    scene.Renderer->SetPass(first.Deferred);
    EXPECT_TRUE(Matches(scene.Render(), expected[i % 2]));
    EXPECT_EQ(first.Deferred->GetNumberOfDeferredProps(), DeferredParts);
  }
}

TEST(DeferredFrame, AfterResourcesAreReleasedIsTheSame)
{
  DeferredScene scene;
  scene.AddLights(2);
  for (const int assignment :
    { vtkDeferredLightsPass::LIGHT_VOLUMES, vtkDeferredLightsPass::CLUSTERS })
  {
    scene.Deferred->SetAssignment(assignment);
    scene.ExpectTheSameAfterReleases(scene.Deferred);
  }
}

TEST(DeferredFrame, TellsItsMemory)
{
  DeferredScene scene;
  scene.AddLights(1);
  scene.InDeferredLight();
  const vtkTypeInt64 surfaces = 61 * 47 * 2 * 16; // of one material each
  EXPECT_GE(scene.Deferred->GetBytes(), surfaces);
  EXPECT_LT(scene.Deferred->GetBytes(), surfaces + 30000);
  scene.Deferred->SetAssignment(vtkDeferredLightsPass::LIGHT_VOLUMES);
  scene.InDeferredLight();
  EXPECT_GE(scene.Deferred->GetBytes(), surfaces + 61 * 47 * 2 * 16);
  scene.Deferred->SetAssignment(vtkDeferredLightsPass::TILES);
  scene.InDeferredLight();
  EXPECT_LT(scene.Deferred->GetBytes(), surfaces + 30000); // and gives back what it needs no more
}

TEST(DeferredFrame, DoesNotHinderPicking)
{
  DeferredScene scene;
  scene.AddLights(1);
  const Picture before = scene.InDeferredLight();
  const auto pick = [&]
  { return Select(scene.Renderer, vtkDataObject::FIELD_ASSOCIATION_CELLS, 0, 0, 60, 46); };
  const Picked picked = pick();
  EXPECT_TRUE(Matches(scene.Render(), before));
  scene.Renderer->SetPass(nullptr);
  EXPECT_EQ(picked, pick());
  EXPECT_GT(picked.size(), 3u);
}

// vtkSeeThroughPass lets the renderer draw what selectors ask for. Other delegates draw it themselves, all in one way.
TEST(DeferredFrame, OfASelectorIsNotDeferred)
{
  DeferredScene scene;
  scene.AddLights(1);
  vtkNew<vtkRenderStepsPass> steps;
  scene.Deferred->SetDelegatePass(steps);
  scene.InDeferredLight();
  EXPECT_EQ(scene.Deferred->GetNumberOfDeferredProps(), DeferredParts);
  Select(scene.Renderer, vtkDataObject::FIELD_ASSOCIATION_CELLS, 0, 0, 60, 46);
  EXPECT_EQ(scene.Deferred->GetNumberOfDeferredProps(), 0);
}

TEST(DeferredFrame, ShowsNothingOfTheLastOne)
{
  DeferredScene scene;
  scene.AddLights(1);
  scene.ExpectAsVTK(DeferredParts);
  scene.Parts.back()->VisibilityOff();
  scene.ExpectAsVTK(DeferredParts - 1);
}

TEST(DeferredFrame, IsToldOfWhenItsWindowIsGone)
{
  DeferredScene scene;
  scene.AddLights(1);
  scene.InDeferredLight();
  const vtkIdType count = scene.Deferred->GetNumberOfLightsAt(0.0, 0.9, -1.5);
  EXPECT_GT(count, 0);
  scene.Window->Finalize();
  scene.Deferred->ReleaseGraphicsResources(scene.Window);
  EXPECT_EQ(scene.Deferred->GetNumberOfLightsAt(0.0, 0.9, -1.5), count);
}

// Where the delegate does not say what its opaque pass is, or that is one of its own kind.
TEST(DeferredFrame, OfOtherPassesIsNotDeferred)
{
  DeferredScene scene;
  scene.AddLights(2);
  const Picture expected = scene.InVTKsLight();

  scene.Deferred->SetDelegatePass(InSequence({ scene.Steps }));
  EXPECT_TRUE(Matches(scene.InDeferredLight(), expected));
  EXPECT_EQ(scene.Deferred->GetNumberOfDeferredProps(), 0);

  const auto opaque = InSequence({ vtkNew<vtkOpaquePass>() });
  scene.Steps->SetOpaquePass(opaque);
  scene.Deferred->SetDelegatePass(scene.Steps);
  EXPECT_TRUE(Matches(scene.InDeferredLight(), expected));
  EXPECT_EQ(scene.Deferred->GetNumberOfDeferredProps(), 0);
  EXPECT_EQ(scene.Steps->GetOpaquePass(), opaque);
}

/** Its shaders lack what is joined to them, at one of VTK's tags. */
class MapperWithoutTag : public vtkOpenGLPolyDataMapper
{
public:
  static MapperWithoutTag* New() { VTK_STANDARD_NEW_BODY(MapperWithoutTag); }
  const char* GetClassNameInternal() const override { return "vtkOpenGLPolyDataMapper"; }

protected:
  void ReplaceShaderLight(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override
  {
    this->vtkOpenGLPolyDataMapper::ReplaceShaderLight(shaders, renderer, actor);
    std::string text = shaders[vtkShader::Fragment]->GetSource();
    vtkShaderProgram::Substitute(text, "//VTK::DepthPeeling::Impl", "");
    shaders[vtkShader::Fragment]->SetSource(text);
  }
};

TEST(DeferredFrame, OfShadersThatCannotBeRewrittenIsNotDeferred)
{
  DeferredScene scene;
  scene.AddLights(1);
  vtkNew<MapperWithoutTag> mapper;
  mapper->SetInputConnection(scene.Parts[2]->GetMapper()->GetInputConnection(0, 0));
  scene.Parts[2]->SetMapper(mapper);
  scene.ExpectAsVTK(0);
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("//VTK::DepthPeeling::Impl"), std::string::npos) << messages[0];
}

/** What OpenGL has been set to, and what vtkOpenGLState believes of that. */
std::vector<GLint> StateOf(vtkRenderWindow* window)
{
  std::vector<GLint> record;
  vtkOpenGLState* const state = static_cast<vtkOpenGLRenderWindow*>(window)->GetState();
  for (const GLenum capability :
    { GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_MULTISAMPLE })
  {
    record.push_back(glIsEnabled(capability));
    EXPECT_EQ(state->GetEnumState(capability), glIsEnabled(capability) == GL_TRUE) << capability;
  }
  for (const GLenum name : { GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA,
         GL_BLEND_DST_ALPHA, GL_DEPTH_FUNC, GL_DEPTH_WRITEMASK, GL_DRAW_FRAMEBUFFER_BINDING,
         GL_READ_FRAMEBUFFER_BINDING, GL_DRAW_BUFFER0, GL_DRAW_BUFFER1, GL_ACTIVE_TEXTURE,
         GL_SHADER_STORAGE_BUFFER_BINDING, GL_VERTEX_ARRAY_BINDING, GL_COPY_WRITE_BUFFER_BINDING })
  {
    GLint value = 0;
    glGetIntegerv(name, &value);
    record.push_back(value);
  }
  GLint mask[4] = {};
  glGetIntegerv(GL_COLOR_WRITEMASK, mask);
  record.insert(record.end(), mask, mask + 4);
  return record;
}

TEST(DeferredFrame, LeavesOpenGLAsVTKDoes)
{
  for (const int samples : { 0, 4 })
  {
    DeferredScene scene(true, false, samples);
    scene.AddLights(1);
    scene.InVTKsLight();
    const std::vector<GLint> expected = StateOf(scene.Window);
    for (const int assignment : DeferredAssignments)
    {
      scene.Deferred->SetAssignment(assignment);
      scene.InDeferredLight();
      EXPECT_EQ(StateOf(scene.Window), expected) << assignment;
    }
  }
}

TEST(DeferredFrame, HasNoGridOfTheWorldAndSaysSo)
{
  DeferredScene scene;
  scene.AddLights(2);
  scene.Deferred->SetGridSpace(vtkDeferredLightsPass::WORLD);
  scene.ExpectAsVTK(DeferredParts);
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("not of the world"), std::string::npos) << messages[0];
}

TEST(DeferredFrame, PutsTheOpaquePassBack)
{
  DeferredScene scene;
  scene.AddLights(1);
  vtkRenderPass* const before = scene.Steps->GetOpaquePass();
  scene.InDeferredLight();
  EXPECT_EQ(scene.Steps->GetOpaquePass(), before);
}

TEST(DeferredFrame, MayPassThroughPassesOfItsKind)
{
  DeferredScene scene;
  scene.AddLights(1);
  const Picture expected = scene.InVTKsLight();
  vtkNew<vtkDeferredLightsPass> outer;
  outer->SetDelegatePass(scene.Deferred);
  scene.Renderer->SetPass(outer);
  EXPECT_TRUE(Matches(scene.Render(), expected));
}

// The frame is lit all the same, and says that it was not from a G-buffer.
TEST(DeferredFrame, SaysWhyItIsNotDeferred)
{
  DeferredScene scene;
  scene.AddLights(1);
  scene.InDeferredLight();
  EXPECT_STREQ(scene.Deferred->GetFallbackReason(), "");
  scene.Renderer->UseHiddenLineRemovalOn();
  EXPECT_TRUE(Matches(scene.InDeferredLight(), scene.InVTKsLight()));
  EXPECT_EQ(scene.Deferred->GetNumberOfDeferredProps(), 0);
  EXPECT_NE(std::string(scene.Deferred->GetFallbackReason()).find("UseHiddenLineRemoval"),
    std::string::npos)
    << scene.Deferred->GetFallbackReason();
  scene.Renderer->UseHiddenLineRemovalOff();
  scene.ExpectAsVTK(DeferredParts);
  EXPECT_STREQ(scene.Deferred->GetFallbackReason(), "");
  scene.Deferred->SetDelegatePass(vtkNew<UnknownPass>());
  scene.InDeferredLight();
  EXPECT_EQ(scene.Deferred->GetNumberOfDeferredProps(), 0);
  EXPECT_NE(
    std::string(scene.Deferred->GetFallbackReason()).find("vtkOpaquePass"), std::string::npos)
    << scene.Deferred->GetFallbackReason();
  scene.Deferred->ReleaseGraphicsResources(scene.Window);
  scene.Renderer->SetPass(nullptr);
}

}
