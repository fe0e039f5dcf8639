# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# One GoogleTest program per test_*.cpp. Each leaves the results of its cases in gtest_results/. The
# target `tests` builds all but the long ones. Those in the rooms of the program vfc use its sources.

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

# add_test_program(NAME SOURCE...): as many tests of ctest as sources, which share the cases.
function(add_test_program program)
  add_executable(${program} ${ARGN})
  target_link_libraries(${program} PRIVATE ${libraries})
  vfc_precompile(${program} Volume_filling_curves_precompiled_tests)
  list(LENGTH ARGN shards)
  if(shards GREATER 1)
    # Not all at once: two processors are to be kept busy, within the memory that there is.
    set_target_properties(${program} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 5)
  endif()
  foreach(shard RANGE 1 ${shards})
    set(name ${program}_${shard})
    if(shards EQUAL 1)
      set(name ${program})
    endif()
    math(EXPR index "${shard} - 1")
    add_test(NAME ${name} COMMAND ${program}
             --gtest_output=xml:${CMAKE_BINARY_DIR}/gtest_results/${name}.xml)
    set_tests_properties(${name} PROPERTIES TIMEOUT 600
      ENVIRONMENT "GTEST_TOTAL_SHARDS=${shards};GTEST_SHARD_INDEX=${index}")
  endforeach()
endfunction()

set(rooms_of_the_program meshes pictures repair)
file(GLOB rooms CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*)
foreach(folder IN LISTS rooms)
  get_filename_component(room ${folder} NAME)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/test_*.cpp)
  set(libraries Volume_filling_curves_test_settings)
  if(room IN_LIST rooms_of_the_program)
    if(NOT TARGET vfc_parts)
      continue()
    endif()
    list(APPEND libraries vfc_parts)
  endif()

  set(short_programs)
  set(together)
  foreach(source IN LISTS sources)
    get_filename_component(name ${source} NAME_WE)
    if(name MATCHES "^test_long_")
      add_test_program(${name} ${source})
      set_tests_properties(${name} PROPERTIES LABELS long TIMEOUT 1500)
    elseif(VFC_ROOMS_AT_ONCE)
      list(APPEND together ${source})
    else()
      add_test_program(${name} ${source})
      list(APPEND short_programs ${name})
    endif()
  endforeach()
  if(together)
    add_test_program(test_${room} ${together})
    list(APPEND short_programs test_${room})
  endif()
  if(short_programs)
    add_dependencies(tests ${short_programs})
  endif()
endforeach()
