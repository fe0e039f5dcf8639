# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# The target fuzzers: one libFuzzer program per fuzz_*.cpp, run by scripts/fuzz.

if(NOT VFC_FUZZ)
  return()
endif()
if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  message(FATAL_ERROR "libFuzzer needs clang")
endif()

add_custom_target(fuzzers)
set(fuzzer_flags -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all)
file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/fuzz/fuzz_*.cpp)
foreach(source IN LISTS sources)
  get_filename_component(name ${source} NAME_WE)
  add_executable(${name} ${source})
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE Volume_filling_curves_development)
  target_compile_options(${name} PRIVATE ${fuzzer_flags})
  target_link_options(${name} PRIVATE ${fuzzer_flags})
  add_dependencies(fuzzers ${name})
endforeach()
