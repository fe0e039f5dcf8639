# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# The target fuzzers: one libFuzzer program per fuzz_*.cpp, run by scripts/fuzz. They are linked to
# the modules of the program that the tests use, too: its repair of meshes alone takes minutes to
# compile with sanitizers.

if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang" OR NOT VFC_SANITIZE MATCHES "address"
   OR NOT TARGET vfc_parts)
  return() # libFuzzer is a part of clang
endif()

target_compile_options(vfc_parts PRIVATE -fsanitize=fuzzer-no-link)
add_custom_target(fuzzers)
file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/fuzz/fuzz_*.cpp)
foreach(source IN LISTS sources)
  get_filename_component(name ${source} NAME_WE)
  add_executable(${name} EXCLUDE_FROM_ALL ${source})
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE vfc_parts)
  target_compile_options(${name} PRIVATE -fsanitize=fuzzer)
  target_link_options(${name} PRIVATE -fsanitize=fuzzer)
  add_dependencies(fuzzers ${name})
endforeach()
