# Use the string ABI of libstdc++ that VTK's libraries were built with: PyPI's wheels have the old one.
include(CheckCXXSourceCompiles)

# Cached per VTK, as another VTK may have the other one.
string(MAKE_C_IDENTIFIER "${VTK_DIR}" vitrine_vtk)
function (vitrine_check_strings result)
  set(CMAKE_REQUIRED_LIBRARIES VTK::vtksys)
  check_cxx_source_compiles(
    "#include <vtksys/SystemTools.hxx>
     int main() { return vtksys::SystemTools::GetCurrentWorkingDirectory().empty() ? 1 : 0; }"
    ${result})
endfunction ()

vitrine_check_strings(VITRINE_HAS_STRINGS_OF_${vitrine_vtk})
set(VITRINE_HAS_STRINGS_OF_VTK "${VITRINE_HAS_STRINGS_OF_${vitrine_vtk}}")
if (NOT VITRINE_HAS_STRINGS_OF_VTK)
  set(CMAKE_REQUIRED_DEFINITIONS -D_GLIBCXX_USE_CXX11_ABI=0)
  vitrine_check_strings(VITRINE_HAS_OLD_STRINGS_OF_${vitrine_vtk})
  unset(CMAKE_REQUIRED_DEFINITIONS)
  if (NOT VITRINE_HAS_OLD_STRINGS_OF_${vitrine_vtk})
    message(FATAL_ERROR "No program links with the VTK of ${VTK_DIR}, with either string ABI of libstdc++. "
      "CMake's log of configuring says why.")
  endif ()
  add_compile_definitions(_GLIBCXX_USE_CXX11_ABI=0)
endif ()
