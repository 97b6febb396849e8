# GoogleTest: the machine's own, or built from its sources where VTK has libstdc++'s old string ABI, and for another
# processor.
if (NOT CMAKE_CROSSCOMPILING AND (NOT DEFINED VITRINE_HAS_STRINGS_OF_VTK OR VITRINE_HAS_STRINGS_OF_VTK))
  find_package(GTest REQUIRED)
elseif (NOT TARGET GTest::gtest)
  add_subdirectory(/usr/src/googletest "${PROJECT_BINARY_DIR}/googletest" EXCLUDE_FROM_ALL)
endif ()

# Add a test of CTest for each file of a program's tests: Prefix.Name for TestName.cxx. Processes for each test would
# start for longer than most tests run.
function (vitrine_add_file_tests target prefix label)
  get_target_property(files ${target} SOURCES)
  get_target_property(folder ${target} SOURCE_DIR)
  list(FILTER files INCLUDE REGEX "^Test.*\\.cxx$")
  foreach (file IN LISTS files)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${folder}/${file}")
    file(STRINGS "${folder}/${file}" tests REGEX "^TEST(_F|_P)?\\(")
    if (tests)
      list(TRANSFORM tests REPLACE "^[^(]+\\(([^,]+),.*" "\\1.*:*/\\1.*")
      list(REMOVE_DUPLICATES tests)
      list(JOIN tests ":" filter)
      get_filename_component(name "${file}" NAME_WE)
      string(REGEX REPLACE "^Test" "${prefix}." name "${name}")
      add_test(NAME ${name} COMMAND ${target} --gtest_brief=1 "--gtest_filter=${filter}")
      set_tests_properties(${name} PROPERTIES LABELS ${label} TIMEOUT 600)
    endif ()
  endforeach ()
endfunction ()
