# What a test of vitrine_add_image_test() runs: the command after `--`, which draws OUTPUT, and then `vitrine diff`.
cmake_minimum_required(VERSION 3.18)

# A list would cut arguments at semicolons, so the command is put together as code.
set(command)
set(is_command FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach (i RANGE ${last})
  if (is_command)
    string(APPEND command " [==[${CMAKE_ARGV${i}}]==]")
  elseif (CMAKE_ARGV${i} STREQUAL "--")
    set(is_command TRUE)
  endif ()
endforeach ()

file(REMOVE_RECURSE "${FOLDER}")
file(REMOVE "${OUTPUT}")
get_filename_component(output_folder "${OUTPUT}" DIRECTORY)
file(MAKE_DIRECTORY "${FOLDER}" "${output_folder}")
cmake_language(EVAL CODE "execute_process(COMMAND ${command} RESULT_VARIABLE result)")
if (NOT result EQUAL 0)
  message(FATAL_ERROR "${NAME}: the command that draws the picture failed: ${result}")
endif ()
if (NOT EXISTS "${OUTPUT}")
  message(FATAL_ERROR "${NAME}: the command has not written ${OUTPUT}")
endif ()

if (DEFINED ENV{VITRINE_TEST_OUTPUT})
  get_filename_component(name "${FOLDER}" NAME)
  set(FOLDER "$ENV{VITRINE_TEST_OUTPUT}/${name}")
  file(MAKE_DIRECTORY "${FOLDER}")
  file(COPY "${OUTPUT}" DESTINATION "${FOLDER}")
endif ()
if ("$ENV{VITRINE_UPDATE_BASELINES}")
  list(APPEND OPTIONS --update)
endif ()
execute_process(
  COMMAND "${PROGRAM}" diff "${OUTPUT}" ${BASELINES} ${OPTIONS} --out "${FOLDER}"
  RESULT_VARIABLE result)
if (NOT result EQUAL 0)
  message(FATAL_ERROR "${NAME}: ${OUTPUT} matches no baseline. "
    "To make it one, run this test again with VITRINE_UPDATE_BASELINES=1 in the environment.")
endif ()
