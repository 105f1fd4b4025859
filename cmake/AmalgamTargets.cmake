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
  list(APPEND AMALGAM_COMPILE_OPTIONS -fsanitize=${AMALGAM_SANITIZE} -fno-omit-frame-pointer -g
       $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  add_link_options(-fsanitize=${AMALGAM_SANITIZE})
endif()

# What nearly every source includes, compiled once: for libraries and programs, and with GoogleTest for tests. Sources
# include what they use all the same; -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON shows who forgot to.
set(AMALGAM_COMMON_HEADERS
  <algorithm> <array> <chrono> <cmath> <cstddef> <cstdint> <filesystem> <functional> <map> <memory> <numbers> <optional>
  <set> <span> <stdexcept> <string> <string_view> <utility> <variant> <vector>
  <glm/common.hpp> <glm/geometric.hpp> <glm/gtc/quaternion.hpp> <glm/mat4x4.hpp> <glm/matrix.hpp> <glm/vec2.hpp>
  <glm/vec3.hpp> <glm/vec4.hpp>)
function(amalgam_precompiled_headers name)
  cmake_parse_arguments(ARG "" "" "HEADERS;LIBS;OPTIONS" ${ARGN})
  file(WRITE ${PROJECT_BINARY_DIR}/precompiled/${name}.cpp "")
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/precompiled/${name}.cpp)
  target_compile_options(${name} PRIVATE ${AMALGAM_COMPILE_OPTIONS} ${ARG_OPTIONS})
  target_link_libraries(${name} PRIVATE amalgam_glm ${ARG_LIBS})
  target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
endfunction()

# Gives a target the headers of its own folder and of no other: a root in the build folder, in which they lie under the
# names that they are included by (trace/tile.h, common/pose.h, client/viewer.h). So whoever does not link a library
# cannot include it.
function(amalgam_own_headers name scope)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  string(REGEX REPLACE "^(server|protocol|tests)/" "" folder ${folder})
  set(root ${PROJECT_BINARY_DIR}/headers/${name})
  file(REMOVE_RECURSE ${root})
  file(MAKE_DIRECTORY ${root}/${folder})
  file(GLOB headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.h)
  foreach(header ${headers})
    get_filename_component(file ${header} NAME)
    file(CREATE_LINK ${header} ${root}/${folder}/${file} SYMBOLIC)
  endforeach()
  target_include_directories(${name} ${scope} ${root})
endfunction()

# amalgam_library(NAME SOURCES a.cpp ... [PUBLIC libs ...] [PRIVATE libs ...])
function(amalgam_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  amalgam_own_headers(${name} PUBLIC)
  target_precompile_headers(${name} REUSE_FROM amalgam_precompiled)
  target_compile_options(${name} PRIVATE ${AMALGAM_COMPILE_OPTIONS})
  target_link_libraries(${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} amalgam_glm)
endfunction()

# amalgam_header_library(NAME [libs ...]): a folder that holds only headers.
function(amalgam_header_library name)
  add_library(${name} INTERFACE)
  amalgam_own_headers(${name} INTERFACE)
  target_link_libraries(${name} INTERFACE ${ARGN})
endfunction()

# amalgam_program(NAME SOURCES a.cpp ... LIBS libs ...)
function(amalgam_program name)
  cmake_parse_arguments(ARG "" "PRECOMPILED" "SOURCES;LIBS" ${ARGN})
  if(NOT ARG_PRECOMPILED)
    set(ARG_PRECOMPILED amalgam_precompiled)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  amalgam_own_headers(${name} PRIVATE)
  target_precompile_headers(${name} REUSE_FROM ${ARG_PRECOMPILED})
  target_compile_options(${name} PRIVATE ${AMALGAM_COMPILE_OPTIONS})
  target_link_libraries(${name} PRIVATE ${ARG_LIBS} amalgam_glm)
  if(AMALGAM_ARCH)
    target_link_libraries(${name} PRIVATE amalgam_processor_check)
  endif()
endfunction()

# What tests spend their time on is in the libraries; the tests themselves only have to compile quickly. At -O1 GCC 12
# takes some additions of strings for writing beyond their end.
set(AMALGAM_TEST_OPTIONS $<$<CONFIG:Release>:-O1> -Wno-array-bounds)

# amalgam_test(NAME LABELS l ... SOURCES a_test.cpp ... LIBS libs ...): a GoogleTest program known to CTest.
# Tests run from the source folder; ../shared/data is found from there.
function(amalgam_test name)
  cmake_parse_arguments(ARG "" "" "LABELS;SOURCES;LIBS" ${ARGN})
  amalgam_program(${name} PRECOMPILED amalgam_precompiled_for_tests
    SOURCES ${ARG_SOURCES} LIBS ${ARG_LIBS} GTest::gmock GTest::gtest GTest::gtest_main)
  target_compile_options(${name} PRIVATE ${AMALGAM_TEST_OPTIONS})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE
    AMALGAM_SOURCE_DIR="${PROJECT_SOURCE_DIR}" AMALGAM_BINARY_DIR="${CMAKE_BINARY_DIR}")
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT 300)
endfunction()
