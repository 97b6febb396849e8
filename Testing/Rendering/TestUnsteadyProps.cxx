// Props that make more fragments each time they are drawn: drawn again while there is a chance, and else said to.
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/VitrineOpenGL.h"
#include "vtkABufferTransparencyPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

constexpr int Width = 16;
constexpr int Height = 16;

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

class UnsteadyProps : public testing::TestWithParam<Method>
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
    // Those that keep 8 bits keep an alpha of 26/255.
    const double alpha = GetParam().KeepsEightBits() ? 26.0 / 255 : 0.1;
    const std::vector<Rgba> plates(layers, { 0.8, 0.2, 0.4, alpha });
    ExpectColor(UniformColor(picture), CompositePlates(plates, TestBackground), 1.0);
  }

  // A limit for 16 rows of 4 layers, or for a few more.
  static constexpr int SmallLimit = 16 * 4 * Width * 3;

  const vtkSmartPointer<vtkABufferTransparencyPass> Pass = MakeABuffer(GetParam());
  vtkNew<UnsteadyActor> Actor;
  TestScene Scene = TestScene(Width, Height);
};

TEST_P(UnsteadyProps, AreDrawnAgainWhereTheyOutgrowTheirRoom)
{
  this->AddActor({ 2, 30, 30 });
  this->Scene.Use(this->Pass);
  this->ExpectLayers(this->Scene.Render(), 30);
  EXPECT_STREQ(this->Pass->GetFallbackReason(), "");
  EXPECT_EQ(this->Pass->GetNumberOfGeometryPasses(), 3);
}

TEST_P(UnsteadyProps, ThatGrowForEverAreSaidTo)
{
  this->AddActor({ 2, 10, 40, 160 });
  const Picture byVTK = this->Scene.RenderAsVTK();
  this->Scene.Use(this->Pass);
  EXPECT_TRUE(Matches(this->Scene.Render(), byVTK));
  ExpectRefusal(this->Pass, "make more fragments each time");
}

TEST_P(UnsteadyProps, AreDrawnAgainWhereTheyOutgrowBands)
{
  this->AddActor({ 4, 4, 4, 20 }); // the frame, its first band, and all after that
  this->Pass->SetMemoryLimit(SmallLimit);
  this->Scene.Use(this->Pass);
  this->ExpectLayers(this->Scene.Render(), 20);
  EXPECT_STREQ(this->Pass->GetFallbackReason(), "");
  EXPECT_GT(this->Pass->GetNumberOfBands(), 8);
}

// The first band is in the picture before another does not fit.
TEST_P(UnsteadyProps, ThatGrowForEverInBandsLeaveNoTrace)
{
  std::vector<int> draws = { 4, 4, 4 };
  for (int draw = 5; draw < 190; ++draw)
  {
    draws.push_back(draw);
  }
  this->AddActor(draws);
  const Picture byVTK = this->Scene.RenderAsVTK();
  this->Pass->SetMemoryLimit(SmallLimit);
  this->Scene.Use(this->Pass);
  EXPECT_TRUE(Matches(this->Scene.Render(), byVTK));
  ExpectRefusal(this->Pass, "make more fragments each time");
}

INSTANTIATE_TEST_SUITE_P(Methods, UnsteadyProps, testing::ValuesIn(ABufferMethods()), MethodName());

}
