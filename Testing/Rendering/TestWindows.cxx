// Several windows, and passes and windows that come and go in any order.
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/VitrineOpenGL.h"
#include "vtkActor.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkObjectFactory.h"
#include "vtkSeeThroughPass.h"

#include <gtest/gtest.h>

namespace
{

class Windows : public testing::TestWithParam<Method>
{
};

TEST_P(Windows, TwoAtOnce)
{
  TestScene a(40, 30);
  TestScene b(61, 47);
  a.AddParts();
  b.AddPlates(RandomPlates(20, 0.2, 6), 7);
  a.Renderer->SetPass(MakeSeeThrough(GetParam()));
  b.Renderer->SetPass(MakeSeeThrough(GetParam()));
  const Picture first = a.Render();
  const Picture second = b.Render();
  EXPECT_FALSE(first == second);
  for (int frame = 0; frame < 4; ++frame)
  {
    EXPECT_TRUE(Matches(a.Render(), first));
    EXPECT_TRUE(Matches(b.Render(), second));
  }
}

TEST_P(Windows, OnePassInTwoByTurns)
{
  TestScene a(40, 30);
  TestScene b(61, 47, GetParam().Samples().back());
  a.AddParts();
  b.AddParts();
  a.Renderer->SetPass(MakeSeeThrough(GetParam()));
  b.Renderer->SetPass(MakeSeeThrough(GetParam()));
  const Picture first = a.Render();
  const Picture second = b.Render();
  const vtkSmartPointer<vtkSeeThroughPass> shared = MakeSeeThrough(GetParam());
  a.Renderer->SetPass(shared);
  b.Renderer->SetPass(shared);
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_TRUE(Matches(a.Render(), first));
    EXPECT_TRUE(Matches(b.Render(), second));
  }
}

// Behaves like vtkEGLRenderWindow of VTK 9.6: it does not restore the previous current context, and always claims to be
// current.
class ForgetfulWindow : public vtkHeadlessRenderWindow
{
public:
  static ForgetfulWindow* New();
  vtkTypeMacro(ForgetfulWindow, vtkHeadlessRenderWindow);
  void PushContext() override { this->MakeCurrent(); }
  void PopContext() override {}
  bool IsCurrent() override { return true; }
};
vtkStandardNewMacro(ForgetfulWindow);

TEST_P(Windows, OnePassInTwoThatDoNotGiveWay)
{
  TestScene scenes[] = { TestScene(40, 30), TestScene(61, 47) };
  const vtkSmartPointer<vtkSeeThroughPass> shared = MakeSeeThrough(GetParam());
  vtkNew<ForgetfulWindow> windows[2];
  Picture expected[2];
  for (int i = 0; i < 2; ++i)
  {
    scenes[i].AddParts();
    scenes[i].Renderer->SetPass(MakeSeeThrough(GetParam()));
    expected[i] = scenes[i].Render();
    scenes[i].Window->RemoveRenderer(scenes[i].Renderer);
    windows[i]->SetMultiSamples(0);
    windows[i]->SetSize(scenes[i].Window->GetSize());
    windows[i]->AddRenderer(scenes[i].Renderer);
    scenes[i].Renderer->SetPass(shared);
  }
  for (int frame = 0; frame < 3; ++frame)
  {
    for (int i = 0; i < 2; ++i)
    {
      windows[i]->Render();
      EXPECT_TRUE(Matches(ReadPicture(windows[i]), expected[i]));
      EXPECT_STREQ(
        vtkTransparencyPass::SafeDownCast(shared->GetTranslucentPass())->GetFallbackReason(), "");
    }
  }
}

TEST_P(Windows, AfterTheirResourcesAreReleased)
{
  TestScene scene(40, 30);
  scene.AddParts();
  scene.ExpectTheSameAfterReleases(MakeSeeThrough(GetParam()));
}

TEST_P(Windows, PassesGoFirstOrLast)
{
  vtkSmartPointer<vtkSeeThroughPass> survivor = MakeSeeThrough(GetParam());
  Picture expected;
  {
    TestScene scene(40, 30);
    scene.AddParts();
    scene.Renderer->SetPass(survivor);
    expected = scene.Render();
    scene.Renderer->SetPass(MakeSeeThrough(GetParam()));
    EXPECT_TRUE(Matches(scene.Render(), expected));
    scene.Renderer->SetPass(nullptr);
    scene.Render();
    scene.Renderer->SetPass(MakeSeeThrough(GetParam()));
    EXPECT_TRUE(Matches(scene.Render(), expected));
  }
  TestScene scene(40, 30);
  scene.AddParts();
  scene.Renderer->SetPass(survivor);
  EXPECT_TRUE(Matches(scene.Render(), expected));
  scene.Renderer->SetPass(nullptr);
  survivor = nullptr;
  scene.Render();
}

TEST_P(Windows, WithPassesToggledEveryFrame)
{
  TestScene scene(40, 30);
  scene.AddParts();
  scene.Renderer->SetPass(nullptr);
  const Picture plain = scene.Render();
  const vtkSmartPointer<vtkSeeThroughPass> pass = MakeSeeThrough(GetParam());
  vtkNew<vtkSeeThroughPass> other;
  scene.Renderer->SetPass(pass);
  const Picture expected = scene.Render();
  for (int frame = 0; frame < 4; ++frame)
  {
    scene.Renderer->SetPass(nullptr);
    EXPECT_TRUE(Matches(scene.Render(), plain));
    scene.Renderer->SetPass(pass);
    EXPECT_TRUE(Matches(scene.Render(), expected));
    scene.Renderer->SetPass(other);
    EXPECT_TRUE(Matches(scene.Render(), expected, 2, GetParam().EdgeShare));
  }
}

// Names of OpenGL objects that are in use; they are small numbers, taken again when they are free.
std::vector<int> ObjectCounts()
{
  std::vector<int> counts(5);
  for (GLuint name = 1; name < 3000; ++name)
  {
    counts[0] += glIsTexture(name);
    counts[1] += glIsBuffer(name);
    counts[2] += glIsFramebuffer(name);
    counts[3] += glIsVertexArray(name);
    counts[4] += glIsRenderbuffer(name);
  }
  return counts;
}

TEST_P(Windows, LeakNoObjectsOfPassesThatComeAndGo)
{
  TestScene scene(40, 30);
  scene.AddParts();
  std::vector<int> first;
  // Truth allocates much.
  const int cycles = GetParam().Name == "Truth" ? 12 : 60;
  for (int cycle = 0; cycle < cycles; ++cycle)
  {
    scene.Renderer->SetPass(MakeSeeThrough(GetParam()));
    scene.Render();
    scene.Renderer->SetPass(nullptr);
    scene.Window->MakeCurrent();
    if (cycle == 0)
    {
      first = ObjectCounts();
    }
  }
  EXPECT_EQ(ObjectCounts(), first);
}

TEST_P(Windows, ComeAndGo)
{
  Picture first;
  for (int cycle = 0; cycle < 10; ++cycle)
  {
    TestScene scene(40, 30, cycle % 2 == 0 ? 0 : GetParam().Samples().back());
    scene.AddParts();
    scene.Renderer->SetPass(MakeSeeThrough(GetParam()));
    const Picture picture = scene.Render();
    if (cycle == 0)
    {
      first = picture;
    }
    if (cycle % 2 == 0)
    {
      EXPECT_TRUE(Matches(picture, first)) << "cycle " << cycle;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Windows, testing::ValuesIn(AllMethods()), MethodName());

}
