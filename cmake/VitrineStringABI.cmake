# Use the string ABI of libstdc++ that VTK's libraries were built with: PyPI's wheels have the old one.
include(CheckCXXSourceCompiles)
set(CMAKE_REQUIRED_LIBRARIES VTK::vtksys)
check_cxx_source_compiles(
  "#include <vtksys/SystemTools.hxx>
   int main() { return vtksys::SystemTools::GetCurrentWorkingDirectory().empty() ? 1 : 0; }"
  VITRINE_HAS_STRINGS_OF_VTK)
unset(CMAKE_REQUIRED_LIBRARIES)
if (NOT VITRINE_HAS_STRINGS_OF_VTK)
  add_compile_definitions(_GLIBCXX_USE_CXX11_ABI=0)
endif ()
