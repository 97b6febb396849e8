// The GL objects that passes hold: owned once, allocated or not, and never another context's.
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/GLObjects.h"
#include "vtkActor.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace
{

template <class T>
constexpr bool MovesOnly =
  std::is_nothrow_move_constructible_v<T>&& std::is_nothrow_move_assignable_v<T> &&
  !std::is_copy_constructible_v<T> && !std::is_copy_assignable_v<T>;
static_assert(MovesOnly<vitrine::Image2D>, "one owner");
static_assert(MovesOnly<vitrine::Buffer>, "one owner");
static_assert(MovesOnly<vitrine::Framebuffer>, "one owner");
static_assert(MovesOnly<vitrine::EmptyVertexArray>, "one owner");

class GLObjects : public testing::Test
{
protected:
  GLObjects() { this->Scene.Render(); }
  TestScene Scene = TestScene(4, 4);
};

TEST_F(GLObjects, MoveWithTheirNames)
{
  vitrine::Buffer buffer;
  ASSERT_TRUE(buffer.Allocate(64));
  const GLuint name = buffer.Handle();
  vitrine::Buffer other = std::move(buffer);
  EXPECT_EQ(other.Handle(), name);
  EXPECT_EQ(buffer.Handle(), 0u);
  other.Release();
  EXPECT_FALSE(glIsBuffer(name));
}

TEST_F(GLObjects, AnImageTooLargeIsSaidToBe)
{
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  vitrine::Image2D image;
  EXPECT_EQ(image.Allocate(GL_R8, largest, 1, 0), "");
  EXPECT_NE(image.Handle(), 0u);
  const std::string size = std::to_string(largest + 1);
  EXPECT_EQ(image.Allocate(GL_R8, 1, largest + 1, 0),
    "it takes an image of 1x" + size + " pixels, and the driver's largest has " +
      std::to_string(largest) + " a side");
  EXPECT_EQ(image.Handle(), 0u);
  EXPECT_EQ(image.Bytes(), 0);
}

TEST_F(GLObjects, AnImageThatTheDriverRefusesIsSaidToBe)
{
  vitrine::Image2D image;
  EXPECT_EQ(image.Allocate(GL_DEPTH_COMPONENT, 4, 4, 0), // unsized, so no immutable image
    "the driver has no memory for an image of 4x4 pixels");
  EXPECT_EQ(image.Handle(), 0u);
  EXPECT_EQ(TakeMessages().size(), 1u);
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

// An error before an allocation is none of the allocation's, and is told.
TEST_F(GLObjects, EarlierErrorsAreToldAndNotTaken)
{
  glEnable(GL_TEXTURE_2D_ARRAY); // no such capability
  vitrine::Buffer buffer;
  EXPECT_TRUE(buffer.Allocate(64));
  int told = 0;
  for (const std::string& message : TakeMessages())
  {
    told += message.find("before an allocation") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(told, 1);
  buffer.Release();
}

//------------------------------------------------------------------------------
class StaleNames : public testing::TestWithParam<Method>
{
};

// A window that was finalized without its pass makes a new context, where the pass's names are those of others.
TEST_P(StaleNames, AreNotReleasedInANewContext)
{
  TestScene scene(64, 64);
  scene.AddSphere(0.3, 0.1, 0.2, 0.5, { 0.9, 0.5, 0.1, 0.4 });
  scene.AddPlate(-0.9, { 0.2, 0.3, 0.4, 1.0 });
  const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
  scene.Use(pass);
  scene.Render();
  scene.Renderer->SetPass(nullptr);
  scene.Window->Finalize();
  scene.Render();

  // Names that nothing else has, up to those of the pass.
  constexpr int count = 200;
  std::vector<GLuint> buffers(count);
  std::vector<GLuint> textures(count);
  glGenBuffers(count, buffers.data());
  glGenTextures(count, textures.data());
  for (int i = 0; i < count; ++i)
  {
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffers[i]);
    glBindTexture(GL_TEXTURE_2D, textures[i]);
  }
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  glBindTexture(GL_TEXTURE_2D, 0);
  pass->ReleaseGraphicsResources(scene.Window);
  for (int i = 0; i < count; ++i)
  {
    EXPECT_TRUE(glIsBuffer(buffers[i])) << "buffer " << buffers[i];
    EXPECT_TRUE(glIsTexture(textures[i])) << "texture " << textures[i];
  }
  glDeleteBuffers(count, buffers.data());
  glDeleteTextures(count, textures.data());
  EXPECT_EQ(pass->GetBytes(), 0);
}

INSTANTIATE_TEST_SUITE_P(Methods, StaleNames, testing::ValuesIn(AllMethods()), MethodName());

}
