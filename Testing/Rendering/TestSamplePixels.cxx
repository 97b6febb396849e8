// The samples of multisampled targets on the CPU: colours and depths survive a way there and back to the bit.
#include "TestScene.h"
#include "gl/GLObjects.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "gl/StateRecord.h"
#include "gl/TargetPixels.h"
#include "transparency/ranks/SamplePixels.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <string>
#include <vector>

namespace
{

using vitrine::PixelRegion;

constexpr int Width = 40;
constexpr int Height = 30;
constexpr int Pixels = Width * Height;
const PixelRegion Region{ 5, 3, 21, 17 };
const PixelRegion Whole{ 0, 0, Width, Height };

struct Formats
{
  const char* Name;
  GLenum Color;
  GLenum Depth;
};

struct Words
{
  std::vector<std::uint32_t> Colors;
  std::vector<std::uint32_t> Depths;
};

void PrintTo(const Formats& formats, std::ostream* os)
{
  *os << formats.Name;
}

std::uint32_t BitsOf(float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

float FloatOf(std::uint32_t bits)
{
  float value = 0.0f;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

bool IsIn(const PixelRegion& region, int pixel)
{
  const int x = pixel % Width - region.X;
  const int y = pixel / Width - region.Y;
  return x >= 0 && x < region.Width && y >= 0 && y < region.Height;
}

class SamplePixels : public testing::TestWithParam<Formats>
{
protected:
  SamplePixels() { this->Scene.Render(); }

  vtkOpenGLRenderWindow* Window() const
  {
    return vtkOpenGLRenderWindow::SafeDownCast(this->Scene.Window);
  }
  vtkOpenGLState* State() const { return this->Window()->GetState(); }

  // Makes the framebuffer and clears it.
  void MakeTarget()
  {
    ASSERT_EQ(this->Color.Allocate(GetParam().Color, Width, Height, 4), "");
    ASSERT_EQ(this->Depth.Allocate(GetParam().Depth, Width, Height, 4), "");
    vitrine::BindForDrawing(this->State(), this->Framebuffer.Handle());
    glFramebufferTexture2D(
      GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->Color.Target(), this->Color.Handle(), 0);
    const bool hasStencil =
      GetParam().Depth == GL_DEPTH24_STENCIL8 || GetParam().Depth == GL_DEPTH32F_STENCIL8;
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER,
      hasStencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, this->Depth.Target(),
      this->Depth.Handle(), 0);
    ASSERT_EQ(glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER), GLenum(GL_FRAMEBUFFER_COMPLETE));
    this->State()->vtkglDisable(GL_SCISSOR_TEST);
    this->State()->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    this->State()->vtkglDepthMask(GL_TRUE);
    const GLfloat none[4] = {};
    const GLfloat farthest = 1.0f;
    glClearBufferfv(GL_COLOR, 0, none);
    glClearBufferfv(GL_DEPTH, 0, &farthest);
  }

  // The framebuffer as a target of which a region is drawn.
  vitrine::RenderTarget TargetOf(const PixelRegion& region)
  {
    vitrine::BindForDrawing(this->State(), this->Framebuffer.Handle());
    this->State()->vtkglEnable(GL_SCISSOR_TEST);
    this->State()->vtkglScissor(region.X, region.Y, region.Width, region.Height);
    vitrine::RenderTarget target;
    EXPECT_EQ(target.Probe(this->Window(), {}), "");
    EXPECT_EQ(target.Samples, 4);
    return target;
  }

  std::vector<std::uint32_t> RandomColors(int words)
  {
    std::vector<std::uint32_t> colors(std::size_t(4) * Pixels * words);
    for (std::uint32_t& word : colors)
    {
      const auto bits = static_cast<std::uint32_t>(this->Random());
      const float color = GetParam().Color == GL_RGBA16 ? static_cast<float>(bits >> 16) / 65535.0f
                                                        : static_cast<float>(bits >> 21) / 1024.0f;
      word = words == 1 ? bits : BitsOf(color);
    }
    return colors;
  }

  std::vector<std::uint32_t> RandomDepths()
  {
    std::vector<std::uint32_t> depths;
    for (int i = 0; i < 4 * Pixels; ++i)
    {
      const int magnitude = static_cast<int>(this->Random() % 8);
      depths.push_back(
        BitsOf(std::ldexp(static_cast<float>(this->Random() >> 8), -24 - magnitude)));
    }
    return depths;
  }

  void Write(const vitrine::RenderTarget& target, const Words& words)
  {
    EXPECT_EQ(this->Samples.WriteColors(this->Window(), target, words.Colors), "");
    EXPECT_EQ(this->Samples.WriteDepths(this->Window(), target, words.Depths), "");
  }

  Words Read(const vitrine::RenderTarget& target)
  {
    Words words;
    EXPECT_EQ(this->Samples.ReadColors(this->Window(), target, words.Colors), "");
    EXPECT_EQ(this->Samples.ReadDepths(this->Window(), target, words.Depths), "");
    return words;
  }

  TestScene Scene = TestScene(8, 8);
  std::mt19937 Random{ 54 };
  vitrine::Image2D Color;
  vitrine::Image2D Depth;
  vitrine::Framebuffer Framebuffer;
  vitrine::SamplePixels Samples;
};

// What is written first may be rounded to the format. What is read of it is written again, into another region, too.
TEST_P(SamplePixels, SurviveAWayThereAndBack)
{
  const vitrine::ScopedTrackedState trackedState(this->State());
  const vitrine::ScopedVertexArray vertexArray(0);
  const vitrine::ScopedShaderProgram program(this->Window());
  this->MakeTarget();
  const vitrine::RenderTarget whole = this->TargetOf(Whole);
  const int words = vitrine::TargetPixels::ColorWords(whole);
  const Words written{ this->RandomColors(words), this->RandomDepths() };
  this->Write(whole, written);
  const Words before = this->Read(whole);
  ASSERT_EQ(before.Colors.size(), written.Colors.size());
  for (std::size_t i = 0; i < written.Colors.size(); ++i)
  {
    if (words == 1)
    {
      ASSERT_EQ(before.Colors[i], written.Colors[i]) << i;
    }
    else
    {
      ASSERT_NEAR(FloatOf(before.Colors[i]), FloatOf(written.Colors[i]), 1e-7) << i;
    }
  }
  ASSERT_EQ(before.Depths.size(), written.Depths.size());
  const double step = GetParam().Depth == GL_DEPTH_COMPONENT16 ? 8e-6 : 2.4e-7;
  for (std::size_t i = 0; i < written.Depths.size(); ++i)
  {
    ASSERT_NEAR(FloatOf(before.Depths[i]), FloatOf(written.Depths[i]), step) << i;
  }

  this->MakeTarget();
  this->Write(this->TargetOf(Region), before);
  const Words after = this->Read(whole);
  for (int i = 0; i < 4 * Pixels; ++i)
  {
    const bool isWritten = IsIn(Region, i % Pixels);
    ASSERT_EQ(after.Depths[i], isWritten ? before.Depths[i] : BitsOf(1.0f)) << i;
    for (int word = words * i; word < words * (i + 1); ++word)
    {
      ASSERT_EQ(after.Colors[word], isWritten ? before.Colors[word] : 0u) << i;
    }
  }
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

INSTANTIATE_TEST_SUITE_P(Formats, SamplePixels,
  testing::Values(Formats{ "Depth32", GL_RGBA8, GL_DEPTH_COMPONENT32 },
    Formats{ "Depth24", GL_RGBA8, GL_DEPTH_COMPONENT24 },
    Formats{ "Depth16", GL_RGBA8, GL_DEPTH_COMPONENT16 },
    Formats{ "Float", GL_RGBA32F, GL_DEPTH_COMPONENT32F },
    Formats{ "Stencil", GL_RGBA16F, GL_DEPTH24_STENCIL8 },
    Formats{ "FloatAndStencil", GL_RGBA16, GL_DEPTH32F_STENCIL8 },
    Formats{ "Encoded", GL_SRGB8_ALPHA8, GL_DEPTH_COMPONENT24 }),
  [](const auto& info) { return std::string(info.param.Name); });

}
