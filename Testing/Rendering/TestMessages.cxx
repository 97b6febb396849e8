#include "TestMessages.h"

#include "gl/VitrineOpenGL.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkRenderWindow.h"

#include <gtest/gtest.h>

#include <utility>

namespace
{

std::vector<std::string> Messages;

class MessageWindow : public vtkOutputWindow
{
public:
  static MessageWindow* New();
  vtkTypeMacro(MessageWindow, vtkOutputWindow);
  void DisplayText(const char* text) override { Messages.emplace_back(text); }
  void DisplayDebugText(const char*) override {}
};
vtkStandardNewMacro(MessageWindow);

class MessageChecks : public testing::EmptyTestEventListener
{
  void OnTestStart(const testing::TestInfo&) override { Messages.clear(); }
  void OnTestEnd(const testing::TestInfo&) override
  {
    for (const std::string& message : TakeMessages())
    {
      ADD_FAILURE() << message;
    }
  }
};

void KeepOpenGLMessage(
  GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* text, const void*)
{
  if (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR)
  {
    Messages.push_back(std::string("OpenGL: ") + text);
  }
}

}

void InstallMessageChecks()
{
  vtkNew<MessageWindow> messages;
  vtkOutputWindow::SetInstance(messages);
  testing::UnitTest::GetInstance()->listeners().Append(new MessageChecks);
}

void WatchOpenGL(vtkRenderWindow* window)
{
  vtkHeadlessRenderWindow::SafeDownCast(window)->Initialize();
  if (glDebugMessageCallback)
  {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(KeepOpenGLMessage, nullptr);
  }
}

std::vector<std::string> TakeMessages()
{
  return std::exchange(Messages, {});
}
