// Translucent parts and the culler: those behind opaque ones are left out, no exact method's picture changes by a bit.
#include "CullerScene.h"
#include "TestMethods.h"

#include "vtkCubeSource.h"
#include "vtkTranslucentPass.h"

#include <gtest/gtest.h>

namespace
{

/**
 * A scene with an opaque wall in the right half of the view, and translucent parts on both sides of it. Some are wholly
 * behind it.
 */
class TransparentScene : public CullerScene
{
public:
  static constexpr int HiddenSpheres = 12;
  static constexpr int HiddenBoxes = 20; ///< at least, from straight ahead; opaque

  explicit TransparentScene(int samples)
    : CullerScene({ "", samples, false, 270, 97, 71 })
  {
    this->AddMesh(MeshOf({ Rectangle(-0.1, -2.0, 2.0, 2.0, 0.0) }));
    this->AddHidden();
    for (int i = 0; i < HiddenSpheres; ++i)
    {
      const double height = -0.6 + 0.1 * i;
      this->AddSphere(-0.6, height, i % 2 ? 0.4 : -0.7, 0.25, this->NextTranslucent());
      this->AddSphere(0.55, height, -0.2, 0.15, this->NextTranslucent()); // hidden
      this->AddSphere(0.4, height, 0.3, 0.2, this->NextTranslucent());
    }
  }

  /** A translucent box around all of it. */
  void AddHousing()
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(5.0);
    cube->SetYLength(5.0);
    cube->SetZLength(2.2);
    this->AddSource(cube, { 0.7, 0.8, 0.9, 0.3 });
  }

private:
  Rgba NextTranslucent()
  {
    return { this->Values.Unit(), this->Values.Unit(), this->Values.Unit(),
      0.2 + 0.6 * this->Values.Unit() };
  }

  TestRandom Values{ 300 };
};

class CullerTransparency : public testing::TestWithParam<Method>
{
protected:
  // Draws with culling and without, and expects the same picture and the same fragments. If a pixel is a group of
  // pixels, edges of hidden parts leak through the parts that hide them. So a few pixels may have less of that.
  static void ExpectSame(TransparentScene& scene)
  {
    const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
    scene.Use(pass);
    TestRandom random(301);
    for (int pose = 0; pose < 3; ++pose)
    {
      SCOPED_TRACE("pose " + std::to_string(pose) + " of seed 301");
      scene.Culler->CullingOn();
      const Picture culled = scene.Render();
      const vtkTypeInt64 fragments = pass->GetNumberOfFragments();
      const vtkTypeInt64 layers = pass->GetMaximumNumberOfLayers();
      const int leftOut = scene.Culler->GetNumberOfCulledParts();
      EXPECT_STREQ(pass->GetFallbackReason(), "");
      EXPECT_GE(
        leftOut, pose == 0 ? TransparentScene::HiddenSpheres + TransparentScene::HiddenBoxes : 1);
      scene.Culler->CullingOff();
      const double besides = GetParam().HasGroups() ? 0.01 : 0.0;
      EXPECT_TRUE(Matches(culled, scene.Render(), 0, besides, { "culled", "plain" }));
      EXPECT_GT(fragments, 0);
      EXPECT_EQ(fragments, pass->GetNumberOfFragments());
      EXPECT_EQ(layers, pass->GetMaximumNumberOfLayers());
      scene.LookFromAnywhere(random);
    }
  }
};

TEST_P(CullerTransparency, PartsBehindOpaqueOnesAreLeftOut)
{
  for (const int samples : GetParam().Samples())
  {
    SCOPED_TRACE(std::to_string(samples) + " samples");
    TransparentScene scene(samples);
    this->ExpectSame(scene);
  }
}

