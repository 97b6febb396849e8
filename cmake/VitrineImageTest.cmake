# Tests that compare a picture with a baseline, to the last bit unless they say otherwise.
#
#   vitrine_add_image_test(
#     NAME name
#     COMMAND command argument...
#     BASELINE file.png...
#     [OUTPUT file.png] [TOLERANCE n] [SHARE s] [FLIP f])
#
# COMMAND draws the picture. {output} in its arguments is replaced by the name of the PNG file that it is to write. If
# it begins with an executable target that is defined already, the built program runs.
#
# BASELINE names the pictures of which it has to match one, relative to the current source folder. Several may stand
# beside each other, for drivers or versions of VTK that draw otherwise. Those that are not there are passed over, if
# one is there.
#
# OUTPUT is the name of the file, for commands that are not told it, relative to the current binary folder.
#
# TOLERANCE is the largest difference of any channel that counts as none, in steps of 1/255, from 0 to 255. The default
# is 0. SHARE is the share of the pixels, from 0 to 1, which may differ by more. The default is 0. FLIP is the largest
# mean of FLIP, from 0 to 1. The default is not to ask for it.
#
# A test that fails leaves the picture, the difference and a heat map of FLIP in image-tests/NAME of the current binary
# folder, or in the folder NAME of the environment variable VITRINE_TEST_OUTPUT, and prints their names and the first
# pixels. With VITRINE_UPDATE_BASELINES=1 in the environment, a test whose picture matches no baseline writes the first
# one instead, and passes. ON, YES, TRUE and Y mean the same as 1.
#
# The comparison is the program's: `vitrine diff --help`.

set(VITRINE_IMAGE_TEST_SCRIPT "${CMAKE_CURRENT_LIST_DIR}/VitrineImageTestRun.cmake")

function (vitrine_add_image_test)
  cmake_parse_arguments(PARSE_ARGV 0 test "" "NAME;OUTPUT;TOLERANCE;SHARE;FLIP" "COMMAND;BASELINE")
  foreach (required IN ITEMS NAME COMMAND BASELINE)
    if (NOT test_${required})
      message(FATAL_ERROR "vitrine_add_image_test: ${required} is missing")
    endif ()
  endforeach ()
  if (test_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "vitrine_add_image_test: ${test_NAME} has unknown arguments: ${test_UNPARSED_ARGUMENTS}")
  endif ()
  if (NOT TARGET Vitrine::program)
    message(FATAL_ERROR "vitrine_add_image_test: Vitrine was installed without its program, which compares pictures. "
      "Build it with VITRINE_BUILD_EXAMPLES on.")
  endif ()

  string(REGEX REPLACE "[^A-Za-z0-9._-]" "-" folder "${test_NAME}")
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/image-tests/${folder}")
  set(output "${folder}/picture.png")
  if (test_OUTPUT)
    get_filename_component(output "${test_OUTPUT}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_BINARY_DIR}")
  endif ()
  set(baselines)
  foreach (file IN LISTS test_BASELINE)
    get_filename_component(file "${file}" ABSOLUTE)
    list(APPEND baselines "${file}")
  endforeach ()
  set(options)
  foreach (option IN ITEMS TOLERANCE SHARE FLIP)
    if (DEFINED test_${option})
      string(TOLOWER "--${option}" name)
      list(APPEND options "${name}" "${test_${option}}")
    endif ()
  endforeach ()
  string(REPLACE "{output}" "${output}" command "${test_COMMAND}")
  list(POP_FRONT command program)
  if (TARGET "${program}")
    set(program "$<TARGET_FILE:${program}>")
  endif ()

  add_test(
    NAME "${test_NAME}"
    COMMAND "${CMAKE_COMMAND}"
      "-DNAME=${test_NAME}"
      "-DFOLDER=${folder}"
      "-DOUTPUT=${output}"
      "-DBASELINES=${baselines}"
      "-DOPTIONS=${options}"
      "-DPROGRAM=$<TARGET_FILE:Vitrine::program>"
      -P "${VITRINE_IMAGE_TEST_SCRIPT}" -- "${program}" ${command})
endfunction ()
