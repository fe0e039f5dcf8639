# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# What makes results the same on every machine: a program that is compiled with and without Eigen's
# vectorization, for test_vectorization.py to compare, and the refusal of a machine that cannot do.

foreach(kind IN ITEMS vectorized scalar)
  add_executable(${kind}_flows ${CMAKE_CURRENT_SOURCE_DIR}/flow/flows_in_bits.cpp)
  target_link_libraries(${kind}_flows PRIVATE Volume_filling_curves_development)
  if(NOT VFC_SANITIZE) # by which the test has the label "once"
    add_dependencies(tests ${kind}_flows)
  endif()
  string(TOUPPER ${kind} name)
  list(APPEND places VFC_${name}_FLOWS=$<TARGET_FILE:${kind}_flows>)
endforeach()
target_compile_definitions(scalar_flows PRIVATE EIGEN_DONT_VECTORIZE)

# a compiler for WebAssembly is not at hand, but what it defines
set(refusal "define CGAL_ALWAYS_ROUND_TO_NEAREST")
set(compile_for_wasm ${CMAKE_CXX_COMPILER} -D__wasm__ -I${package_dir}/include -fsyntax-only -x c++)
set(license_header ${package_dir}/include/CGAL/license/Volume_filling_curves.h)
add_test(NAME wasm_is_refused COMMAND ${compile_for_wasm} ${license_header})
set_tests_properties(wasm_is_refused PROPERTIES PASS_REGULAR_EXPRESSION "${refusal}")
add_test(NAME wasm_that_rounds_to_nearest_is_not_refused
  COMMAND ${compile_for_wasm} -DCGAL_ALWAYS_ROUND_TO_NEAREST ${license_header})
set_tests_properties(wasm_that_rounds_to_nearest_is_not_refused PROPERTIES
  FAIL_REGULAR_EXPRESSION "${refusal}")
