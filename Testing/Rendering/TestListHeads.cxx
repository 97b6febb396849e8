// The lists of a new image of heads are empty everywhere, not in the regions of frames alone.
#include "TestScene.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "gl/VitrineOpenGL.h"
#include "transparency/abuffer/ListHeads.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace
{

// The first word of an empty list that shaders fetch in these tests, which no memory has by chance.
constexpr GLuint Empty = 0x5eed5eedu;

// Counts the clears of images while it lives. With atomics a new image may be 0 by chance.
class ClearCount
{
public:
  ClearCount()
  {
    Count = 0;
    Clear = glClearBufferuiv;
    glClearBufferuiv = [](GLenum buffer, GLint index, const GLuint* value)
    {
      ++Count;
      Clear(buffer, index, value);
    };
  }
  ~ClearCount() { glClearBufferuiv = Clear; }
  ClearCount(const ClearCount&) = delete;
  void operator=(const ClearCount&) = delete;
  static int Count;

private:
  static decltype(glClearBufferuiv) Clear;
};
int ClearCount::Count = 0;
decltype(glClearBufferuiv) ClearCount::Clear = nullptr;

class ListHeads : public testing::TestWithParam<bool>
{
protected:
  ListHeads() { this->Scene.Render(); }

  vtkOpenGLRenderWindow* Window() const
  {
    return vtkOpenGLRenderWindow::SafeDownCast(this->Scene.Window);
  }

  void Prepare(int width, int height)
  {
    const vitrine::ScopedTrackedState trackedState(this->Window()->GetState());
    vitrine::RenderTarget target;
    target.Width = width;
    target.Height = height;
    ASSERT_EQ(this->Heads.Prepare(this->Window()->GetState(), target, GetParam(), Empty, 8), "");
  }

  // The number of heads, and how many of them are of empty lists.
  std::pair<std::size_t, int> Count()
  {
    const vitrine::ScopedTrackedState trackedState(this->Window()->GetState());
    const std::vector<std::uint32_t> words = this->Heads.Read(this->Window()->GetState());
    int empty = 0;
    for (std::size_t i = 0; i < words.size(); i += 2)
    {
      empty += words[i] == (GetParam() ? Empty : 0u) && words[i + 1] == 0u;
    }
    return { words.size() / 2, empty };
  }

  TestScene Scene = TestScene(20, 10);
  vitrine::ListHeads Heads;
};

TEST_P(ListHeads, AreOfEmptyListsInANewImage)
{
  const ClearCount clears;
  this->Prepare(20, 10);
  EXPECT_EQ(ClearCount::Count, 1);
  EXPECT_EQ(this->Count(), std::make_pair(std::size_t(24 * 16), 24 * 16));
  this->Prepare(40, 10);
  EXPECT_EQ(ClearCount::Count, 2);
  EXPECT_EQ(this->Count(), std::make_pair(std::size_t(40 * 16), 40 * 16));
  this->Heads.Release();
}

// Frames that find their image there clear no more than their regions.
TEST_P(ListHeads, AreKeptInTheSameImage)
{
  this->Prepare(20, 10);
  {
    const vitrine::ScopedTrackedState trackedState(this->Window()->GetState());
    const vitrine::ScopedTextureUnit unit(
      this->Window()->GetState(), GL_TEXTURE_2D, this->Heads.Image().Handle());
    const GLuint other[2] = { 1u, 2u };
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GetParam() ? GL_RG_INTEGER : GL_RED_INTEGER,
      GL_UNSIGNED_INT, other);
  }
  this->Prepare(20, 10);
  EXPECT_EQ(this->Count().second, 24 * 16 - 1);
  this->Heads.Release();
}

INSTANTIATE_TEST_SUITE_P(Paths, ListHeads, testing::Bool(),
  [](const auto& info) { return std::string(info.param ? "Fetched" : "Atomic"); });

}
