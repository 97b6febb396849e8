# GoogleTest: the machine's own, or built from its sources where VTK has libstdc++'s old string ABI, and for another
# processor.
if (NOT CMAKE_CROSSCOMPILING AND (NOT DEFINED VITRINE_HAS_STRINGS_OF_VTK OR VITRINE_HAS_STRINGS_OF_VTK))
  find_package(GTest REQUIRED)
elseif (NOT TARGET GTest::gtest)
  add_subdirectory(/usr/src/googletest "${PROJECT_BINARY_DIR}/googletest" EXCLUDE_FROM_ALL)
endif ()
