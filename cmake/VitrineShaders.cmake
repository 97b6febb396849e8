# vitrine_compose_shaders(OUT_SOURCES file.glsl ...)
#
# Compose each shader of Module/Shaders at build time (ComposeShader.cmake says how) into a C++ source
# that defines vitrine::shaders::<name without extension>, and list the sources in OUT_SOURCES.
set(_vitrine_compose_script "${CMAKE_CURRENT_LIST_DIR}/ComposeShader.cmake")
function (vitrine_compose_shaders out_sources)
  set(shader_dir "${CMAKE_CURRENT_SOURCE_DIR}/Shaders")
  file(GLOB includes CONFIGURE_DEPENDS "${shader_dir}/*.glsl" "${shader_dir}/*.h")
  set(sources "")
  foreach (shader IN LISTS ARGN)
    get_filename_component(symbol "${shader}" NAME_WE)
    set(output "${CMAKE_CURRENT_BINARY_DIR}/Shaders/${symbol}.glsl.cxx")
    add_custom_command(
      OUTPUT "${output}"
      COMMAND "${CMAKE_COMMAND}"
        "-DINPUT=${shader_dir}/${shader}" "-DOUTPUT=${output}"
        "-DSYMBOL=${symbol}" "-DINCLUDE_DIR=${shader_dir}"
        -P "${_vitrine_compose_script}"
      DEPENDS "${_vitrine_compose_script}" ${includes}
      COMMENT "Composing ${shader}"
      VERBATIM)
    list(APPEND sources "${output}")
  endforeach ()
  set(${out_sources} "${sources}" PARENT_SCOPE)
endfunction ()
