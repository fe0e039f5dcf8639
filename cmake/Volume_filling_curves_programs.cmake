# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# vfc_add_programs(TARGET SOURCE...) adds a program for each source, NAME.cpp, and the target that
# builds them all.
#
# In a unity build they are one program, linked to under each name, and share the templates that they
# instantiate: the 28 examples take 120 s of one processor; programs of their own took 24, 28 and
# 49 s for three of them. Each source becomes a namespace, below everything that any of them
# includes. The target TARGET_alone therefore checks that each compiles by itself, too.

include_guard(GLOBAL)
include(${CMAKE_CURRENT_LIST_DIR}/Volume_filling_curves_development.cmake)

function(vfc_add_programs target)
  if(VFC_UNITY_BUILD)
    vfc_add_programs_in_one(${target} ${ARGN})
  else()
    vfc_add_programs_apart(${target} ${ARGN})
  endif()
endfunction()

function(vfc_add_programs_apart target)
  add_custom_target(${target})
  set(first)
  foreach(source IN LISTS ARGN)
    cmake_path(GET source STEM name)
    add_executable(${name} ${source})
    target_link_libraries(${name} PRIVATE Volume_filling_curves_development)
    vfc_precompile(${name} ${first})
    if(NOT first)
      set(first ${name})
    endif()
    add_dependencies(${target} ${name})
  endforeach()
endfunction()

function(vfc_add_programs_in_one target)
  foreach(source IN LISTS ARGN)
    cmake_path(GET source STEM name)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
    file(STRINGS ${source} lines REGEX "^#include")
    list(APPEND includes ${lines})
    string(APPEND definitions "namespace program_${name} {\n#include \"${source}\"\n}\n")
    string(APPEND calls
      "  if(name == \"${name}\") { return run(program_${name}::main, argc, argv); }\n")
  endforeach()
  list(REMOVE_DUPLICATES includes)
  list(JOIN includes "\n" includes)
  configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/programs_in_one.cpp.in ${target}.cpp @ONLY)

  add_executable(${target} EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/${target}.cpp)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(${target} PRIVATE Volume_filling_curves_development)
  foreach(source IN LISTS ARGN)
    cmake_path(GET source STEM name)
    set(link ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/${name})
    add_custom_command(TARGET ${target} POST_BUILD
      COMMAND ${CMAKE_COMMAND} -E create_symlink $<TARGET_FILE:${target}> ${link})
    add_executable(${name} IMPORTED GLOBAL)
    set_target_properties(${name} PROPERTIES IMPORTED_LOCATION ${link})
  endforeach()

  add_library(${target}_alone OBJECT EXCLUDE_FROM_ALL ${ARGN})
  set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -fsyntax-only)
  target_link_libraries(${target}_alone PRIVATE Volume_filling_curves_development)
  vfc_precompile(${target}_alone)
endfunction()
