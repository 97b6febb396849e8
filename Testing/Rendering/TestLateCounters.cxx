// Frames are resolved before their counters are read, by what the last frame had. Whatever changes from frame to frame,
// each frame is the same as that of a new pass, which knows no last frame.
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/VitrineOpenGL.h"
#include "vtkABufferTransparencyPass.h"
#include "vtkActor.h"
#include "vtkCamera.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

// Keeps the first picture of the target that stands there when a buffer is read: that of bins which are resolved before
// the counters are read.
class PictureBeforeRead
{
public:
  PictureBeforeRead(int width, int height)
  {
    Kept = { width, height, {} };
    ReadOfDriver = glGetBufferSubData;
    glGetBufferSubData = Read;
  }
  ~PictureBeforeRead() { glGetBufferSubData = ReadOfDriver; }
  static const Picture& Get() { return Kept; }

private:
  static void GLAPIENTRY Read(GLenum target, GLintptr offset, GLsizeiptr size, void* data)
  {
    if (Kept.Bytes.empty())
    {
      Kept.Bytes.resize(std::size_t(4) * Kept.Width * Kept.Height);
      GLint drawn = 0;
      GLint read = 0;
      glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn);
      glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
      glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(drawn));
      glReadPixels(0, 0, Kept.Width, Kept.Height, GL_RGBA, GL_UNSIGNED_BYTE, Kept.Bytes.data());
      glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read));
    }
    ReadOfDriver(target, offset, size, data);
  }
  static Picture Kept;
  static decltype(glGetBufferSubData) ReadOfDriver;
};
Picture PictureBeforeRead::Kept;
decltype(glGetBufferSubData) PictureBeforeRead::ReadOfDriver = nullptr;

class LateCounters : public testing::TestWithParam<Method>
{
protected:
  LateCounters()
  {
    for (const int layers : { 3, 12, 40, 90, 300 })
    {
      this->Plates.push_back(this->Scene.AddPlates(RandomPlates(layers, 0.02, 5), 6));
    }
    this->Scene.AddSphere(0.2, 0.1, 0.0, 0.6, { 0.9, 0.2, 0.2, 0.5 });
    this->Plates.push_back(
      this->Scene.AddRectangle(-0.9, -0.9, 0.1, 0.3, 0.2, { 0.1, 0.4, 0.9, 0.4 }));
  }

  // Shows the plates whose bits are set.
  void Show(int bits)
  {
    for (std::size_t i = 0; i < this->Plates.size(); ++i)
    {
      this->Plates[i]->SetVisibility(bits >> i & 1);
    }
  }

  // Draws the frame by the pass and by a new one with the same settings.
  void ExpectSameAsNew()
  {
    const vtkSmartPointer<vtkABufferTransparencyPass> other = MakeABuffer(GetParam());
    other->SetMemoryLimit(this->Pass->GetMemoryLimit());
    other->SetCoincidenceSteps(this->Pass->GetCoincidenceSteps());
    this->Scene.Use(other);
    const Picture expected = this->Scene.Render();
    this->Scene.Use(this->Pass);
    EXPECT_TRUE(Matches(this->Scene.Render(), expected));
    EXPECT_STREQ(this->Pass->GetFallbackReason(), other->GetFallbackReason());
    EXPECT_EQ(this->Pass->GetNumberOfFragments(), other->GetNumberOfFragments());
    EXPECT_EQ(this->Pass->GetMaximumNumberOfLayers(), other->GetMaximumNumberOfLayers());
  }

  TestScene Scene = TestScene(42, 35);
  std::vector<vtkSmartPointer<vtkActor>> Plates;
  const vtkSmartPointer<vtkABufferTransparencyPass> Pass = MakeABuffer(GetParam());
};

TEST_P(LateCounters, FollowLengthsThatComeAndGo)
{
  // From few layers to many at once, down, one bin beside another, and all of them.
  for (const int bits : { 1, 16, 1, 2, 4, 32, 8, 33, 48, 0, 2, 63, 63, 32 })
  {
    SCOPED_TRACE(bits);
    this->Show(bits);
    this->ExpectSameAsNew();
  }
}

TEST_P(LateCounters, FollowMovesOfTheCamera)
{
  this->Show(3);
  for (const double scale : { 1.0, 4.0, 0.4, 1.0, 20.0, 1.0 })
  {
    SCOPED_TRACE(scale);
    this->Scene.Renderer->GetActiveCamera()->SetParallelScale(scale);
    this->Scene.Renderer->GetActiveCamera()->Azimuth(25);
    this->Scene.Renderer->ResetCameraClippingRange();
    this->ExpectSameAsNew();
  }
}

TEST_P(LateCounters, FollowLimitsAndTolerances)
{
  for (const int bits : { 4, 8, 4, 32, 12, 12 })
  {
    for (const int limit : { 0, 100000, 30000, 0 })
    {
      SCOPED_TRACE(std::to_string(bits) + ", limit " + std::to_string(limit));
      this->Show(bits);
      this->Pass->SetMemoryLimit(limit);
      this->Pass->SetCoincidenceSteps(limit == 30000 ? 1.0 : 0.0);
      this->ExpectSameAsNew();
      this->ExpectSameAsNew();
    }
  }
}

// Lists for which there was too little room are not resolved: a pixel shows what is behind it, or its complete list.
TEST_P(LateCounters, ResolveNoIncompleteLists)
{
  this->Show(0);
  this->Scene.Use(this->Pass);
  const Picture behind = this->Scene.Render(); // its first pixel shows the background
  // Lists of the same bin, of few pixels and of many.
  const vtkSmartPointer<vtkActor> plates = this->Scene.AddPlates(RandomPlates(30, 0.1, 8), 9);
  const vtkSmartPointer<vtkABufferTransparencyPass> other = MakeABuffer(GetParam());
  this->Scene.Use(other);
  const Picture whole = this->Scene.Render();
  plates->SetScale(0.02, 0.02, 1.0);
  this->Scene.Use(this->Pass);
  for (int frame = 0; frame < 3; ++frame)
  {
    this->Scene.Render();
  }
  plates->SetScale(1.0, 1.0, 1.0);
  {
    const PictureBeforeRead before(whole.Width, whole.Height);
    EXPECT_TRUE(Matches(this->Scene.Render(), whole));
  }
  EXPECT_GT(this->Pass->GetNumberOfGeometryPasses(), 1) << this->Pass->GetNumberOfFragments();
  const Picture& early = PictureBeforeRead::Get();
  ASSERT_EQ(early.Bytes.size(), whole.Bytes.size());
  int torn = 0;
  for (std::size_t i = 0; i < early.Bytes.size(); i += 4)
  {
    const auto shows = [&](const unsigned char* color)
    { return std::equal(color, color + 4, &early.Bytes[i]); };
    torn += !shows(&behind.Bytes[0]) && !shows(&whole.Bytes[i]);
  }
  EXPECT_EQ(torn, 0);
}

// A pixel that alone exceeds the limit: the frame is VTK's, over what was there before the lists were resolved.
TEST_P(LateCounters, LeaveNothingOfFramesThatCannotBeDrawn)
{
  this->Show(1);
  this->ExpectSameAsNew();
  this->Pass->SetMemoryLimit(1000);
  this->Show(17);
  const Picture byVTK = this->Scene.RenderAsVTK();
  this->Scene.Use(this->Pass);
  EXPECT_TRUE(Matches(this->Scene.Render(), byVTK));
  ExpectRefusal(this->Pass, "one pixel alone needs");
}

INSTANTIATE_TEST_SUITE_P(Methods, LateCounters, testing::ValuesIn(ABufferMethods()), MethodName());

}
