// Devices that cannot draw caps: parts are cut all the same, the reason is said once, and caps come when they can.
#include "SectionScene.h"
#include "TestMessages.h"
#include "TestRefusedTexts.h"
#include "gl/VitrineOpenGL.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureUnitManager.h"

#include <gtest/gtest.h>

namespace
{

/** Expects open cuts in all frames, and one warning with the reason. Frames may have messages of OpenGL besides. */
void ExpectOpenCuts(SectionScene& scene, const std::string& reason, const char* besides = nullptr)
{
  int warnings = 0;
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_TRUE(Matches(scene.Render(), SectionScene::Open()));
    EXPECT_NE(std::string(scene.Section->GetFallbackReason()).find(reason), std::string::npos)
      << scene.Section->GetFallbackReason();
    for (const std::string& message : TakeMessages())
    {
      const bool isWarning = message.find("Caps cannot be drawn: ") != std::string::npos;
      warnings += isWarning ? 1 : 0;
      EXPECT_NE(message.find(isWarning ? reason.c_str()
                    : besides          ? besides
                                       : reason.c_str()),
        std::string::npos)
        << message;
    }
  }
  EXPECT_EQ(warnings, 1);
}

void ExpectCapsAgain(SectionScene& scene)
{
  EXPECT_TRUE(Matches(scene.Render(), SectionScene::Capped()));
  EXPECT_STREQ(scene.Section->GetFallbackReason(), "");
}

TEST(SectionFailures, OfTextureUnits)
{
  SectionScene scene;
  scene.RenderWhole();
  vtkTextureUnitManager* const units =
    vtkOpenGLRenderWindow::SafeDownCast(scene.Window)->GetState()->GetTextureUnitManager();
  std::vector<int> taken;
  for (int unit = units->Allocate(); unit >= 0; unit = units->Allocate())
  {
    taken.push_back(unit);
  }
  ExpectOpenCuts(scene, "no texture unit is free for caps");
  for (std::size_t free = 1; free < 3; ++free) // caps take three
  {
    units->Free(taken.back());
    taken.pop_back();
    EXPECT_TRUE(Matches(scene.Render(), SectionScene::Open()));
  }
  for (const int unit : taken)
  {
    units->Free(unit);
  }
  ExpectCapsAgain(scene);
}

TEST(SectionFailures, OfFramebuffers)
{
  SectionScene scene;
  scene.RenderWhole();
  static decltype(glCheckFramebufferStatus) driver;
  driver = glCheckFramebufferStatus;
  glCheckFramebufferStatus = [](GLenum target) -> GLenum
  {
    GLint type = GL_NONE;
    glGetFramebufferAttachmentParameteriv(
      target, GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
    return type == GL_UNSIGNED_INT ? GL_FRAMEBUFFER_UNSUPPORTED : driver(target);
  };
  ExpectOpenCuts(scene, "the driver cannot draw into an image of cut parts");
  glCheckFramebufferStatus = driver;
  ExpectCapsAgain(scene);
}

TEST(SectionFailures, OfShaders)
{
  SectionScene scene;
  scene.RenderWhole();
  {
    const RefusedTexts refused({ "vitrineToClip" });
    ExpectOpenCuts(scene, "the driver cannot compile a shader of the method", "");
  }
  scene.Window->Finalize(); // a new context, of another driver
  ExpectCapsAgain(scene);
}

TEST(SectionFailures, OfMemory)
{
  SectionScene scene;
  scene.RenderWhole();
  static decltype(glBufferData) driver;
  driver = glBufferData;
  glBufferData = [](GLenum target, GLsizeiptr size, const void* data, GLenum usage)
  { driver(target, target == GL_COPY_WRITE_BUFFER ? GLsizeiptr(1) << 50 : size, data, usage); };
  ExpectOpenCuts(scene, "the driver has no memory for", "OUT_OF_MEMORY");
  glBufferData = driver;
  ExpectCapsAgain(scene);
}

}
