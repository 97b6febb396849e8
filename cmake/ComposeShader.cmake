# Compose one GLSL file: replace each #include "file" by that file, once, with #line directives that keep
# the driver's messages pointing at the author's line, and encode the result as a C++ string.
#
#   cmake -DINPUT=x.glsl -DOUTPUT=x.glsl.cxx -DSYMBOL=x -DFOLDERS=Shaders -P ComposeShader.cmake
#
# Files are looked for in FOLDERS, in order.
#
# In `#line LINE STRING`, STRING numbers the files of one shader in the order of their inclusion; the
# legend at the head of the composed text says which is which. An unknown include is an error.
cmake_policy(SET CMP0007 NEW)
include("${CMAKE_CURRENT_LIST_DIR}/StringLiterals.cmake")

set(vitrine_files "")
set(vitrine_text "")

function (vitrine_compose file)
  list(FIND vitrine_files "${file}" known)
  if (NOT known EQUAL -1)
    return ()
  endif ()
  unset(path)
  foreach (folder IN LISTS FOLDERS)
    if (NOT DEFINED path AND EXISTS "${folder}/${file}")
      set(path "${folder}/${file}")
    endif ()
  endforeach ()
  if (NOT DEFINED path)
    message(FATAL_ERROR "${INPUT}: there is no file ${file} in ${FOLDERS}")
  endif ()
  list(LENGTH vitrine_files number)
  math(EXPR number "${number} + 1")
  list(APPEND vitrine_files "${file}")
  set(vitrine_files "${vitrine_files}" PARENT_SCOPE)

  file(READ "${path}" content)
  # Keep what CMake lists would eat.
  string(REPLACE "\\" "@BS@" content "${content}")
  string(REPLACE ";" "\\;" content "${content}")
  string(REPLACE "[" "@LB@" content "${content}")
  string(REPLACE "]" "@RB@" content "${content}")
  string(REPLACE "\n" ";" lines "${content}")
  set(text "${vitrine_text}#line 1 ${number}\n")
  set(line_number 0)
  set(skipped "")
  foreach (line IN LISTS lines)
    math(EXPR line_number "${line_number} + 1")
    if (line MATCHES "^ *#include \"([^\"]+)\"")
      set(vitrine_text "${text}")
      vitrine_compose("${CMAKE_MATCH_1}")
      math(EXPR next "${line_number} + 1")
      set(text "${vitrine_text}#line ${next} ${number}\n")
    elseif (line MATCHES "^(.*)@BS@ *$")
      # GLSL has no continued lines before 4.20, so they are joined. Empty lines keep the numbers of later ones.
      string(APPEND text "${CMAKE_MATCH_1}")
      string(APPEND skipped "\n")
    else ()
      string(APPEND text "${line}\n${skipped}")
      set(skipped "")
    endif ()
  endforeach ()
  set(vitrine_text "${text}" PARENT_SCOPE)
  set(vitrine_files "${vitrine_files}" PARENT_SCOPE)
endfunction ()

vitrine_compose("${INPUT}")

set(legend "// composed from:")
set(number 0)
foreach (file IN LISTS vitrine_files)
  math(EXPR number "${number} + 1")
  string(APPEND legend " ${number}=${file}")
endforeach ()
set(vitrine_text "${legend}\n${vitrine_text}")
string(REPLACE "@LB@" "[" vitrine_text "${vitrine_text}")
string(REPLACE "@RB@" "]" vitrine_text "${vitrine_text}")
string(REPLACE "\\;" ";" vitrine_text "${vitrine_text}")
string(REPLACE "@BS@" "\\" vitrine_text "${vitrine_text}")

vitrine_literals(literals "glsl" "${vitrine_text}")
file(WRITE "${OUTPUT}.new" "// Written by ComposeShader.cmake from ${INPUT}.
namespace vitrine
{
namespace shaders
{
extern const char* const ${SYMBOL};
const char* const ${SYMBOL} = ${literals};
}
}
")
execute_process(COMMAND "${CMAKE_COMMAND}" -E copy_if_different "${OUTPUT}.new" "${OUTPUT}")
file(REMOVE "${OUTPUT}.new")
