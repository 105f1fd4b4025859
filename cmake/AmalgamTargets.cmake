# How every target of the project is made: one static library a folder, one warning set for all.

set(AMALGAM_COMPILE_OPTIONS -Wall -Wextra -Wpedantic -Wconversion)
if(AMALGAM_WERROR)
  list(APPEND AMALGAM_COMPILE_OPTIONS -Werror)
endif()
# One product rounded once or twice must not depend on the compiler's mood: shading is compared with
# a second implementation, and "no virtual object" must give a difference of exactly 0.
list(APPEND AMALGAM_COMPILE_OPTIONS -ffp-contract=off)
if(AMALGAM_ARCH)
  list(APPEND AMALGAM_COMPILE_OPTIONS -march=${AMALGAM_ARCH})
endif()
if(AMALGAM_SANITIZE)
  # Instrumented code misleads GCC 12 about what is initialised in Boost.Beast.
  list(APPEND AMALGAM_COMPILE_OPTIONS -fsanitize=address,undefined -fno-omit-frame-pointer -g
       -Wno-maybe-uninitialized)
  add_link_options(-fsanitize=address,undefined)
endif()

# amalgam_library(NAME SOURCES a.cpp ... [PUBLIC libs ...] [PRIVATE libs ...])
function(amalgam_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR}/server ${PROJECT_SOURCE_DIR})
  target_compile_options(${name} PRIVATE ${AMALGAM_COMPILE_OPTIONS})
  target_link_libraries(${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
endfunction()

# amalgam_program(NAME SOURCES a.cpp ... LIBS libs ...)
function(amalgam_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_compile_options(${name} PRIVATE ${AMALGAM_COMPILE_OPTIONS})
  target_link_libraries(${name} PRIVATE ${ARG_LIBS})
  if(AMALGAM_ARCH)
    target_link_libraries(${name} PRIVATE amalgam_processor_check)
  endif()
endfunction()

# amalgam_test(NAME LABELS l ... SOURCES a_test.cpp ... LIBS libs ...): a GoogleTest program known to CTest.
# Tests run from the source folder; ../shared/data is found from there.
function(amalgam_test name)
  cmake_parse_arguments(ARG "" "" "LABELS;SOURCES;LIBS" ${ARGN})
  amalgam_program(${name} SOURCES ${ARG_SOURCES} LIBS ${ARG_LIBS} GTest::gmock GTest::gtest GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests ${PROJECT_SOURCE_DIR}/server)
  target_compile_definitions(${name} PRIVATE
    AMALGAM_SOURCE_DIR="${PROJECT_SOURCE_DIR}" AMALGAM_BINARY_DIR="${CMAKE_BINARY_DIR}")
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT 300)
endfunction()
