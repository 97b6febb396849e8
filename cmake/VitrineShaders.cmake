# vitrine_compose_shaders(OUT_SOURCES HEADER <file> FOLDERS <folder>... SHADERS <file.glsl>...)
#
# Compose each shader at build time (ComposeShader.cmake says how) into a C++ source that defines
# vitrine::shaders::<name without extension>, and list the sources in OUT_SOURCES. The header, which declares all of
# them, is written into the binary folder. Shaders and what they include are looked for in the folders, in order.
set(_vitrine_compose_script "${CMAKE_CURRENT_LIST_DIR}/ComposeShader.cmake")
set(_vitrine_literals_script "${CMAKE_CURRENT_LIST_DIR}/StringLiterals.cmake")

function (vitrine_compose_shaders out_sources)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "HEADER" "FOLDERS;SHADERS")
  set(patterns ${arg_FOLDERS})
  list(TRANSFORM patterns APPEND "/*.glsl")
  set(layouts ${arg_FOLDERS})
  list(TRANSFORM layouts APPEND "/*.h")
  file(GLOB includes CONFIGURE_DEPENDS ${patterns} ${layouts})

  set(sources "")
  set(declarations "")
  foreach (shader IN LISTS arg_SHADERS)
    get_filename_component(symbol "${shader}" NAME_WE)
    set(output "${CMAKE_CURRENT_BINARY_DIR}/Shaders/${symbol}.glsl.cxx")
    add_custom_command(
      OUTPUT "${output}"
      COMMAND "${CMAKE_COMMAND}"
        "-DINPUT=${shader}" "-DOUTPUT=${output}" "-DSYMBOL=${symbol}" "-DFOLDERS=${arg_FOLDERS}"
        -P "${_vitrine_compose_script}"
      DEPENDS "${_vitrine_compose_script}" "${_vitrine_literals_script}" ${includes}
      COMMENT "Composing ${shader}"
      VERBATIM)
    list(APPEND sources "${output}")
    string(APPEND declarations "extern const char* const ${symbol};\n")
  endforeach ()
  set(${out_sources} "${sources}" PARENT_SCOPE)

  string(MAKE_C_IDENTIFIER "VITRINE_${arg_HEADER}" guard)
  string(TOUPPER "${guard}" guard)
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${arg_HEADER}" CONTENT "\
// The text of the shaders, composed at build time. vitrine_compose_shaders() writes this file from the list of
// shaders in CMakeLists.txt.
#ifndef @guard@
#define @guard@

namespace vitrine
{
namespace shaders
{
@declarations@}
}
#endif
" @ONLY)
endfunction ()
