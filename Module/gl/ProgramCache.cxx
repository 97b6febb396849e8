#include "gl/ProgramCache.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

namespace vitrine
{

std::string DefineLines(const std::vector<std::string>& defines)
{
  std::string lines;
  for (const std::string& define : defines)
  {
    lines += "#define " + define + "\n";
  }
  return lines;
}

bool ProgramCache::Has(const std::string& name, const std::vector<std::string>& defines) const
{
  return this->Programs.count(name + "\n" + DefineLines(defines)) > 0;
}

vtkShaderProgram* ProgramCache::Ready(vtkOpenGLRenderWindow* window, const std::string& name,
  const std::vector<std::string>& defines, const char* vertex,
  const std::function<std::string()>& fragment)
{
  const std::string defineLines = DefineLines(defines);
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  const auto [entry, isNew] = this->Programs.try_emplace(name + "\n" + defineLines);
  vtkSmartPointer<vtkShaderProgram>& program = entry->second;
  if (!isNew)
  {
    return program ? cache->ReadyShaderProgram(program) : nullptr;
  }
  const std::string version = this->Version;
  program = cache->ReadyShaderProgram(
    (version + vertex).c_str(), (version + defineLines + fragment()).c_str(), "");
  this->Failed = this->Failed || !program;
  return program;
}

}
