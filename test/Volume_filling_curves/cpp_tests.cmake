# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# One GoogleTest program per test_*.cpp, or one for all of them in a unity build. Each leaves the
# results of its cases in gtest_results/. Long cases, in suites Long_*, are tests of their own.

list(TRANSFORM places REPLACE "=(.*)$" "=\"\\1\"" OUTPUT_VARIABLE quoted_places)
add_library(Volume_filling_curves_test_settings INTERFACE)
target_compile_definitions(Volume_filling_curves_test_settings INTERFACE ${quoted_places})
target_include_directories(Volume_filling_curves_test_settings INTERFACE
  ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(Volume_filling_curves_test_settings INTERFACE
  Volume_filling_curves_development GTest::gtest_main)

# Only for its precompiled headers, which all tests share.
file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/precompiled.cpp CONTENT "")
add_library(Volume_filling_curves_precompiled_tests OBJECT
  ${CMAKE_CURRENT_BINARY_DIR}/precompiled.cpp)
target_link_libraries(Volume_filling_curves_precompiled_tests PRIVATE
  Volume_filling_curves_test_settings)
target_compile_options(Volume_filling_curves_precompiled_tests PRIVATE -fPIE)
vfc_precompile(Volume_filling_curves_precompiled_tests)
if(VFC_PRECOMPILE)
  target_precompile_headers(Volume_filling_curves_precompiled_tests PRIVATE <gtest/gtest.h>)
endif()

function(add_test_program program)
  add_executable(${program} ${ARGN})
  target_link_libraries(${program} PRIVATE Volume_filling_curves_test_settings)
  if(TARGET vfc_parts)
    target_link_libraries(${program} PRIVATE vfc_parts)
  endif()
  vfc_precompile(${program} Volume_filling_curves_precompiled_tests)
endfunction()

# add_test_cases(NAME PROGRAM FILTER SHARDS): SHARDS tests of ctest, which share the cases that the
# filter of GoogleTest selects.
function(add_test_cases tests program filter shards)
  foreach(shard RANGE 1 ${shards})
    set(name ${tests}_${shard})
    if(shards EQUAL 1)
      set(name ${tests})
    endif()
    math(EXPR index "${shard} - 1")
    add_test(NAME ${name} COMMAND ${program} --gtest_filter=${filter}
             --gtest_output=xml:${CMAKE_BINARY_DIR}/gtest_results/${name}.xml)
    set_tests_properties(${name} PROPERTIES TIMEOUT 600
      ENVIRONMENT "GTEST_TOTAL_SHARDS=${shards};GTEST_SHARD_INDEX=${index}")
    if(name MATCHES "^long_")
      set_tests_properties(${name} PROPERTIES LABELS long TIMEOUT 1500 COST 1000) # first of all
    endif()
  endforeach()
endfunction()

file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*/test_*.cpp)
if(NOT TARGET vfc_parts)
  list(FILTER sources EXCLUDE REGEX # modules of the program vfc
    "/(arc_files|film|formats|meshes|pictures|repair|resampling|symmetry)/")
endif()
if(VFC_UNITY_BUILD)
  # Two units of much the same size, by what the tests include: fill(), or meshes or domains without
  # untangle(), flows and certificates; or anything else. With clang++ and sanitizers they take 616 s
  # of the processor, four units 750, since those compile more templates twice, and one 587, but 8 GB
  # (10 GB with g++), and only one processor.
  foreach(source IN LISTS sources)
    file(STRINGS ${source} includes REGEX "^#include")
    set(unit untangle)
    if(includes MATCHES "/fill[.]h|fill_(round_)?test|shape_test" OR
       (includes MATCHES "mesh|domain|repair" AND
        NOT includes MATCHES "untangle|identify|flow|simplify_curves|certificate"))
      set(unit fill)
    endif()
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${unit})
  endforeach()
  add_test_program(unity_tests ${sources})
  set_target_properties(unity_tests PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  add_test_cases(unity_tests unity_tests -*Long_* 24)
  add_test_cases(long_unity_tests unity_tests *Long_* 8)
  add_dependencies(tests unity_tests)
else()
  foreach(source IN LISTS sources)
    get_filename_component(name ${source} NAME_WE)
    add_test_program(${name} ${source})
    file(STRINGS ${source} long_suites REGEX "^TEST.*[(]Long_")
    if(long_suites)
      add_test_cases(long_${name} ${name} *Long_* 1)
    endif()
    if(NOT name MATCHES "^test_long_")
      add_test_cases(${name} ${name} -*Long_* 1)
    endif()
    add_dependencies(tests ${name})
  endforeach()
endif()