TEST_P(CullerTransparency, HousingsHideNothing)
{
  for (const int samples : GetParam().Samples())
  {
    SCOPED_TRACE(std::to_string(samples) + " samples");
    TransparentScene scene(samples);
    scene.AddHousing();
    this->ExpectSame(scene);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Methods, CullerTransparency, testing::ValuesIn(AllMethods()), MethodName());

/**
 * A scene with translucent parts right behind the edges of opaque parts.
 *
 * In windows of several samples, translucent parts are drawn at pixel centres, by the depth of one sample each. That
 * sample may be uncovered although the centre is covered.
 */
class EdgeScene : public CullerScene
{
public:
  explicit EdgeScene(int samples)
    : CullerScene({ "", samples, true, 270, 61, 51 })
  {
    this->LookAhead();
    const double within = this->PixelSize() / 32.0;
    this->Wall = this->AddMesh(MeshOf({ Rectangle(-0.6, -2.0, 2.0, 2.0, 0.0) }));
    this->Behind = this->AddMesh(
      MeshOf({ Rectangle(-0.6 + within, -2.0, 2.0, 2.0, -0.01) }), { 0.1, 0.9, 0.2, 0.5 });
    this->AddMesh(MeshOf({ Rectangle(-0.3, -0.3, 0.3, 0.3, -0.2) }), { 0.9, 0.1, 0.2, 0.5 });
  }

  /** With edges all over a pixel. */
  void ExpectSameBehindEdges()
  {
    const int steps = 16;
    for (int i = 0; i < steps; ++i)
    {
      SCOPED_TRACE(i);
      const double moved = this->PixelSize() * i / steps;
      this->Wall->SetPosition(moved, 0.0, 0.0);
      this->Behind->SetPosition(moved, 0.0, 0.0);
      EXPECT_GT(this->ExpectSame(), 0);
    }
  }

private:
  vtkSmartPointer<vtkActor> Wall, Behind;
};

TEST_P(CullerTransparency, EdgesOfWhatHides)
{
  for (const int samples : GetParam().Samples())
  {
    SCOPED_TRACE(std::to_string(samples) + " samples");
    EdgeScene scene(samples);
    scene.Use(GetParam().Make());
    scene.ExpectSameBehindEdges();
  }
}

// The centre of a pixel that has several samples lies between them.
TEST(CullerTransparencyEdges, NothingHidesWhatIsThin)
{
  for (const int samples : { 0, 2, 4, 8 })
  {
    SCOPED_TRACE(std::to_string(samples) + " samples");
    CullerScene scene({ "", samples, true, 270, 31, 41 });
    scene.LookAhead();
    const double pixel = scene.PixelSize();
    const Rgba color{ 0.1, 0.9, 0.2, 0.5 };
    const vtkSmartPointer<vtkActor> upright =
      scene.AddMesh(MeshOf({ Rectangle(-0.06 * pixel, -0.3, 0.06 * pixel, 0.3, 0.0) }), color);
    const vtkSmartPointer<vtkActor> level =
      scene.AddMesh(MeshOf({ Rectangle(-0.3, -0.06 * pixel, 0.3, 0.06 * pixel, 0.1) }), color);
    const int steps = 16;
    for (int i = 0; i < steps; ++i)
    {
      SCOPED_TRACE(i);
      upright->SetPosition(pixel * i / steps, 0.0, 0.0);
      level->SetPosition(0.0, pixel * i / steps, 0.0);
      // Where pixels have one sample, both miss it in all steps but the first.
      EXPECT_EQ(scene.ExpectSame(), samples == 0 && i > 0 ? 2 : 0);
    }
  }
}

// As many cells stand for pixels of one sample and for fewer of several.
TEST(CullerTransparencyEdges, OfWindowsThatGetSeveralSamples)
{
  CullerScene scene({ "", 0, true, 270, 160, 160 });
  scene.LookAhead();
  scene.AddMesh(MeshOf({ Rectangle(-2.0, -2.0, 2.0, 2.0, 0.0) }));
  scene.Render();
  EXPECT_EQ(scene.Culler->GetNumberOfBufferLines(), 160);
  scene.Clear();
  scene.Setting.Samples = 4;
  scene.Setting.Width = scene.Setting.Height = 40;
  scene.Window->SetMultiSamples(4);
  scene.Window->SetSize(40, 40);
  const double pixel = scene.PixelSize();
  scene.AddMesh(MeshOf({ Rectangle(0.45 * pixel, -2.0, 2.0, 2.0, 0.0) }));
  scene.AddMesh(MeshOf({ Rectangle(0.47 * pixel, -2.0, 2.0, 2.0, -0.01) }), { 0.1, 0.9, 0.2, 0.5 });
  EXPECT_EQ(scene.ExpectSame(), 0) << "a pixel's centre may be seen beside the wall";
  scene.AddHidden();
  EXPECT_GT(scene.ExpectSame(), 20) << "of boxes, half of which lie well behind the wall";
  scene.Culler->CullingOn();
  scene.Render();
  EXPECT_EQ(scene.Culler->GetNumberOfBufferLines(), 160);
}

TEST(CullerTransparencyEdges, OfWhatHidesAsVTKDraws)
{
  for (const int samples : { 0, 2, 4, 8 })
  {
    SCOPED_TRACE(std::to_string(samples) + " samples");
    EdgeScene scene(samples);
    scene.ExpectSameBehindEdges();
  }
}

// Blending in the order of the actors shows if that changes.
TEST(CullerTransparencyOrder, OfWhatIsLeftIsKept)
{
  TransparentScene scene(0);
  scene.AddHousing();
  scene.Use(vtkSmartPointer<vtkTranslucentPass>::New());
  EXPECT_GE(scene.ExpectSame(), TransparentScene::HiddenSpheres);
  TestRandom random(302);
  for (int pose = 0; pose < 3; ++pose)
  {
    scene.LookFromAnywhere(random);
    EXPECT_GT(scene.ExpectSame(), 0);
  }
}

// A part that turns translucent hides nothing any more, and one that turns opaque does, whatever was drawn before.
TEST(CullerTransparencyOrder, PartsThatTurnTranslucentAndBack)
{
  TransparentScene scene(0);
  scene.Use(AllMethods()[0].Make());
  const vtkSmartPointer<vtkActor> lid = scene.AddWall(0.8);
  const int all = scene.ExpectSame();
  for (int again = 0; again < 2; ++again)
  {
    lid->GetProperty()->SetOpacity(0.5);
    const int behindTheRest = scene.ExpectSame();
    EXPECT_GE(behindTheRest, TransparentScene::HiddenSpheres);
    EXPECT_LT(behindTheRest, all);
    lid->GetProperty()->SetOpacity(1.0);
    EXPECT_EQ(scene.ExpectSame(), all);
  }
}

}
