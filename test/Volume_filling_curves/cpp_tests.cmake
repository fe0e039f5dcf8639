# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# One GoogleTest program per test_*.cpp. Each leaves the results of its cases in gtest_results/.

list(TRANSFORM places REPLACE "=(.*)$" "=\"\\1\"" OUTPUT_VARIABLE quoted_places)
add_library(Volume_filling_curves_test_settings INTERFACE)
target_compile_definitions(Volume_filling_curves_test_settings INTERFACE ${quoted_places})
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

file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/test_*.cpp)
foreach(source IN LISTS sources)
  get_filename_component(name ${source} NAME_WE)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE Volume_filling_curves_test_settings)
  vfc_precompile(${name} Volume_filling_curves_precompiled_tests)
  add_dependencies(tests ${name})
  add_test(NAME ${name} COMMAND ${name}
           --gtest_output=xml:${CMAKE_BINARY_DIR}/gtest_results/${name}.xml)
  set_tests_properties(${name} PROPERTIES TIMEOUT 600)
  if(name MATCHES "^test_long_")
    set_tests_properties(${name} PROPERTIES LABELS long TIMEOUT 1500)
  endif()
endforeach()
