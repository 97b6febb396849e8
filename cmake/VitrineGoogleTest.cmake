# GoogleTest: the machine's own, or built from its sources where VTK has libstdc++'s old string ABI, and for another
# processor.
if (NOT CMAKE_CROSSCOMPILING AND (NOT DEFINED VITRINE_HAS_STRINGS_OF_VTK OR VITRINE_HAS_STRINGS_OF_VTK))
  find_package(GTest REQUIRED)
elseif (NOT TARGET GTest::gtest)
  add_subdirectory(/usr/src/googletest "${PROJECT_BINARY_DIR}/googletest" EXCLUDE_FROM_ALL)
endif ()
include(GoogleTest)

# Give CTest each test of a program. A program is asked for its tests when CTest starts, which may be while other tests
# and builds load the machine: its libraries are then read from the disk for longer than the 5 s of CMake's default.
function (vitrine_discover_tests target label)
  gtest_discover_tests(${target} ${ARGN}
    DISCOVERY_MODE PRE_TEST
    DISCOVERY_TIMEOUT 120
    PROPERTIES LABELS ${label})
endfunction ()
