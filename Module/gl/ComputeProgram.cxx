#include "gl/ComputeProgram.h"

#include "Core/geometry/Rounding.h"
#include "gl/ProgramCache.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkSetGet.h"

#include <algorithm>

namespace vitrine
{

bool ComputeProgram::Use(vtkOpenGLRenderWindow* window, const std::vector<std::string>& defines)
{
  const std::string lines = DefineLines(defines);
  if (lines != this->Defines)
  {
    this->Release();
  }
  if (this->Name == 0 && !this->Failed)
  {
    this->Compile("#version 430 core\n" + lines + this->Source);
    this->Defines = lines; // Set even if it failed, so that it is not tried again.
  }
  window->GetShaderCache()->ReleaseCurrentShader();
  glUseProgram(this->Name);
  return !this->Failed;
}

void ComputeProgram::Compile(const std::string& text)
{
  const char* source = text.c_str();
  *this->Name.Address() = glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &source);
  GLint linked = GL_FALSE;
  glGetProgramiv(this->Name, GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE)
  {
    GLint length = 0;
    glGetProgramiv(this->Name, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length) + 1, '\0');
    glGetProgramInfoLog(this->Name, length, nullptr, log.data());
    vtkGenericWarningMacro("A compute shader does not compile: " << log.c_str() << "\n" << text);
    this->Release();
    this->Failed = true;
  }
}

int ComputeProgram::Location(const char* name)
{
  const auto [entry, isNew] = this->Locations.try_emplace(name, -1);
  if (isNew)
  {
    entry->second = glGetUniformLocation(this->Name, name);
  }
  return entry->second;
}

void ComputeProgram::Set(const char* name, int value)
{
  glUniform1i(this->Location(name), value);
}

void ComputeProgram::Set(const char* name, unsigned int value)
{
  glUniform1ui(this->Location(name), value);
}

void ComputeProgram::Set(const char* name, const int (&value)[2])
{
  glUniform2i(this->Location(name), value[0], value[1]);
}

void ComputeProgram::DispatchFor(std::int64_t count, int groupSize)
{
  constexpr std::int64_t most = 65535; // OpenGL guarantees so many groups along an axis.
  const std::int64_t groups = DividedUp<std::int64_t>(count, groupSize);
  const std::int64_t rows = DividedUp<std::int64_t>(groups, most);
  glDispatchCompute(static_cast<GLuint>(std::min(groups, most)),
    static_cast<GLuint>(std::max<std::int64_t>(rows, 1)), 1);
}

void ComputeProgram::Release()
{
  glDeleteProgram(this->Name);
  this->Name = ObjectName();
  this->Locations.clear();
  this->Defines.clear();
  this->Failed = false;
}

}
