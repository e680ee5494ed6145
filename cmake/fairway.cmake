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

# fairway_library(name [COLD] [FACADE] [USES lib...] [LINKS target...] [PRECOMPILES header...]): declares fairway/<name>/**
# as target fairway::<name>; fairway_make_libraries() makes it. COLD: outside the step, so built for a quick build rather
# than for speed. FACADE: its headers are C++17 and show nothing of what it uses, so neither does its target.
function(fairway_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "COLD;FACADE" "" "USES;LINKS;PRECOMPILES")
  set(fairway_libraries ${fairway_libraries} ${name} PARENT_SCOPE)
  set(fairway_uses_${name} ${arg_USES} PARENT_SCOPE)
  set(fairway_links_${name} ${arg_LINKS} PARENT_SCOPE)
  set(fairway_precompiles_${name} ${arg_PRECOMPILES} PARENT_SCOPE)
  set(fairway_is_cold_${name} ${arg_COLD} PARENT_SCOPE)
  set(fairway_is_facade_${name} ${arg_FACADE} PARENT_SCOPE)
endfunction()

# fairway_make_libraries(): of what was declared, the libraries of FAIRWAY_COMPONENTS and all that they use. fairway_made
# comes back as their names.
function(fairway_make_libraries)
  set(wanted ${FAIRWAY_COMPONENTS})
  if(wanted STREQUAL "all")
    set(wanted ${fairway_libraries})
  endif()
  foreach(name IN LISTS wanted)
    if(NOT name IN_LIST fairway_libraries)
      string(REPLACE ";" ", " known "${fairway_libraries}")
      message(FATAL_ERROR "FAIRWAY_COMPONENTS: there is no library \"${name}\"; known: all, ${known}")
    endif()
  endforeach()
  fairway_closure(made "${fairway_libraries}" "${wanted}")
  foreach(name IN LISTS made)
    fairway_make_library(${name})
  endforeach()
  set(fairway_made ${made} PARENT_SCOPE)
endfunction()

function(fairway_make_library name)
  foreach(target IN LISTS fairway_links_${name})
    fairway_find(${target} missing)
    if(missing)
      message(FATAL_ERROR "fairway::${name} needs ${missing}, which was not found; "
                          "scripts/deps installs it, and FAIRWAY_COMPONENTS chooses fewer libraries")
    endif()
  endforeach()

  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/fairway/${name}/*.hpp)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/fairway/${name}/*.cpp)
  list(FILTER headers EXCLUDE REGEX "/testing/")
  list(FILTER sources EXCLUDE REGEX "(_test\\.cpp|/testing/)")
  set(uses ${fairway_uses_${name}})
  list(TRANSFORM uses PREPEND fairway::)
  list(APPEND uses ${fairway_links_${name}})
  set(seen PUBLIC)
  if(fairway_is_facade_${name})
    set(seen PRIVATE)
  endif()
  if(sources)
    add_library(fairway_${name} STATIC ${sources})
    target_sources(fairway_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${headers})
    target_link_libraries(fairway_${name} ${seen} ${uses} PRIVATE $<BUILD_INTERFACE:fairway_options>)
    target_compile_features(fairway_${name} ${seen} cxx_std_20)
    if(fairway_is_facade_${name})
      target_compile_features(fairway_${name} INTERFACE cxx_std_17)
    endif()
    if(fairway_is_cold_${name})
      target_compile_options(fairway_${name} PRIVATE $<$<CONFIG:Release>:-O2>)
      if(CMAKE_BUILD_TYPE STREQUAL "Release")  # other builds show a missing #include
        set_target_properties(fairway_${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 7)
      endif()
    endif()
    fairway_precompile(fairway_${name} ${fairway_precompiles_${name}})
  else()
    add_library(fairway_${name} INTERFACE)
    target_sources(fairway_${name} INTERFACE FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${headers})
    target_link_libraries(fairway_${name} INTERFACE ${uses})
    target_compile_features(fairway_${name} INTERFACE cxx_std_20)
  endif()
  set_target_properties(fairway_${name} PROPERTIES EXPORT_NAME ${name})
  add_library(fairway::${name} ALIAS fairway_${name})
endfunction()

# fairway_test(name USES lib... [SOURCES extra...]): every fairway/<name>/**_test.cpp in one program,
# discovered by ctest case by case; nothing where one of the libraries was not chosen
function(fairway_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES;SOURCES;LINKS")
  if(NOT FAIRWAY_TESTS)
    return()
  endif()
  foreach(library IN LISTS arg_USES)
    if(NOT TARGET fairway::${library})
      return()
    endif()
  endforeach()
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
