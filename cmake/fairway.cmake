# SPDX-License-Identifier: Apache-2.0
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)  # the libraries go into the Python module, too
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

add_library(fairway_options INTERFACE)
target_compile_options(fairway_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wno-missing-field-initializers -Werror
  # g++ 12 raises these for plain strings and temporaries when it inlines them
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-maybe-uninitialized>
  -fno-semantic-interposition
  -ffp-contract=off)  # the same bits whether or not the machine has FMA

# What nearly every file includes, compiled once: it takes two thirds off the build.
set(fairway_common_headers <Eigen/Core> <Eigen/Geometry> <algorithm> <array> <cmath> <functional> <memory> <optional> <span>
                           <string> <string_view> <tuple> <variant> <vector>)

# fairway_precompile(target [header...]): the common headers, and with headers of its own those too
function(fairway_precompile target)
  if(ARGN OR target STREQUAL "fairway_core")
    target_precompile_headers(${target} PRIVATE ${fairway_common_headers} ${ARGN})
  else()
    target_precompile_headers(${target} REUSE_FROM fairway_core)
  endif()
endfunction()

# fairway_library(name [COLD] [USES lib...] [LINKS target...] [PRECOMPILES header...]): fairway/<name>/** as
# target fairway::<name>. COLD: outside the step, so built for a quick build rather than for speed.
function(fairway_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "COLD" "" "USES;LINKS;PRECOMPILES")
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/fairway/${name}/*.hpp)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/fairway/${name}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "(_test\\.cpp|/testing/)")
  list(TRANSFORM arg_USES PREPEND fairway::)
  if(sources)
    add_library(fairway_${name} STATIC ${sources} ${headers})
    target_include_directories(fairway_${name} PUBLIC ${PROJECT_SOURCE_DIR})
    target_link_libraries(fairway_${name} PUBLIC ${arg_USES} ${arg_LINKS} PRIVATE fairway_options)
    if(arg_COLD)
      target_compile_options(fairway_${name} PRIVATE $<$<CONFIG:Release>:-O2>)
      if(CMAKE_BUILD_TYPE STREQUAL "Release")  # other builds show a missing #include
        set_target_properties(fairway_${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 7)
      endif()
    endif()
    fairway_precompile(fairway_${name} ${arg_PRECOMPILES})
  else()
    add_library(fairway_${name} INTERFACE)
    target_include_directories(fairway_${name} INTERFACE ${PROJECT_SOURCE_DIR})
    target_link_libraries(fairway_${name} INTERFACE ${arg_USES} ${arg_LINKS})
  endif()
  add_library(fairway::${name} ALIAS fairway_${name})
endfunction()

# fairway_test(name USES lib... [SOURCES extra...]): every fairway/<name>/**_test.cpp in one program,
# discovered by ctest case by case
function(fairway_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES;SOURCES;LINKS")
  if(NOT FAIRWAY_TESTS)
    return()
  endif()
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/fairway/${name}/*_test.cpp)
  list(APPEND sources ${arg_SOURCES})
  if(NOT sources)
    return()
  endif()
  list(TRANSFORM arg_USES PREPEND fairway::)
  add_executable(${name}_test ${sources})
  target_link_libraries(${name}_test PRIVATE ${arg_USES} ${arg_LINKS} fairway_options GTest::gtest GTest::gmock GTest::gtest_main)
  target_compile_definitions(${name}_test PRIVATE FAIRWAY_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(TARGET fairway_first_test)
    target_precompile_headers(${name}_test REUSE_FROM core_test)
  else()
    add_library(fairway_first_test INTERFACE)
    target_precompile_headers(${name}_test PRIVATE ${fairway_common_headers} <gtest/gtest.h> <gmock/gmock.h>)
  endif()
  gtest_discover_tests(${name}_test WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} DISCOVERY_TIMEOUT 60)
endfunction()

# fairway_wants(option package): an optional part of the tree, AUTO, ON or OFF. <option>_ON says whether it is built;
# AUTO builds it where the package is installed, ON requires that. A macro: what find_package() sets is needed.
macro(fairway_wants option package)
  set(${option} AUTO CACHE STRING "AUTO, ON or OFF")
  set(${option}_ON FALSE)
  if(NOT ${option} STREQUAL "OFF")
    if(${option} STREQUAL "ON")
      find_package(${package} REQUIRED)
    else()
      find_package(${package} QUIET)
    endif()
    if(${package}_FOUND)
      set(${option}_ON TRUE)
    else()
      message(STATUS "${option}: not built, for ${package} is not installed")
    endif()
  endif()
endmacro()
