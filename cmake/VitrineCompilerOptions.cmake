# Warnings and sanitizers for every target of the stand-alone build.
if (MSVC) # not tried yet (docs/develop/portability.md)
  add_compile_options(/utf-8 /permissive- /Zc:__cplusplus /bigobj)
  add_compile_definitions(NOMINMAX)
else ()
  add_compile_options(-Wall -Wextra)
endif ()
# Lanes are never handed over between functions that are not inlined (Core/geometry/Lanes.h).
add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang>:-Wno-psabi>)
if (VITRINE_SANITIZE)
  # What the address sanitizer finds as well would take a fifth of the time to compile.
  add_compile_options(-fsanitize=${VITRINE_SANITIZE} -fno-sanitize=null,object-size,vptr -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${VITRINE_SANITIZE})
endif ()

# Compile through ccache where there is one.
find_program(VITRINE_CCACHE ccache)
mark_as_advanced(VITRINE_CCACHE)
if (VITRINE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_C_COMPILER_LAUNCHER "${VITRINE_CCACHE}")
  set(CMAKE_CXX_COMPILER_LAUNCHER "${VITRINE_CCACHE}")
endif ()

# For what takes more time to be compiled than it ever runs: tests, and the program, whose work is done by Core and VTK.
set(VITRINE_QUICK_COMPILE "$<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU,Clang,AppleClang>>:-O1>")

# Where CMAKE_UNITY_BUILD is on, the sources of each folder are compiled as one: headers are read once for all of them,
# and functions of a folder are inlined into each other. With TOP, folders within a folder are one with it.
function (vitrine_unite_folders target)
  cmake_parse_arguments(PARSE_ARGV 1 option "TOP" "" "")
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach (source IN LISTS sources)
    get_filename_component(folder "${source}" DIRECTORY)
    if (folder AND NOT IS_ABSOLUTE "${folder}")
      if (option_TOP)
        string(REGEX REPLACE "/.*" "" folder "${folder}")
      endif ()
      string(REPLACE "/" "_" folder "${folder}")
      set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${folder}")
    endif ()
  endforeach ()
endfunction ()
