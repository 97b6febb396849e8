# vitrine_embed_texts(OUT_SOURCES NAMESPACE file ...)
#
# Encode each file at build time (EmbedText.cmake says how) as a C++ source that defines
# NAMESPACE::<name without extension>, and list the sources in OUT_SOURCES.
set(_vitrine_embed_script "${CMAKE_CURRENT_LIST_DIR}/EmbedText.cmake")
set(_vitrine_literals_script "${CMAKE_CURRENT_LIST_DIR}/StringLiterals.cmake")
function (vitrine_embed_texts out_sources namespace)
  set(sources "")
  foreach (file IN LISTS ARGN)
    get_filename_component(name "${file}" NAME)
    get_filename_component(symbol "${file}" NAME_WE)
    set(output "${CMAKE_CURRENT_BINARY_DIR}/texts/${name}.cxx")
    add_custom_command(
      OUTPUT "${output}"
      COMMAND "${CMAKE_COMMAND}"
        "-DINPUT=${CMAKE_CURRENT_SOURCE_DIR}/${file}" "-DOUTPUT=${output}"
        "-DSYMBOL=${symbol}" "-DNAMESPACE=${namespace}"
        -P "${_vitrine_embed_script}"
      DEPENDS "${_vitrine_embed_script}" "${_vitrine_literals_script}" "${CMAKE_CURRENT_SOURCE_DIR}/${file}"
      COMMENT "Embedding ${name}"
      VERBATIM)
    list(APPEND sources "${output}")
  endforeach ()
  set(${out_sources} "${sources}" PARENT_SCOPE)
endfunction ()
