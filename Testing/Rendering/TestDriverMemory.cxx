// Drivers that have less memory than a method asks for: fewer fragments at a time, and what cannot be drawn is said.
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/VitrineOpenGL.h"
#include "vtkABufferTransparencyPass.h"
#include "vtkActor.h"

#include <gtest/gtest.h>

namespace
{

constexpr int Width = 16;
constexpr int Height = 16;
constexpr int Layers = 40;

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
    // Copies of counters take less than any driver refuses, but more than a part of so few fragments.
    const bool refuses = target == GL_COPY_WRITE_BUFFER && size > Memory && usage != GL_STREAM_READ;
    Refusals += refuses ? 1 : 0;
    Driver(target, refuses ? GLsizeiptr(1) << 50 : size, data, usage);
  }
  static GLsizeiptr Memory;
  static decltype(glBufferData) Driver;
};
int ScarceBuffers::Refusals = 0;
GLsizeiptr ScarceBuffers::Memory = 0;
decltype(glBufferData) ScarceBuffers::Driver = nullptr;

// The refusals themselves are what OpenGL complains about.
void DropOutOfMemory()
{
  for (const std::string& message : TakeMessages())
  {
    EXPECT_NE(message.find("OUT_OF_MEMORY"), std::string::npos) << message;
  }
}

class DriverMemory : public testing::TestWithParam<Method>
{
protected:
  DriverMemory() { this->Scene.AddPlates(RandomPlates(Layers, 0.1, 5), 6); }

  // What the fragments themselves take.
  static GLsizeiptr Needed()
  {
    return GLsizeiptr(GetParam().NodeBytes()) * Layers * Width * Height;
  }

  // The picture where there is memory for everything.
  Picture RenderUnbounded()
  {
    this->Scene.Use(GetParam().Make());
    return this->Scene.Render();
  }

  TestScene Scene = TestScene(Width, Height);
};

TEST_P(DriverMemory, ForNoReserveIsEnough)
{
  const Picture expected = this->RenderUnbounded();
  const vtkSmartPointer<vtkABufferTransparencyPass> frugal = MakeABuffer(GetParam());
  this->Scene.Use(frugal);
  {
    const ScarceBuffers scarce(Needed());
    EXPECT_TRUE(Matches(this->Scene.Render(), expected));
    DropOutOfMemory();
  }
  EXPECT_STREQ(frugal->GetFallbackReason(), "");
  EXPECT_EQ(frugal->GetNumberOfBands(), 1);
  EXPECT_LE(ScarceBuffers::Refusals, 1);
}

TEST_P(DriverMemory, ForAPartIsDrawnInBands)
{
  const Picture expected = this->RenderUnbounded();
  for (const int part : { 5, 30 })
  {
    SCOPED_TRACE("memory for 1/" + std::to_string(part));
    const vtkSmartPointer<vtkABufferTransparencyPass> frugal = MakeABuffer(GetParam());
    this->Scene.Use(frugal);
    {
      const ScarceBuffers scarce(Needed() / part);
      EXPECT_TRUE(Matches(this->Scene.Render(), expected));
      EXPECT_STREQ(frugal->GetFallbackReason(), "");
      // The driver refuses single buffers, and one holds two of the three words of a node of 12 bytes.
      EXPECT_GE(frugal->GetNumberOfBands(), part * 2 / 3);
      EXPECT_LE(frugal->GetNumberOfBands(), 4 * part);
      DropOutOfMemory();

      // Remembered, so that the driver is not asked in vain every frame.
      const int refusals = ScarceBuffers::Refusals;
      EXPECT_TRUE(Matches(this->Scene.Render(), expected));
      EXPECT_EQ(ScarceBuffers::Refusals, refusals);
    }
    for (int frame = 0; frame < 40; ++frame)
    {
      this->Scene.Render();
    }
    EXPECT_EQ(frugal->GetNumberOfBands(), 1); // there is memory again
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, DriverMemory, testing::ValuesIn(ABufferMethods()), MethodName());

class NoDriverMemory : public DriverMemory
{
};

TEST_P(NoDriverMemory, IsSaid)
{
  const Picture byVTK = this->Scene.RenderAsVTK();
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  this->Scene.Use(pass);
  {
    const ScarceBuffers scarce(100);
    EXPECT_TRUE(Matches(this->Scene.Render(), byVTK));
  }
  const std::string reason = pass->GetFallbackReason();
  EXPECT_EQ(reason.find("the driver has no memory for"), 0u) << reason;
  TakeMessages();
  ExpectTruth(this->Scene, pass, 2.0);
}

// With layers that the method keeps.
INSTANTIATE_TEST_SUITE_P(Methods, NoDriverMemory,
  testing::ValuesIn(MethodsThat([](const Method& method) { return method.Keeps(Layers); })),
  MethodName());

}
