#include "report/Build.h"

#include "vtkSeeThroughPass.h"
#include "vtkVersion.h"

#include <dlfcn.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>

namespace program
{

namespace
{
/** The file that holds the code at an address; empty if none does. */
std::string FileOf(const void* address)
{
  Dl_info info;
  return dladdr(address, &info) != 0 ? info.dli_fname : "";
}

std::string HashOfFile(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  std::ostringstream hash;
  hash << std::hex << std::hash<std::string>()(bytes);
  return hash.str();
}
}

Json BuildJson()
{
  const auto codeOfLibrary = &vtkSeeThroughPass::New;
  static const Json build = { { "vtk", vtkVersion::GetVTKVersion() },
    { "program", HashOfFile("/proc/self/exe") },
    { "library", HashOfFile(FileOf(reinterpret_cast<const void*>(codeOfLibrary))) } };
  return build;
}

}
