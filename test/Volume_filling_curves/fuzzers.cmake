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
set(fuzzer_flags -fsanitize=address,undefined -fno-sanitize-recover=all
  -fsanitize-ignorelist=${package_dir}/cmake/sanitizer_ignorelist.txt)

# The modules of the program that read curves and read and mend meshes, each compiled as one unit.
find_package(ZLIB REQUIRED)
set(program_dir ${package_dir}/demo/Volume_filling_curves)
add_library(fuzzed_parts STATIC EXCLUDE_FROM_ALL
  ${program_dir}/options/numbers.cpp ${program_dir}/reports/Defect.cpp)
foreach(module formats meshes repair)
  file(GLOB parts CONFIGURE_DEPENDS ${program_dir}/${module}/*.cpp)
  # Those that neither read nor mend a mesh, and those that need a session:
  list(FILTER parts EXCLUDE REGEX
       "/(mesh_to_text|vertex_values|obstacles|read_mended_mesh)[.]cpp$")
  set_source_files_properties(${parts} PROPERTIES UNITY_GROUP ${module})
  target_sources(fuzzed_parts PRIVATE ${parts})
endforeach()
set_target_properties(fuzzed_parts PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
target_include_directories(fuzzed_parts PUBLIC ${program_dir})
target_link_libraries(fuzzed_parts PUBLIC Volume_filling_curves_development ZLIB::ZLIB)
target_compile_options(fuzzed_parts PRIVATE -fsanitize=fuzzer-no-link ${fuzzer_flags})

file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/fuzz/fuzz_*.cpp)
foreach(source IN LISTS sources)
  get_filename_component(name ${source} NAME_WE)
  add_executable(${name} ${source})
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE Volume_filling_curves_development)
  target_compile_options(${name} PRIVATE -fsanitize=fuzzer ${fuzzer_flags})
  target_link_options(${name} PRIVATE -fsanitize=fuzzer ${fuzzer_flags})
  add_dependencies(fuzzers ${name})
endforeach()
target_link_libraries(fuzz_curve_reader PRIVATE fuzzed_parts)
target_link_libraries(fuzz_mesh_reader PRIVATE fuzzed_parts)
target_link_libraries(fuzz_repair PRIVATE fuzzed_parts)
